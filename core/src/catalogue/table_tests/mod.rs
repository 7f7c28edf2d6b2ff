//! The catalogue against the tables of the manual (`tests/data/`), row by row in both directions.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod aims;
mod alarms;
mod allowed;
mod cells;
mod conditions;
mod invalid;
mod lists;
mod logging;
mod messages;
mod nct;
mod params;
mod r_parameters;
mod reasons;
mod results;

use super::*;
use crate::check::check;
use crate::control::delivery;
use crate::diagnostic::{Code, Severity};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Param, ProbeUse, Typed, names};
use crate::name::Name;
use crate::test_data::{Row, data, rows};
use cells::covers;
use std::collections::BTreeSet;

fn sinumerik() -> impl Iterator<Item = &'static Cycle> {
    CYCLES.iter().copied().filter(|cycle| cycle.dialect == Dialect::Sinumerik)
}

/// Cycles that stand in the tables of milling and turning; those of the log stand in [`logging`].
fn tabled() -> impl Iterator<Item = &'static Cycle> {
    sinumerik().filter(|cycle| cycle.purpose.probe != ProbeUse::Log)
}

/// Codes of the errors that a call of this variant raises because of the last of these values.
fn refused(cycle: &'static Cycle, variant: i64, values: &[(&str, &str)]) -> Vec<Code> {
    let number = variant.to_string();
    let mut typed: Typed = [(names::MVAR.to_string(), number)].into();
    typed.extend(values.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())));
    let at = values.last().map_or(names::MVAR.as_str(), |(name, _)| name);
    let found = check(cycle, &typed, &delivery(Dialect::Sinumerik)).diagnostics;
    let errors =
        found.iter().filter(|one| one.severity == Severity::Error && one.param.is_some_and(|param| param == at));
    errors.map(|one| one.code).collect()
}

/// Parameters without the data of the machine that a form may have too.
fn of_the_call(cycle: &Cycle) -> impl Iterator<Item = &Param> {
    let params = cycle.params.iter();
    params.filter(|param| !param.is_machine_datum())
}

#[test]
fn names_stand_once() {
    // oracle: self
    for cycle in CYCLES {
        let names: BTreeSet<Name> = cycle.params.iter().map(|param| param.name).collect();
        assert_eq!(names.len(), cycle.params.len(), "{}", cycle.name);
        let numbers: BTreeSet<i64> = cycle.variants.iter().map(|one| one.number).collect();
        assert_eq!(numbers.len(), cycle.variants.len(), "{}", cycle.name);
    }
}

// oracle: the manual's name of the macro, and of the cycle
#[test]
fn a_cycle_is_found_on_its_own_control_alone() {
    assert!(find(Dialect::Sinumerik, "cycle977").is_some() && find(Dialect::Nct, "CYCLE977").is_none());
}

#[test]
fn variants_are_those_of_the_table() {
    // oracle: manual, tests/data/variants.tsv; a cycle without variants has the number 0 alone
    let rows = rows(data!("variants.tsv"));
    let cycles: BTreeSet<&str> = tabled().map(|cycle| cycle.name).collect();
    assert_eq!(cycles, rows.iter().map(|row| row[0]).collect());
    for cycle in tabled() {
        let of_cycle = rows.iter().filter(|row| row[0] == cycle.name);
        let table: BTreeSet<i64> = of_cycle.flat_map(|row| invalid::numbers(row[1])).collect();
        let ours: BTreeSet<i64> = cycle.variants.iter().map(|one| one.number).collect();
        assert_eq!(ours, table, "{}", cycle.name);
    }
}
