//! Results: which variant sets which.

use super::super::*;
use super::{covers, rows, sinumerik};
use crate::check::Inputs;
use std::collections::BTreeSet;

#[test]
fn results_are_those_of_the_table() {
    // oracle: manual, spec/milling/results.tsv, spec/turning/results.tsv
    let rows = rows("results.tsv");
    for cycle in sinumerik().filter(|_| !rows.is_empty()) {
        let of_cycle = || {
            rows.iter()
                .filter(|row| row[0].split(", ").any(|name| name == cycle.name))
        };
        let table: BTreeSet<&str> = of_cycle().map(|row| row[2].as_str()).collect();
        let ours: BTreeSet<&str> = cycle.results.iter().map(|field| field.name).collect();
        assert_eq!(ours, table, "{}", cycle.name);
        for row in of_cycle() {
            let covered = |one: &&Variant| covers(&row[1], one.number);
            for variant in cycle.variants.iter().filter(covered) {
                let set = ways(cycle, variant.number).iter().any(|inputs| {
                    let of_row = |field: &&ResultField| field.name == row[2];
                    cycle
                        .results
                        .iter()
                        .filter(of_row)
                        .any(|field| field.when.holds(inputs))
                });
                let expected = expected(&row[5], variant.number);
                assert_eq!(
                    set, expected,
                    "{} {} {}",
                    cycle.name, variant.number, row[2]
                );
            }
        }
    }
}

/// Whether a row counts for a variant, by the condition that stands in it.
fn expected(condition: &str, variant: i64) -> bool {
    let zero = variant / 100 % 10 == 1;
    match condition {
        "footnote 1: only with tool offset" => !zero,
        "footnote 2: only with ZO correction" => zero,
        _ => true,
    }
}

/// Inputs of a variant with each measuring axis.
fn ways(cycle: &'static Cycle, variant: i64) -> Vec<Inputs> {
    let with = |axis: f64| {
        let mut inputs = Inputs::new(cycle, variant);
        inputs.numbers.insert(names::MA, axis);
        inputs
    };
    [1.0, 2.0, 3.0].map(with).into()
}
