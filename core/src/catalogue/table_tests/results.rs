//! Results: which variant sets which.

use super::{Row, covers, data, rows, tabled};
use crate::entry::{Cycle, Inputs, ResultField, Variant, names};
use std::collections::BTreeSet;

#[test]
fn results_are_those_of_the_table() {
    // oracle: manual, tests/data/results.tsv
    let rows = rows(data!("results.tsv"));
    for cycle in tabled() {
        let of_cycle = || rows.iter().filter(|row| row[0].split(", ").any(|name| name == cycle.name));
        let table: BTreeSet<&str> = of_cycle().map(|row| row[2]).collect();
        let ours: BTreeSet<&str> = cycle.results.iter().map(row_name).collect();
        assert_eq!(ours, table, "{}", cycle.name);
        for frame in table.iter().filter(|name| !cycle.results.iter().any(|field| field.name == **name)) {
            let components = cycle.results.iter().filter(|field| row_name(field) == *frame);
            assert_eq!(components.count(), 6, "{} {frame}: a translation and a rotation an axis", cycle.name);
        }
        for field in cycle.results {
            unset_elsewhere(cycle, field, of_cycle());
        }
        for row in of_cycle() {
            let covered = |one: &&Variant| covers(row[1], one.number);
            for variant in cycle.variants.iter().filter(covered) {
                let what = format!("{} {} {}", cycle.name, variant.number, row[2]);
                let ways = ways(cycle, variant.number);
                let mut some = false;
                for inputs in &ways {
                    let set = is_set(cycle, row[2], inputs);
                    some |= set;
                    if let Some(expected) = by_axis(row[3], inputs) {
                        assert_eq!(set, expected, "{what} {}", inputs.number(names::MA));
                    }
                }
                assert_eq!(some, expected(row, variant.number), "{what}");
            }
        }
    }
}

/// A variant that no row names does not set the result.
fn unset_elsewhere<'a>(cycle: &'static Cycle, field: &'static ResultField, rows: impl Iterator<Item = &'a Row>) {
    let rows: Vec<&Row> = rows.filter(|row| row[2] == row_name(field)).collect();
    for variant in cycle.variants.iter().map(|variant| variant.number) {
        // B:7356 leaves one angle out, which corrects a frame just as well; DESIGN.md.
        let chosen = (cycle.name, field.name) == ("CYCLE998", "_OVI[11]");
        if !chosen && !rows.iter().any(|row| covers(row[1], variant)) {
            let ways = ways(cycle, variant);
            let set = ways.iter().find(|inputs| field.when.holds(inputs));
            assert!(set.is_none(), "{} {variant} {}", cycle.name, field.name);
        }
    }
}

/// Name of a result in the table, which has a frame as one.
pub(super) fn row_name(field: &ResultField) -> &'static str {
    let frame = field.name.ends_with(",TR]") || field.name.ends_with(",RT]");
    match field.name.split_once('[') {
        Some((stem, _)) if frame => stem,
        _ => field.name,
    }
}

fn is_set(cycle: &Cycle, name: &str, inputs: &Inputs) -> bool {
    let of_row = |field: &&ResultField| row_name(field) == name;
    let mut fields = cycle.results.iter().filter(of_row);
    fields.any(|field| field.when.holds(inputs))
}

/// Whether a row counts for these values, where its condition is about the measuring axis.
fn by_axis(condition: &str, inputs: &Inputs) -> Option<bool> {
    let axis = inputs.any(names::MA).unwrap_or(0.0) as i64 % 10;
    if let Some(rest) = condition.strip_prefix("_MA=") {
        return rest.parse().ok().map(|only: i64| only == axis);
    }
    let automatic = inputs.variant % 10 == 2;
    if inputs.cycle.name == "CYCLE982" && radius_alone(inputs.variant) {
        return None; // whether it is determined comes first
    }
    match condition {
        "length" => Some(axis == 3),
        "radius" => Some(axis != 3),
        "L1" => Some(axis == 2 || automatic),
        "L2" => Some(axis == 1 || automatic),
        _ => None,
    }
}

/// Whether a row counts for a variant, by the condition that stands in it.
fn expected(row: &Row, variant: i64) -> bool {
    let zero = variant / 100 % 10 == 1;
    if row[0] == "CYCLE982" && row[1].starts_with("all measuring") {
        return match row[2] {
            "_OVR[8]" | "_OVR[9]" | "_OVR[10]" | "_OVR[11]" => !radius_alone(variant),
            "_OVR[12]" | "_OVR[13]" => variant % 10 == 2 || variant / 1000 % 10 > 0,
            _ => true,
        };
    }
    match row[3] {
        "tool" => !zero,
        "zero" => zero,
        // CYCLE976: holes in the plane, the surface in any axis, the length in the applicate
        "directions of the applicate" => variant % 10 == 0,
        "directions" => variant != 10_000,
        _ => true,
    }
}

/// CYCLE982: the radius without a length (A:10298).
fn radius_alone(variant: i64) -> bool {
    variant / 1000 % 10 == 1
}

/// Inputs of a variant with each measuring axis and direction.
fn ways(cycle: &'static Cycle, variant: i64) -> Vec<Inputs> {
    let with = |(axis, direction): (f64, f64)| {
        let mut inputs = Inputs::new(cycle, variant);
        inputs.numbers.insert(names::MA, axis);
        inputs.numbers.insert(names::MD, direction);
        inputs
    };
    let axes = [1.0, 2.0, 3.0, 103.0, 203.0];
    axes.into_iter().flat_map(|axis| [(axis, 0.0), (axis, 1.0)]).map(with).collect()
}
