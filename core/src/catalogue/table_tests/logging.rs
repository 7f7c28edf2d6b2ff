//! The cycles of the log against the table of their calls and the table of their data.

use super::super::*;
use super::invalid::numbers;
use super::params::names_of;
use super::sinumerik;
use crate::entry::{Arg, Cycle, ProbeUse};
use crate::test_data::{Row, data, rows};
use std::collections::BTreeSet;

fn of_log() -> impl Iterator<Item = &'static Cycle> {
    sinumerik().filter(|cycle| cycle.purpose.probe == ProbeUse::Log)
}

/// `CYCLE113(PAR1,PAR2)`, `CYCLE100`.
fn call(cycle: &Cycle) -> String {
    let name = |arg: &Arg| match arg {
        Arg::Param(name) => name.as_str(),
        Arg::Output(name) => *name,
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
    // oracle: manual B:11182-11320, tests/data/log_calls.tsv
    let rows = rows(data!("log_calls.tsv"));
    let table: BTreeSet<&str> = rows.iter().map(|row| row[0]).collect();
    let ours: Vec<String> = of_log().map(call).collect();
    assert_eq!(ours.iter().map(String::as_str).collect::<BTreeSet<_>>(), table);
    for cycle in of_log() {
        let row = rows.iter().find(|row| row[0] == call(cycle)).unwrap();
        let variants: Vec<i64> = cycle.variants.iter().map(|variant| variant.number).collect();
        assert_eq!(variants, numbers(row[1]).collect::<Vec<_>>(), "{}", cycle.name);
        let results: Vec<&str> = cycle.results.iter().map(|field| field.name).collect();
        let table = if row[2] == "-" { Vec::new() } else { names_of(row[2]) };
        assert_eq!(results, table, "{}", cycle.name);
    }
}

#[test]
fn data_are_those_of_the_table() {
    // oracle: manual B:11340-11431, tests/data/user_data.tsv
    let rows = rows(data!("user_data.tsv"));
    let of_log_data = |row: &&Row| {
        let stems = ["_PROT", "_HEADLINE", "_DIGIT"];
        stems.iter().any(|stem| row[0].starts_with(stem)) && row[7] != "internal"
    };
    let spread = |row: &Row| names_of(row[0]);
    let table: BTreeSet<String> = rows.iter().filter(of_log_data).flat_map(spread).collect();
    let own = |cycle: &'static Cycle| cycle.params.iter().filter(|param| param.is_machine_datum());
    let names = |cycle| own(cycle).map(|param| param.name.to_string()).collect();
    let ours: BTreeSet<String> = names(&cycle100::CYCLE100);
    assert_eq!(ours, table);
    for cycle in of_log() {
        let some: BTreeSet<String> = names(cycle);
        assert!(some.is_subset(&ours), "{}", cycle.name);
    }
}
