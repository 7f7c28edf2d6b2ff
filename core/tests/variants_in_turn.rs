//! One variant after another, with the values of the one before: what is written holds only what the new one knows, and
//! what has to be filled in is a field of the form that is marked.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::app::{CycleInfo, FormRequest, FormView, ReadRequest, VariantInfo, catalogue, form, read};
use probewright_core::diagnostic::Severity;
use probewright_core::entry::{ProbeUse, Typed};

/// The form of a cycle with these values.
fn form_of(cycle: &CycleInfo, values: &Typed) -> FormView {
    let asked = serde_json::json!({ "control": cycle.control, "cycle": cycle.cycle, "values": values });
    form(serde_json::from_value::<FormRequest>(asked).unwrap()).unwrap()
}

/// Pairs of different variants: each is the former of several others, and the new one after several others.
fn pairs(all: &[VariantInfo]) -> impl Iterator<Item = (&VariantInfo, &VariantInfo)> {
    let distances = (1..all.len()).step_by((all.len() / 6).max(1));
    distances.flat_map(move |far| (0..all.len()).map(move |at| (&all[at], &all[(at + far) % all.len()])))
}

/// The worked measurement of the former variant, as the new one.
fn carried(before: &VariantInfo, after: &VariantInfo) -> Typed {
    let mut values = before.usual.example.clone();
    values.extend(after.usual.values.clone());
    values
}

// oracle: self, over all cycles
#[test]
fn what_has_to_be_filled_in_is_a_marked_field() {
    for cycle in &catalogue().cycles {
        for (before, after) in pairs(&cycle.variants) {
            let view = form_of(cycle, &carried(before, after));
            for error in view.diagnostics.iter().filter(|one| one.severity == Severity::Error) {
                let field = view.fields.iter().find(|field| Some(field.name) == error.param);
                let marked = field.is_some_and(|field| field.required || !field.value.is_empty());
                let what = (cycle.cycle, before.mvar, after.mvar);
                assert!(marked, "{what:?}: {} at {:?}", error.message.key, error.param);
            }
        }
    }
}

// oracle: self, over all cycles but those of the log, whose user data are for the log as a whole
#[test]
fn what_is_written_the_new_variant_knows() {
    for cycle in catalogue().cycles.iter().filter(|cycle| cycle.purpose.probe != ProbeUse::Log) {
        for (before, after) in pairs(&cycle.variants) {
            let view = form_of(cycle, &carried(before, after));
            let text = view.snippet.clone();
            let back = read(ReadRequest { control: cycle.control, text, setup: None }, &mut |_| {}).unwrap();
            let [call] = &back.calls[..] else { panic!("{} {}: {}", cycle.cycle, after.mvar, view.snippet) };
            for name in call.values.keys() {
                let known = view.fields.iter().any(|field| field.name == name.as_str());
                assert!(known, "{} {} -> {}: {name} in {}", cycle.cycle, before.mvar, after.mvar, view.snippet);
            }
        }
    }
}
