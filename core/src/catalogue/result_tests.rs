//! What a simulated cycle writes into `_OVR[]` and `_OVI[]` is what its entry lists.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::example::example;
use super::*;
use crate::check::{Inputs, check};
use crate::control::{Control, Plane};
use crate::run::{Setup, predict};
use std::collections::BTreeSet;

/// What stands in every field before the call, and what no call leaves there.
const BEFORE: f64 = -9876.5;

/// The worked example of a variant, carried out on its own part with some deviation.
fn measured(cycle: &'static Cycle, variant: &Variant) -> (Inputs, Control) {
    let mut setup = Setup::for_cycle(cycle, Plane::G17);
    let checked = check(cycle, &example(cycle, variant), &setup.control);
    let Some(inputs) = checked.inputs else {
        panic!("{} {:?}", cycle.name, checked.diagnostics);
    };
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids.extend(proposal.fixture);
    setup.position = setup.control.to_machine(proposal.start);
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.edges.insert(proposed.edge, proposed.data);
    }
    for name in fields() {
        setup.control.set(name, BEFORE);
    }
    let outcome = predict(cycle, &inputs, &setup);
    assert_eq!(outcome.stop, None, "{} {}", cycle.name, variant.number);
    (inputs, outcome.control)
}

fn fields() -> impl Iterator<Item = String> {
    let numbers = (0..32).map(|index| format!("_OVR[{index}]"));
    numbers.chain((0..16).map(|index| format!("_OVI[{index}]")))
}

#[test]
fn results_are_those_of_the_entry() {
    // oracle: self (the entry, which is held against the manual's table)
    let simulated = CYCLES.iter().copied();
    for cycle in
        simulated.filter(|cycle| cycle.dialect == Dialect::Sinumerik && cycle.work().is_some())
    {
        for variant in cycle.variants {
            let (inputs, control) = measured(cycle, variant);
            let written: BTreeSet<String> = fields()
                .filter(|name| control.number(name) != BEFORE)
                .collect();
            let listed: BTreeSet<String> = cycle
                .results
                .iter()
                .filter(|field| field.when.holds(&inputs))
                .map(|field| field.name.to_owned())
                .filter(|name| name.starts_with("_OV"))
                .collect();
            assert_eq!(written, listed, "{} {}", cycle.name, variant.number);
        }
    }
}
