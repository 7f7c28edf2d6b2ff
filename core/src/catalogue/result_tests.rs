//! What a simulated cycle writes into its results is what its entry lists, and what it looks at is known.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::example::example;
use super::*;
use crate::check::check;
use crate::control::{Control, MachineSort, Plane, data::LOOKED_AT};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Inputs, ProbeUse, Variant, names};
use crate::machine::{Setup, Step};
use crate::message::Arg;
use crate::run::{Outcome, predict};
use std::collections::BTreeSet;

/// What stands in every field before the call, and what no call leaves there.
const BEFORE: f64 = -9876.5;

/// The worked example of a variant, carried out on its own part with some deviation.
fn measured(cycle: &'static Cycle, variant: &Variant) -> (Inputs, Control) {
    let (inputs, outcome) = carried_out(cycle, variant, |_| ());
    (inputs, outcome.control)
}

/// Carries a variant out on a machine that is changed before.
fn carried_out(cycle: &'static Cycle, variant: &Variant, change: impl Fn(&mut Control)) -> (Inputs, Outcome) {
    let (inputs, mut setup) = prepared(cycle, variant);
    change(&mut setup.control);
    let outcome = predict(cycle, &inputs, &setup);
    assert_eq!(outcome.stop, None, "{} {}", cycle.name, variant.number);
    (inputs, outcome)
}

/// The worked example of a variant, and its own part and probe with the tools that it proposes.
fn prepared(cycle: &'static Cycle, variant: &Variant) -> (Inputs, Setup) {
    let mut setup = Setup::for_variant(cycle, variant.number, Plane::G17);
    let checked = check(cycle, &example(cycle, variant), &setup.control);
    let Some(inputs) = checked.inputs else {
        panic!("{} {:?}", cycle.name, checked.diagnostics);
    };
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    let in_use = (setup.control.tool, setup.control.edge);
    let lies = proposal.real_tool.map(|tool| (in_use, tool));
    setup.real_tools.extend(lies);
    setup.position = setup.control.to_machine(proposal.start);
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.edges.insert(proposed.edge, proposed.data);
    }
    for name in fields() {
        setup.control.set(name, BEFORE);
    }
    (inputs, setup)
}

fn fields() -> impl Iterator<Item = String> {
    let numbers = (0..32).map(|index| format!("_OVR[{index}]"));
    numbers.chain((0..16).map(|index| format!("_OVI[{index}]")))
}

/// Of the sides of a tool probe in one axis, `_OVR[8..19]`, that one has results from which the tool came
/// (B:4204-4215): the other pair may be missing.
fn touched_twin(name: &str, written: &BTreeSet<String>) -> bool {
    let index = name.strip_prefix("_OVR[").and_then(|rest| rest.strip_suffix(']'));
    let Some(index) = index.and_then(|index| index.parse::<usize>().ok()) else { return false };
    let twin = index ^ 2;
    (8..20).contains(&index) && written.contains(&format!("_OVR[{twin}]"))
}

#[test]
fn results_are_those_of_the_entry() {
    // oracle: self (the entry, which is held against the manual's table)
    let simulated = CYCLES.iter().copied();
    for cycle in simulated.filter(|cycle| cycle.dialect == Dialect::Sinumerik && cycle.work().is_some()) {
        for variant in cycle.variants {
            let (inputs, control) = measured(cycle, variant);
            let written: BTreeSet<String> = fields().filter(|name| control.number(name) != BEFORE).collect();
            let listed: BTreeSet<String> = cycle
                .results
                .iter()
                .filter(|field| field.when.holds(&inputs))
                .map(|field| field.name.to_owned())
                .filter(|name| name.starts_with("_OV"))
                .collect();
            let beyond: Vec<_> = written.difference(&listed).collect();
            let missing = listed.difference(&written);
            let missing: Vec<_> = missing.filter(|name| !touched_twin(name, &written)).collect();
            let what = format!("{} {}", cycle.name, variant.number);
            assert!(beyond.is_empty() && missing.is_empty(), "{what}: {beyond:?} {missing:?}");
        }
    }
}

/// Every cycle that is simulated on this control, with its variants.
fn simulated(dialect: Dialect) -> impl Iterator<Item = (&'static Cycle, &'static Variant)> {
    let cycles = CYCLES.iter().copied();
    let cycles = cycles.filter(move |cycle| cycle.dialect == dialect && cycle.work().is_some());
    cycles.flat_map(|cycle| cycle.variants.iter().map(move |variant| (cycle, variant)))
}

// oracle: hand: 0 has no sign on a control; an empirical value of 0 that is added is subtracted with the other sign
#[test]
fn no_figure_that_leaves_a_call_is_a_negative_zero() {
    let negative = |number: f64| number == 0.0 && number.is_sign_negative();
    for (cycle, variant) in simulated(Dialect::Sinumerik).chain(simulated(Dialect::Nct)) {
        let what = format!("{} {}", cycle.name, variant.number);
        let added = |control: &mut Control| control.set("_CHBIT[5]", 1.0);
        let (_, outcome) = carried_out(cycle, variant, added);
        for (field, value) in outcome.results(cycle) {
            assert!(value.is_finite() && !negative(value), "{what}: {}", field.name);
        }
        for change in outcome.changes() {
            let both = [change.before, change.after];
            assert!(!both.into_iter().any(negative), "{what}: {}", change.name);
        }
        for entry in &outcome.trace.entries {
            match &entry.step {
                Step::Set { name, after, .. } => assert!(!negative(*after), "{what}: {name}"),
                Step::Decision { message } => assert!(
                    !message.args.iter().any(|(_, arg)| matches!(arg, Arg::Number(number) if negative(*number))),
                    "{what}: {message:?}"
                ),
                _ => {}
            }
        }
    }
}

// oracle: manual B:12564-12578, B:13953-13971: shown at the end of whatever measures or calibrates; M0 with _CHBIT[11]
#[test]
fn every_measuring_cycle_shows_its_result_screen_on_demand() {
    let screens = |cycle, variant, bits: [f64; 3]| {
        let set = |control: &mut Control| {
            for (bit, value) in ["_CHBIT[10]", "_CHBIT[11]", "_CHBIT[18]"].iter().zip(bits) {
                control.set(*bit, value);
            }
        };
        let (_, outcome) = carried_out(cycle, variant, set);
        let shown = outcome.decisions().into_iter().map(|one| one.key.clone());
        let shown: Vec<_> = shown.filter(|key| key.starts_with("evaluate-screen")).collect();
        shown
    };
    for (cycle, variant) in simulated(Dialect::Sinumerik) {
        for (bits, key) in [
            ([0.0, 1.0, 0.0], ""),
            ([1.0, 0.0, 0.0], "evaluate-screen"),
            ([1.0, 0.0, 1.0], "evaluate-screen-stays"),
            ([1.0, 1.0, 0.0], "evaluate-screen-halt"),
        ] {
            let measures = cycle.purpose.probe.measures() && !key.is_empty();
            let expected = if measures { vec![key] } else { vec![] };
            assert_eq!(screens(cycle, variant, bits), expected, "{}", cycle.name);
        }
    }
}

// oracle: self (the entry, which is held against the manual's table)
#[test]
fn data_that_a_macro_sets_are_results_of_its_entry() {
    for (cycle, variant) in simulated(Dialect::Nct) {
        let (inputs, outcome) = carried_out(cycle, variant, |_| ());
        let entries = outcome.trace.entries.to_vec();
        let steps = entries.iter().map(|entry| &entry.step);
        let set: BTreeSet<&str> = steps
            .filter_map(|step| match step {
                Step::Set { name, .. } if outcome.control.data.contains_key(name) => Some(name.as_str()),
                _ => None, // a register or an offset, which is corrected
            })
            .collect();
        let fields = cycle.results.iter().filter(|field| field.when.holds(&inputs));
        let listed: BTreeSet<&str> = fields.map(|field| field.name).collect();
        assert_eq!(set, listed, "{} {}", cycle.name, variant.number);
    }
}

/// Bits and machine data that the steps common to all cycles look at: system of units, scale, log, erasing, result
/// screen, frames.
const EVERY: &[&str] = &["_CBIT[3]", "_CBIT[9]", "_CBIT[13]", "_CHBIT[10]", "_CHBIT[24]", "MD20050", "MD28082"];
/// Switches of a cycle with the workpiece probe: of its measuring block and its calibration.
const PROBE: &[&str] = &["_CBIT[8]", "_CBIT[14]", "_CBIT[16]"];
/// Switches of a cycle with the workpiece probe on a milling machine.
const MILLING: &[&str] = &["_CHBIT[2]", "_CHBIT[13]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]"];
/// Switches of a cycle that corrects what `_KNUM` names.
const CORRECTING: &[&str] = &["_CHBIT[4]", "_CHBIT[5]", "_CHBIT[21]", "MD18102", "MD18105", "MD18600"];
/// Data of the cycle that finds out which rotary axes there are.
const ROTARY: &[&str] = &["MD20080", "MD30300"];

// oracle: self: a cycle looks at no bit and no machine datum but those of its entry and of what its sort shares
#[test]
fn every_bit_that_is_looked_at_is_known_of_the_cycle() {
    for (cycle, variant) in simulated(Dialect::Sinumerik) {
        let purpose = &cycle.purpose;
        let probe = purpose.probe == ProbeUse::Workpiece;
        let shared = [
            (true, EVERY),
            (probe, PROBE),
            (probe && purpose.machine == MachineSort::Milling, MILLING),
            (cycle.param(&names::KNUM).is_some(), CORRECTING),
            (cycle.name == "CYCLE998", ROTARY),
            (true, cycle.settings),
        ];
        let known: BTreeSet<&str> =
            shared.iter().filter(|(has, _)| *has).flat_map(|(_, names)| *names).copied().collect();
        let (inputs, setup) = prepared(cycle, variant);
        LOOKED_AT.set(Some(BTreeSet::new()));
        predict(cycle, &inputs, &setup);
        let bits = ["_CBIT[", "_CHBIT[", "MD"];
        let unknown =
            LOOKED_AT.take().into_iter().flatten().filter(|name| bits.iter().any(|start| name.starts_with(start)));
        let array = |name: &str| name.split('[').next().unwrap_or_default().to_owned();
        let unknown = unknown.filter(|name| !known.contains(name.as_str()) && !known.contains(array(name).as_str()));
        let unknown: Vec<_> = unknown.collect();
        assert!(unknown.is_empty(), "{} {}: {unknown:?}", cycle.name, variant.number);
    }
}
