//! Variants and combinations that the tables call invalid are refused, with the alarm named there.

use super::{covers, refused, rows, rows_of, sinumerik};
use crate::diagnostic::Code;
use crate::entry::{Cycle, names};

#[test]
fn invalid_variants_are_refused() {
    // oracle: manual, spec/milling/variants_invalid.tsv
    let rows = rows("variants_invalid.tsv");
    for cycle in sinumerik().filter(|_| !rows.is_empty()) {
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            let alarm = Code::Alarm(alarm(&row[5]));
            for (variant, values) in calls(cycle, &row[1]) {
                let codes = refused(cycle, variant, values);
                assert_eq!(codes, [alarm], "{} {variant} {values:?}", cycle.name);
            }
        }
    }
}

#[test]
fn invalid_variants_in_turning_are_refused() {
    // oracle: manual, rows INVALID of spec/turning/variants.tsv (B:1854, B:10177, A:11372). Combinations with the tool
    // in use stand in the tests of their cycles.
    let rows = rows_of("turning", "variants.tsv");
    for cycle in sinumerik().filter(|_| !rows.is_empty()) {
        for row in rows.iter().filter(|row| row[0] == cycle.name) {
            let Some(list) = row[1].strip_prefix("INVALID: ") else {
                continue;
            };
            let others = || (-1..1100).chain([9999, 100_000, 1_000_000]);
            let meant: Vec<i64> = match list {
                _ if list.starts_with("every other integer") => others().collect(),
                _ if list.contains(|c: char| c.is_ascii_lowercase()) => continue, // patterns, words
                _ => numbers(list).collect(),
            };
            let known = |number: &i64| cycle.variants.iter().any(|one| one.number == *number);
            for variant in meant {
                if known(&variant) {
                    assert!(list.starts_with("every other"), "{} {variant}", cycle.name);
                    continue;
                }
                let codes = refused(cycle, variant, &[]);
                assert_eq!(codes, [Code::Alarm(61307)], "{} {variant}", cycle.name);
            }
        }
    }
}

/// `not defined (proposal 61313)` → 61313.
fn alarm(cell: &str) -> u32 {
    let mut numbers = cell.split(|c: char| !c.is_ascii_digit());
    let alarm = numbers.find(|text| text.len() == 5);
    alarm.unwrap_or_else(|| panic!("{cell}")).parse().unwrap()
}

type Values = &'static [(&'static str, &'static str)];

/// Conditions of the rows behind `with`, as values.
const WITH: &[(&str, Values)] = &[
    ("mono or bidirectional probe (_PRNUM hundreds digit 1)", MONO),
    ("mono probe (_PRNUM=1xy)", MONO),
    ("mono/bi probe", MONO),
    ("mono probe", MONO),
    ("_MA=3", &[(names::MA, "3")]),
    ("_MA<>3", &[(names::MA, "1")]),
    ("_MA=x03", &[(names::MA, "103")]),
    ("_KNUM=1051..1066", &[(names::KNUM, "1051")]),
];
const MONO: Values = &[(names::PRNUM, "101")];

/// Rows without a number of their own, by examples.
const EXAMPLES: &[(&str, &str)] = &[("d3<>1 or d1<>9 or d2>1", "9, 100, 101, 129, 1009")];

/// The calls that a row means.
fn calls(cycle: &Cycle, cell: &str) -> Vec<(i64, Values)> {
    let example = EXAMPLES.iter().find(|(words, _)| *words == cell);
    if let Some(list) = example.map(|(_, list)| *list).or(inner(cell, "e.g. ")) {
        return numbers(list).map(|number| (number, &[] as Values)).collect();
    }
    if let Some((variants, with)) = cell.split_once(" with ") {
        let given = WITH.iter().find(|(words, _)| *words == with);
        let (_, values) = given.unwrap_or_else(|| panic!("{cell}"));
        let variants = variants.replace('/', ",");
        let meant = cycle.variants.iter().filter(|one| covers(&variants, one.number));
        return meant.map(|one| (one.number, *values)).collect();
    }
    let list = inner(cell, "").unwrap_or(cell);
    numbers(list).map(|number| (number, &[] as Values)).collect()
}

/// What stands in brackets behind these words.
fn inner<'a>(cell: &'a str, words: &str) -> Option<&'a str> {
    let (_, rest) = cell.split_once(&format!("({words}"))?;
    rest.split_once(')').map(|(inner, _)| inner)
}

/// `1001..1004, 1101`.
fn numbers(list: &str) -> impl Iterator<Item = i64> + '_ {
    list.split(',').flat_map(|part| {
        let (from, to) = part.split_once("..").unwrap_or((part, part));
        let number = |text: &str| text.trim().parse::<i64>().unwrap();
        number(from)..=number(to)
    })
}
