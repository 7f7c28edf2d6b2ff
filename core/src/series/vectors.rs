//! Decisions, capability and errors against figures calculated without this code: `tests/data/uncertainty.json`.
#![allow(clippy::unwrap_used)]

use super::capability::capability;
use super::decide::{Limits, Proof, guard};
use super::random::Source;
use super::spread::{Spread, share_error, unseen};
use serde_json::Value;

/// A group of figures.
fn group(name: &str) -> [Value; 2] {
    let all: Value = serde_json::from_str(include_str!("../../../tests/data/uncertainty.json")).unwrap();
    ["given", "expect"].map(|part| all[name][part].clone())
}

fn number(of: &Value, name: &str) -> f64 {
    of[name].as_f64().unwrap()
}

fn near(found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() <= tolerance * wanted.abs(), "{found} instead of {wanted}");
}

// oracle: peer: tests/data/uncertainty.json, JCGM 106, 7 and ISO 14253-1
#[test]
fn the_chance_that_a_part_is_good() {
    let [given, expect] = group("conformance_probability");
    let limits = Limits { low: number(&given, "lower"), high: number(&given, "upper") };
    let (measured, u) = (number(&given, "y"), number(&given, "u"));
    let chances = limits.chances(measured, u);
    near(chances.good, number(&expect, "p_good"), 1e-12);
    near(chances.low + chances.good + chances.high, 1.0, 1e-12);
    let width = guard(u);
    near(width, number(&expect, "guard_95"), 1e-12);
    for (limit, inside, outside) in [
        (number(&expect, "accept_upper"), Proof::Good, Proof::Undecided),
        (number(&expect, "reject_above"), Proof::Undecided, Proof::Bad),
    ] {
        assert_eq!([limit - 1e-9, limit + 1e-9].map(|value| limits.proof(value, width)), [inside, outside]);
        assert_eq!([1e-9 - limit, -limit - 1e-9].map(|value| limits.proof(value, width)), [inside, outside]);
    }
}

// oracle: hand
#[test]
fn without_uncertainty_a_limit_itself_is_good() {
    let limits = Limits { low: -1.0, high: 1.0 };
    for (value, good) in [(-1.0, 1.0), (1.0, 1.0), (1.1, 0.0), (-1.1, 0.0)] {
        assert_eq!(limits.chances(value, 0.0).good, good, "{value}");
    }
    assert_eq!(limits.chances(1.1, 0.0).high, 1.0);
    assert_eq!(limits.chances(-1.1, 0.0).low, 1.0);
}

// oracle: peer: tests/data/uncertainty.json: shares of a process, a hole that is too small can be cut again
#[test]
fn good_rework_and_scrap_of_a_process() {
    let [given, expect] = group("good_rework_scrap");
    let limits = Limits { low: number(&given, "lower"), high: number(&given, "upper") };
    let shares = limits.chances(number(&given, "mu"), number(&given, "s_process"));
    near(shares.good, number(&expect, "good"), 1e-12);
    near(shares.low, number(&expect, "bore_rework"), 1e-12);
    near(shares.high, number(&expect, "bore_scrap"), 1e-12);
}

// oracle: peer: tests/data/uncertainty.json: 50 parts; quantiles of chi-square are right to 1e-9
#[test]
fn capability_of_fifty_parts() {
    let [given, expect] = group("capability");
    let values = given["values"].as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect();
    let spread = Spread::of(values);
    near(spread.mean, number(&expect, "mean"), 1e-12);
    near(spread.deviation, number(&expect, "s"), 1e-12);
    let limits = Limits { low: number(&given, "lower"), high: number(&given, "upper") };
    let found = capability(&spread, limits).unwrap();
    near(found.cp, number(&expect, "Cm"), 1e-12);
    near(found.cpk, number(&expect, "Cmk"), 1e-12);
    for (name, interval) in [("Cm_interval", found.cp_interval), ("Cmk_interval", found.cpk_interval)] {
        for (at, end) in interval.into_iter().enumerate() {
            near(end, expect[name][at].as_f64().unwrap(), 1e-9);
        }
    }
    assert_eq!(capability(&Spread::of(vec![0.1; 50]), limits), None);
}

// oracle: peer: tests/data/uncertainty.json
#[test]
fn how_well_a_share_is_known() {
    let [given, expect] = group("how_many");
    let runs = number(&given, "N") as usize;
    near(share_error(number(&given, "p"), runs), number(&expect, "error_of_share"), 1e-12);
    near(unseen(runs), number(&expect, "no_event_upper_95"), 1e-9);
}

// oracle: peer: tests/data/uncertainty.json: standard deviations of a rectangle, a triangle and an arc sine
#[test]
fn drawn_shapes_have_their_deviation() {
    use super::draw::Shape;
    let [given, expect] = group("shapes");
    let half = number(&given, "a");
    for (shape, name) in [(Shape::Uniform, "rectangle"), (Shape::Triangular, "triangle"), (Shape::Arcsine, "arcsine")] {
        let source = Source::new(1, name);
        let spread = Spread::of((0..20_000).map(|index| shape.number(source, index, 0.0, half)).collect());
        assert!(spread.values.iter().all(|value| value.abs() <= half), "{name}");
        let off = (spread.deviation - number(&expect, name)).abs();
        assert!(off < 4.0 * spread.deviation_error, "{name} {} {off}", spread.deviation);
    }
}
