//! Variants and combinations that the tables call invalid are refused, with the alarm named there.

use super::{covers, data, refused, rows, sinumerik};
use crate::diagnostic::Code;
use crate::entry::Cycle;

#[test]
fn invalid_variants_are_refused() {
    // oracle: manual, tests/data/variants_invalid.tsv; where no alarm is named (DESIGN.md) the table has what was
    // chosen
    let rows = rows(data!("variants_invalid.tsv"));
    for row in rows.iter().filter(|row| row[1] != OTHERS) {
        let cycle = sinumerik().find(|cycle| cycle.name == row[0]).unwrap();
        let alarm = Code::Alarm(row[3].parse().unwrap());
        let values: Vec<(&str, &str)> = row[2].split_once('=').into_iter().collect();
        for variant in variants(cycle, row[1], !values.is_empty()) {
            assert_eq!(refused(cycle, variant, &values), [alarm], "{} {variant} {values:?}", cycle.name);
        }
    }
}

/// Cell of a cycle that refuses every number but its variants.
const OTHERS: &str = "others";

#[test]
fn invalid_variants_in_turning_are_refused() {
    // oracle: manual, rows `others` of tests/data/variants_invalid.tsv (B:1854, B:10177, A:11372). Combinations with
    // the tool in use stand in the tests of their cycles.
    let rows = rows(data!("variants_invalid.tsv"));
    for row in rows.iter().filter(|row| row[1] == OTHERS) {
        let cycle = sinumerik().find(|cycle| cycle.name == row[0]).unwrap();
        let known = |number: &i64| cycle.variants.iter().any(|one| one.number == *number);
        let others = (-1..1100).chain([9999, 100_000, 1_000_000]).filter(|number| !known(number));
        for variant in others {
            assert_eq!(refused(cycle, variant, &[]), [Code::Alarm(61307)], "{} {variant}", cycle.name);
        }
    }
}

/// Numbers that a cell means: those of the cycle that it covers where a value beside them is what is wrong, otherwise
/// numbers that the cycle does not have.
fn variants(cycle: &Cycle, cell: &str, known: bool) -> Vec<i64> {
    if known {
        return cycle.variants.iter().map(|one| one.number).filter(|number| covers(cell, *number)).collect();
    }
    numbers(cell)
        .inspect(|number| assert!(cycle.variants.iter().all(|one| one.number != *number), "{number}"))
        .collect()
}

/// `1001..1004,1101`.
pub fn numbers(list: &str) -> impl Iterator<Item = i64> + '_ {
    list.split(',').flat_map(|part| {
        let (from, to) = part.split_once("..").unwrap_or((part, part));
        let number = |text: &str| text.trim().parse::<i64>().unwrap();
        number(from)..=number(to)
    })
}
