//! The macros against the tables of the NCT manual.

use crate::catalogue::{CYCLES, by_program, nct};
use crate::control::Plane;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Inputs, Param};
use crate::test_data::{Row, data, rows};
use std::collections::BTreeSet;

fn macros() -> impl Iterator<Item = &'static Cycle> {
    let all = CYCLES.iter().copied();
    all.filter(|cycle| cycle.dialect == Dialect::Nct)
}

#[test]
fn variants_and_results_are_as_many_as_in_the_table() {
    // oracle: manual, tests/data/nct_macros.tsv, counted by hand
    let rows = rows(data!("nct_macros.tsv"));
    assert!(rows.iter().all(|row| macro_of(row).is_some()));
    for cycle in macros() {
        let rows = of(&rows, cycle);
        let sum = |column: usize| rows.iter().map(|row| row[column].parse::<usize>().unwrap()).sum::<usize>();
        assert_eq!((cycle.variants.len(), cycle.results.len()), (sum(2), sum(3)), "{}", cycle.name);
    }
}

/// Addresses of a row: `X,Y,Z`, `X|Y|Z (…)`, `Z (G17) / Y (G18) / X (G19)`, `both axes of the plane`, `D`.
fn addresses(cell: &str) -> BTreeSet<&str> {
    if cell.starts_with("both axes") {
        return ["X", "Y", "Z"].into();
    }
    cell.split([',', '|', '/', ' '])
        .filter(|word| word.len() == 1 && word.chars().all(|letter| letter.is_ascii_uppercase()))
        .collect()
}

/// Rows of the table for a macro.
fn of<'a>(rows: &'a [Row], cycle: &Cycle) -> Vec<&'a Row> {
    rows.iter().filter(|row| belongs(row, cycle)).collect()
}

/// Whether a row is of a macro, or of one way to call it: `G65 P9920 T0`.
pub fn belongs(row: &Row, cycle: &Cycle) -> bool {
    let rest = row[0].strip_prefix(cycle.name);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(" T"))
}

fn macro_of(row: &Row) -> Option<&'static Cycle> {
    macros().find(|cycle| belongs(row, cycle))
}

#[test]
fn addresses_are_those_of_the_table() {
    // oracle: manual, tests/data/nct_addresses.tsv (C:114-1101), both directions
    let rows = rows(data!("nct_addresses.tsv"));
    for cycle in macros() {
        let rows = of(&rows, cycle);
        let table: BTreeSet<&str> = rows.iter().flat_map(|row| addresses(row[1])).collect();
        let ours: BTreeSet<&str> = cycle.params.iter().map(|param| param.name.as_str()).collect();
        assert_eq!(ours, table, "{}", cycle.name);
    }
}

#[test]
fn defaults_are_those_of_the_table() {
    // oracle: manual, tests/data/nct_addresses.tsv: `5 mm`, `0.2 inch`, `1500 mm/min`
    let number = |cell: &str| cell.split(' ').next()?.parse::<f64>().ok();
    let mut seen = 0;
    for row in rows(data!("nct_addresses.tsv")) {
        let Some(cycle) = macro_of(&row) else { continue };
        for name in addresses(row[1]) {
            let param = cycle.param(name).unwrap();
            assert_eq!(param.default, number(row[3]), "{row:?}");
            assert_eq!(param.default_inch, number(row[4]), "{row:?}");
            seen += 1;
        }
    }
    assert_eq!(seen, 100);
}

#[test]
fn what_has_to_be_given_is_a_format_error_otherwise() {
    // oracle: manual, tests/data/nct_addresses.tsv, column mandatory
    let mut seen = 0;
    for row in rows(data!("nct_addresses.tsv")) {
        let Some(cycle) = macro_of(&row) else { continue };
        if row[2] != "yes" || !cycle.alarms().contains(&nct::FORMAT_ERROR) {
            continue;
        }
        for plane in [Plane::G17, Plane::G18, Plane::G19] {
            assert!(nothing_given(cycle, plane).contains(&nct::FORMAT_ERROR), "{row:?}");
            seen += 1;
        }
    }
    assert!(seen >= 15, "{seen}");
}

fn nothing_given(cycle: &'static Cycle, plane: Plane) -> Vec<Code> {
    nct::bench::codes(cycle, &[], plane)
}

#[test]
fn a_register_and_an_offset_have_their_range() {
    // oracle: manual, tests/data/nct_addresses.tsv: S 0 to 6; T and M up to 99 (the lower end printed as 6 is 1:
    // examples)
    let ranged = |name: &str, min: f64, max: f64| {
        let refusing = |cycle: &&Cycle| cycle.name.starts_with("G1"); // others mean something else by these letters
        for cycle in macros().filter(refusing) {
            let Some(param) = cycle.param(name) else { continue };
            let ends = (param.range.min, param.range.max);
            assert_eq!(ends, (min, max), "{} {name}", cycle.name);
            assert_eq!(param.alarm, Some(nct::FORMAT_ERROR), "{} {name}", cycle.name);
        }
    };
    ranged("S", 0.0, 6.0);
    ranged("T", 1.0, 99.0);
    ranged("M", 1.0, 99.0);
}

#[test]
fn programs_call_their_macros() {
    // oracle: manual, tests/data/nct_macros.tsv (C:58): O9010 is G101
    for row in rows(data!("nct_macros.tsv")) {
        let Some(number) = row[1].strip_prefix('O').and_then(|text| text.parse().ok()) else { continue };
        let found = by_program(number).map(|cycle| cycle.name);
        let known = macro_of(&row);
        assert_eq!(found, known.map(|cycle| cycle.name), "{row:?}");
    }
}

#[test]
fn the_address_of_the_tool_axis_belongs_to_its_plane() {
    // oracle: manual, tests/data/nct_addresses.tsv: `Z (G17) / Y (G18) / X (G19)`
    for row in rows(data!("nct_addresses.tsv")) {
        let Some(cycle) = macro_of(&row) else { continue };
        if !row[1].starts_with("Z (G17)") {
            continue;
        }
        for (plane, axis) in nct::bench::TOOL_AXIS {
            let mut inputs = Inputs::new(cycle, 0);
            inputs.plane = plane;
            let param: &Param = cycle.param(axis).unwrap();
            assert!(param.need(&inputs).is_some(), "{} {axis}", cycle.name);
        }
    }
}
