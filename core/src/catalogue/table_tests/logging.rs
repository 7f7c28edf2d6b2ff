//! The cycles of the log against the table of their calls and the table of their data.

use super::super::*;
use super::{common_rows, sinumerik};
use crate::entry::Arg;
use crate::entry::Cycle;
use crate::entry::ProbeUse;
use std::collections::BTreeSet;
use std::path::Path;

fn of_log() -> impl Iterator<Item = &'static Cycle> {
    sinumerik().filter(|cycle| cycle.purpose.probe == ProbeUse::Log)
}

/// `CYCLE113(PAR1,PAR2)`, `CYCLE100`.
fn call(cycle: &Cycle) -> String {
    let name = |arg: &Arg| match arg {
        Arg::Param(name) | Arg::Output(name) => *name,
        _ => panic!("{}", cycle.name),
    };
    match cycle.lists {
        [] => cycle.name.to_owned(),
        [list] => {
            let args: Vec<&str> = list.args.iter().map(name).collect();
            format!("{}({})", list.name, args.join(","))
        }
        _ => panic!("{}", cycle.name),
    }
}

#[test]
fn calls_are_those_of_the_table() {
    // oracle: manual B:11182-11320, spec/common/logging.md section 2
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/spec/common/logging.md");
    let Ok(text) = std::fs::read_to_string(path) else {
        return;
    };
    let first_cell = |line: &str| Some(line.strip_prefix("| `CYCLE")?.split('`').next()?.to_owned());
    let table: BTreeSet<String> = text.lines().filter_map(first_cell).collect();
    let ours: BTreeSet<String> = of_log().map(|cycle| call(cycle).trim_start_matches("CYCLE").to_owned()).collect();
    assert_eq!(ours, table);
}

#[test]
fn data_are_those_of_the_table() {
    // oracle: manual B:11340-11431, spec/common/gud.tsv
    let rows = common_rows("gud.tsv");
    if rows.is_empty() {
        return;
    }
    let of_log_data = |row: &&Vec<String>| {
        let stems = ["_PROT", "_HEADLINE", "_DIGIT"];
        stems.iter().any(|stem| row[0].starts_with(stem)) && row[7] != "Internal fields"
    };
    let spread = |row: &Vec<String>| super::params::names_of(&row[0]);
    let table: BTreeSet<String> = rows.iter().filter(of_log_data).flat_map(spread).collect();
    let own = |cycle: &'static Cycle| cycle.params.iter().filter(|param| param.is_machine_datum());
    let names = |cycle| own(cycle).map(|param| param.name.to_owned()).collect();
    let ours: BTreeSet<String> = names(&cycle100::CYCLE100);
    assert_eq!(ours, table);
    for cycle in of_log() {
        let some: BTreeSet<String> = names(cycle);
        assert!(some.is_subset(&ours), "{}", cycle.name);
    }
}
