//! The table in README.md of what can be measured is that of the catalogue.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use crate::catalogue::CYCLES;
use crate::control::MachineSort;
use crate::dialect::Dialect;
use crate::entry::{Cycle, ProbeUse};
use std::path::Path;

const HEAD: &str = "| | form, picture, checks, program text and reading back | simulation |\n|---|---|---|\n";

/// A row of the table: its name, and what stands in it.
type Row = (&'static str, fn(&Cycle) -> bool);

const ROWS: [Row; 7] = [
    ("SINUMERIK 840D/840Di/810D, milling", |cycle| of(cycle, MachineSort::Milling)),
    ("SINUMERIK, turning", |cycle| of(cycle, MachineSort::Turning)),
    ("SINUMERIK, helper", |cycle| cycle.purpose.probe == ProbeUse::None),
    ("SINUMERIK, log", |cycle| cycle.purpose.probe == ProbeUse::Log),
    ("NCT probing macros", |cycle| nct(cycle) && cycle.purpose.probe == ProbeUse::Workpiece && cycle.scan().is_none()),
    ("NCT tool probe", |cycle| nct(cycle) && cycle.purpose.probe == ProbeUse::Tool),
    ("NCT digitizing", |cycle| nct(cycle) && cycle.scan().is_some()),
];

fn nct(cycle: &Cycle) -> bool {
    cycle.dialect == Dialect::Nct
}

/// Measuring cycles of a sort of machine on SINUMERIK.
fn of(cycle: &Cycle, machine: MachineSort) -> bool {
    !nct(cycle) && cycle.purpose.probe.measures() && cycle.purpose.machine == machine
}

/// `CYCLE961, 971`: the first name whole, of the others their number; `G101 to G110` where no number is left out.
fn names(cycles: &[&Cycle]) -> String {
    let number = |cycle: &Cycle| cycle.name.trim_start_matches(|c: char| !c.is_ascii_digit());
    let counted = |cycle: &Cycle| number(cycle).parse::<usize>().unwrap_or(0);
    match cycles {
        [] => "–".to_owned(),
        [first, _, .., last] if counted(last) - counted(first) + 1 == cycles.len() => {
            format!("{} to {}", first.name, last.name)
        }
        [first, rest @ ..] => {
            let rest: Vec<&str> = rest.iter().map(|cycle| number(cycle)).collect();
            [&[first.name], &rest[..]].concat().join(", ")
        }
    }
}

fn table() -> String {
    let mut shown = 0;
    let mut text = HEAD.to_owned();
    for (name, belongs) in ROWS {
        let cycles: Vec<&Cycle> = CYCLES.iter().copied().filter(|cycle| belongs(cycle)).collect();
        let simulated: Vec<&Cycle> = cycles.iter().copied().filter(|cycle| cycle.simulation.is_some()).collect();
        text += &format!("| {name} | {} | {} |\n", names(&cycles), names(&simulated));
        shown += cycles.len();
    }
    assert_eq!(shown, CYCLES.len(), "each cycle in one row");
    text
}

// oracle: self. With PROBEWRIGHT_UPDATE=1 the table is written instead.
#[test]
fn the_table_is_that_of_the_catalogue() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    let text = std::fs::read_to_string(&path).unwrap();
    let begin = text.find(HEAD).expect("the head of the table");
    let end = begin + text[begin..].find("\n\n").expect("the end of the table") + 1;
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        return std::fs::write(&path, [&text[..begin], &table(), &text[end..]].concat()).unwrap();
    }
    assert_eq!(&text[begin..end], table());
}
