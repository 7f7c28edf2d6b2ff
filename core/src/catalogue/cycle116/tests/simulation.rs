//! CYCLE116 called by programs with variables of their own, which copy what they get into R parameters.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::sinumerik::testing::random_parts;
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::machine::Setup;
use crate::run::{Limits, Outcome, run};
use crate::syntax::read;
use proptest::prelude::*;

/// Runs a call with these contents of the array; R1 to R3 are centre and radius, R4 the status, R5 the alarm number.
fn computed(units: &str, values: &[f64]) -> Outcome {
    let values: Vec<String> = values.iter().map(f64::to_string).collect();
    let text = format!(
        "DEF INT FAULT\nDEF REAL P[13]\nG17 {units}\nP[0]=SET({})\nP[12]=7\nCYCLE116(P,FAULT)\n\
        R1=P[9] R2=P[10] R3=P[11] R4=P[12] R5=FAULT\nM30\n",
        values.join(",")
    );
    let outcome = run(
        &read(Dialect::Sinumerik, text.as_bytes()),
        &Setup::calibrated(Dialect::Sinumerik, Plane::G17),
        Limits::default(),
    );
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    outcome
}

fn numbers(outcome: &Outcome) -> [f64; 5] {
    ["R1", "R2", "R3", "R4", "R5"].map(|name| outcome.control.number(name))
}

#[test]
fn the_example_of_the_manual() {
    // oracle: manual B:2456-2466
    let outcome = computed("G71", &[3.0, 0.0, 10.0, -10.0, 0.0, 0.0, -10.0]);
    let [x, y, radius, status, alarm] = numbers(&outcome);
    assert!(x.abs() < 1e-12 && y.abs() < 1e-12 && (radius - 10.0).abs() < 1e-12);
    assert_eq!([status, alarm], [0.0; 2]);
    // the program's own variables took the results; the names of the cycle are no data of the control
    assert_eq!(outcome.control.data.get("_DATE[9]"), None);
}

#[test]
fn what_is_wrong_is_handed_back() {
    // oracle: manual B:2447-2448, A:15857-15858
    for (values, alarm) in [
        (&[3.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0][..], 61316.0),
        (&[4.0, 5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 5.0], 61316.0),
        // a row that goes up and down in turn bends nowhere: no circle is as near as the line
        (&[4.0, 0.0, 0.0, 1.0, 1e-7, 2.0, 0.0, 3.0, 1e-7], 61316.0),
        (&[4.0, 0.0, 0.0, 1.0, 0.1, 2.0, 0.0, 3.0, 0.1], 61316.0),
        (&[2.0, 0.0, 0.0, 1.0, 1.0], 61317.0),
        (&[5.0, 0.0, 10.0, -10.0, 0.0, 0.0, -10.0], 61317.0),
        (&[3.5, 0.0, 10.0, -10.0, 0.0, 0.0, -10.0], 61317.0),
    ] {
        let outcome = computed("G71", values);
        assert_eq!(numbers(&outcome), [0.0, 0.0, 0.0, 1.0, alarm], "{values:?}");
        assert_eq!(outcome.alarms(), []);
    }
}

#[test]
fn an_array_that_is_too_short_is_told_at_its_place() {
    // oracle: manual B:2416 (the array has 13 elements)
    for text in [
        "DEF INT FAULT\nDEF REAL P[9]=SET(3,0,10,-10,0,0,-10)\nCYCLE116(P,FAULT)\nM30\n",
        "DEF REAL P[13]=SET(3,0,10,-10,0,0,-10)\nCYCLE116(P,5)\nM30\n",
    ] {
        let outcome = run(
            &read(Dialect::Sinumerik, text.as_bytes()),
            &Setup::calibrated(Dialect::Sinumerik, Plane::G17),
            Limits::default(),
        );
        assert!(outcome.stop.is_some(), "{text}");
        let place = outcome.diagnostics[0].span.unwrap();
        assert!(text[place.start as usize..].starts_with("CYCLE116"), "{text}");
    }
}

proptest! {
    #![proptest_config(random_parts(1))]

    // oracle: hand (points laid on a circle; numbers have no unit here, so that G70 changes nothing)
    #[test]
    fn points_of_a_circle_give_it_back(
        centre in [-500.0..500.0_f64, -500.0..500.0_f64], radius in 0.5..200.0_f64, first in 0.0..360.0_f64,
        step in 40.0..85.0_f64, four in any::<bool>(), inch in any::<bool>(),
    ) {
        let count = if four { 4 } else { 3 };
        let mut values = vec![f64::from(count)];
        for index in 0..count {
            let (sine, cosine) = (first + f64::from(index) * step).to_radians().sin_cos();
            values.extend([centre[0] + radius * cosine, centre[1] + radius * sine]);
        }
        let outcome = computed(if inch { "G70" } else { "G71" }, &values);
        let [x, y, found, status, alarm] = numbers(&outcome);
        prop_assert!((x - centre[0]).abs() < 1e-9 && (y - centre[1]).abs() < 1e-9, "{} {}", x, y);
        prop_assert!((found - radius).abs() < 1e-9, "{}", found);
        prop_assert_eq!([status, alarm], [0.0, 0.0]);
    }
}
