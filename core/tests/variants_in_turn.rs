//! One variant after another, with the values of the one before: what is written holds only what the new one knows, and
//! what has to be filled in is a field of the form that is marked.
#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::app::{
    ChangeRequest, Changed, CycleInfo, Edit, FormRequest, FormView, ReadRequest, VariantInfo, catalogue, change, form,
    read,
};
use probewright_core::catalogue::find;
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Inputs, Typed};
use std::collections::BTreeMap;

/// The form of a cycle with these values.
fn form_of(cycle: &CycleInfo, values: &Typed) -> FormView {
    let asked = serde_json::json!({ "control": cycle.control, "cycle": cycle.cycle, "values": values });
    form(serde_json::from_value::<FormRequest>(asked).unwrap()).unwrap()
}

/// Pairs of different variants: each is the former of several others, and the new one after several others.
fn pairs(all: &[VariantInfo]) -> impl Iterator<Item = (&VariantInfo, &VariantInfo)> {
    apart(all, 6)
}

/// Pairs of different variants that are so many numbers apart in the list: all where there are no more.
fn apart(all: &[VariantInfo], distances: usize) -> impl Iterator<Item = (&VariantInfo, &VariantInfo)> {
    let distances = (1..all.len()).step_by((all.len() / distances).max(1));
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

// oracle: self, over all cycles
#[test]
fn what_is_written_the_new_variant_knows() {
    for cycle in &catalogue().cycles {
        for (before, after) in pairs(&cycle.variants) {
            let view = form_of(cycle, &carried(before, after));
            let text = view.snippet.clone();
            let back =
                read(ReadRequest { control: cycle.control, text: text.into(), setup: None, with: None }, &mut |_| {})
                    .unwrap();
            let [call] = &back.calls[..] else { panic!("{} {}: {}", cycle.cycle, after.mvar, view.snippet) };
            for name in call.values.keys() {
                let known = view.fields.iter().any(|field| field.name == name.as_str());
                assert!(known, "{} {} -> {}: {name} in {}", cycle.cycle, before.mvar, after.mvar, view.snippet);
            }
        }
    }
}

/// The call of a variant with a value in each field, among comments, other words and lines that nobody reads.
fn program_of(cycle: &CycleInfo, variant: &VariantInfo) -> String {
    let mut values = variant.usual.example.clone();
    for field in form_of(cycle, &values).fields {
        values.entry(field.name.to_string()).or_insert("1".to_owned());
    }
    let snippet = form_of(cycle, &values).snippet;
    let lines = snippet.lines().flat_map(|line| [line.to_owned(), "; measured by the night shift  ".to_owned()]);
    let lines: Vec<String> = lines.collect();
    format!("%_N_PART_MPF\r\n{FOREIGN}\n{}\n{FOREIGN}\n", lines.join("\n"))
}

/// Nothing of a call.
const FOREIGN: &str = "G0 X100 ; _SETVAL=7\r\n\u{6d4b}\u{91cf} ~ ? §\nMSG(\"_FA=3\")";

fn read_back(cycle: &CycleInfo, text: &str) -> Typed {
    let asked = ReadRequest { control: cycle.control, text: text.into(), setup: None, with: None };
    let back = read(asked, &mut |_| {}).unwrap();
    let [call] = &back.calls[..] else { panic!("{}: {text}", cycle.cycle) };
    call.values.clone()
}

/// The lines of a text that belong to no call, and the comments, each as it is.
fn foreign(text: &str) -> Vec<&str> {
    let lines = text.split_inclusive('\n');
    let own = |line: &str| line.find("; measured").and_then(|at| line.get(at..)).map(str::len);
    let kept = lines.filter_map(|line| match own(line) {
        Some(length) => line.get(line.len() - length..),
        None => FOREIGN.contains(line.trim_end()).then_some(line),
    });
    kept.collect()
}

// oracle: self, over all pairs of variants of all cycles that a number chooses
#[test]
fn a_call_that_becomes_another_variant_keeps_only_what_that_knows() {
    let mut pairs = 0;
    for cycle in catalogue().cycles.iter().filter(|cycle| cycle.control == Dialect::Sinumerik) {
        let entry = find(cycle.control, cycle.cycle).unwrap();
        let texts: BTreeMap<i64, String> =
            cycle.variants.iter().map(|one| (one.mvar, program_of(cycle, one))).collect();
        for (before, after) in apart(&cycle.variants, 10) {
            let Some((name, value)) = chosen_by(before, after) else { continue };
            let text = &texts[&before.mvar];
            let (revised, done) = revised(cycle, text, name, value);
            let what = (cycle.cycle, before.mvar, after.mvar, text, &revised);
            assert_eq!(foreign(&revised), foreign(text), "{what:?}");
            let values = read_back(cycle, &revised);
            let view = form_of(cycle, &values);
            assert_eq!(view.mvar, Some(after.mvar), "{what:?}");
            for name in values.keys() {
                let shown = view.fields.iter().any(|field| field.name == name.as_str());
                // the core's own machine has one tool in use; with another one the variant may ask for more
                let with_other_tool = || entry.param(name).unwrap().is_known(&Inputs::new(entry, after.mvar));
                assert!(shown || with_other_tool(), "{name} {what:?}");
            }
            assert_eq!(done.reaches, !done.taken.is_empty(), "{what:?}");
            pairs += 1;
        }
    }
    assert!(pairs > 1000, "{pairs}");
}

/// The text with a value of its call changed.
fn revised(cycle: &CycleInfo, text: &str, name: &str, value: &str) -> (String, Changed) {
    let text = text.to_owned();
    let done = change(ChangeRequest::new(cycle.control, text.clone(), 0, name, value)).unwrap();
    (done.steps.iter().fold(text, |text, edits| edited(&text, edits)), done)
}

/// The value of the parameter that makes one variant of another; none: it takes more than one.
fn chosen_by<'a>(before: &'a VariantInfo, after: &'a VariantInfo) -> Option<(&'a String, &'a String)> {
    let mut other = after.usual.values.iter().filter(|(name, value)| before.usual.values.get(*name) != Some(*value));
    other.next().filter(|_| other.next().is_none())
}

/// A text with edits, whose places are counted in UTF-16.
fn edited(text: &str, edits: &[Edit]) -> String {
    let units: Vec<u16> = text.encode_utf16().collect();
    let (mut result, mut at) = (Vec::new(), 0);
    for edit in edits {
        result.extend_from_slice(&units[at..edit.from as usize]);
        result.extend(edit.insert.encode_utf16());
        at = edit.to as usize;
    }
    result.extend_from_slice(&units[at..]);
    String::from_utf16(&result).unwrap()
}
