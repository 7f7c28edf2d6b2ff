//! The control does the same, whichever way a call is written.

use super::written;
use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::check::check;
use probewright_core::control::{Control, MachineSort, Plane};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Style, Typed};
use probewright_core::machine::setup::Setup;
use probewright_core::program::write::Written;
use probewright_core::run::Limits;
use probewright_core::syntax::read;
use probewright_core::{message, run};
use std::collections::BTreeSet;

/// Number of the variant that these values choose.
fn variant_of(values: &Typed) -> i64 {
    let number = values.get("_MVAR").and_then(|text| text.parse().ok());
    number.unwrap_or(0)
}

/// The machine with the proposed part of a call before its probe.
fn before_the_part(cycle: &'static Cycle, values: &Typed) -> Setup {
    let plane = match cycle.purpose.machine {
        MachineSort::Turning => Plane::G18,
        _ => Plane::G17,
    };
    let mut setup = Setup::for_variant(cycle, variant_of(values), plane);
    let inputs = check(cycle, values, &setup.control).inputs.unwrap();
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids.extend(proposal.fixture);
    setup.tool_probes = proposal.tool_probes;
    let in_use = (setup.control.tool, setup.control.edge);
    let lies = proposal.real_tool.map(|tool| (in_use, tool));
    setup.real_tools.extend(lies);
    for solid in &mut setup.workpiece.solids {
        solid.errors.size = 0.02;
    }
    setup.position = setup.control.to_machine(proposal.start);
    for tool in proposal.tools {
        let of = setup.control.tools.entry(tool.tool).or_default();
        of.name = tool.name;
        of.edges.entry(tool.edge).or_insert(tool.data);
    }
    setup
}

/// The values that a call style can say, and the text; none where it has no list for this variant, or cannot say
/// what is needed.
fn whole(cycle: &'static Cycle, values: &Typed, style: Style) -> Option<(Typed, Written)> {
    let mut values = values.clone();
    loop {
        let written = written(cycle.name, &values, style);
        if written.text.is_empty() {
            return None;
        }
        let lost = written.findings.iter().filter(|one| one.message.key == "write-lost");
        let names: Vec<_> = lost.map(|one| one.message.args[0].1.clone()).collect();
        if names.is_empty() {
            let control = Setup::for_variant(cycle, variant_of(&values), Plane::G17).control;
            let complete = check(cycle, &values, &control).inputs.is_some();
            return complete.then_some((values, written));
        }
        for name in names {
            let message::Arg::Text(name) = name else {
                panic!("{name:?}");
            };
            values.remove(&name).unwrap();
        }
    }
}

/// Results, tools and frames behind a call that is written so.
fn done(cycle: &'static Cycle, setup: &Setup, text: &str) -> (Vec<f64>, Control) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run::run(&program, setup, Limits::default());
    assert_eq!(outcome.stop, None, "{text}\n{:?}", outcome.diagnostics);
    let results = cycle.results.iter();
    let numbers = results.map(|field| outcome.control.number(field.name));
    (numbers.collect(), outcome.control)
}

// oracle: self (the same call, whichever way it is written)
#[test]
fn every_way_of_writing_does_the_same() {
    let mut compared = BTreeSet::new();
    for cycle in CYCLES.iter().filter(|cycle| cycle.work().is_some()) {
        for variant in cycle.variants {
            let values = example(cycle, variant);
            for style in [Style::Indirect, Style::Operate] {
                if !cycle.lists.iter().any(|list| list.style == style && list.is_written()) {
                    continue;
                }
                let Some((values, other)) = whole(cycle, &values, style) else {
                    continue;
                };
                // which sign of the infeed leads down in a list is not published: its run stops
                let infeed = cycle.name != "CYCLE998" && values.get("_ID").is_some_and(|text| text != "0");
                if style == Style::Operate && infeed {
                    continue;
                }
                let setup = before_the_part(cycle, &values);
                let direct = written(cycle.name, &values, Style::Direct);
                let (numbers, control) = done(cycle, &setup, &direct.text);
                let (others, other_control) = done(cycle, &setup, &other.text);
                assert_eq!(numbers, others, "{}", other.text);
                assert_eq!(control.tools, other_control.tools, "{}", other.text);
                assert_eq!(control.frames, other_control.frames, "{}", other.text);
                compared.insert((cycle.name, style == Style::Operate));
            }
        }
    }
    let ways = CYCLES.iter().filter(|cycle| cycle.work().is_some());
    let ways = ways.flat_map(|cycle| {
        let lists = cycle.lists.iter().filter(|list| list.is_written());
        lists.map(|list| (cycle.name, list.style))
    });
    let ways = ways.filter(|(_, style)| *style != Style::Direct);
    let ways: BTreeSet<_> = ways.map(|(name, style)| (name, style == Style::Operate)).collect();
    assert_eq!(compared, ways, "each way of each cycle says something in full");
}
