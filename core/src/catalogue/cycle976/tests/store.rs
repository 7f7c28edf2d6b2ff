//! What CYCLE976 stores and reports, and what it refuses to.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::params::{HOLE, LENGTH};
use super::super::{CYCLE976, VARIANTS};
use super::simulate::{close, inputs, mm, ready, ring};
use crate::catalogue::sinumerik::testing::{alarms, run, stopped};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::machine::{Entry, Setup, Sim, Step};
use crate::message::Message;

#[test]
fn only_what_lies_between_the_limits_is_stored() {
    // oracle: manual B:5134, B:5148
    let worn = |setup: &mut Setup, _: &mut Inputs| setup.probe.radius = 2.95;
    let (sim, outcome) = ring(101, |setup, inputs| {
        worn(setup, inputs);
        inputs.numbers.insert(names::TSA, 0.04);
    });
    assert_eq!(stopped(outcome), 61303);
    assert_eq!((mm(&sim.control, 0), mm(&sim.control, 1)), (6.0, 3.0));
    close(sim.control.number("_OVR[9]"), -0.05, "told all the same");
    let (sim, outcome) = ring(101, |setup, inputs| {
        worn(setup, inputs);
        inputs.numbers.insert(names::TZL, 0.06);
    });
    assert_eq!(outcome, Ok(()));
    assert_eq!(mm(&sim.control, 1), 3.0);
    close(mm(&sim.control, 0), 5.9, "the diameter differs by more");
    let kept = Message::new("evaluate-kept").number("limit", 0.06);
    let kept = kept.text("data", "_WP[0,2], _WP[0,1], _WP[0,4], _WP[0,3]");
    let told = |entry: Entry| entry.step == Step::Decision { message: kept.clone() };
    assert!(sim.trace.entries.iter().any(told));
    let first = |area: f64| {
        ring(101, |setup, inputs| {
            (0..9).for_each(|field| setup.control.set(format!("_WP[0,{field}]"), 0.0));
            inputs.numbers.insert(names::TSA, area);
        })
    };
    assert_eq!(stopped(first(2.9).1), 61303);
    let (sim, outcome) = first(3.1);
    assert_eq!(outcome, Ok(()));
    close(mm(&sim.control, 0), 6.0, "first calibration");
}

#[test]
fn a_violated_safe_area_is_measured_again() {
    // oracle: manual B:13572-13580
    let (sim, outcome) = ring(1001, |setup, inputs| {
        setup.control.set("_CBIT[0]", 1.0);
        setup.control.set("_CBIT[1]", 1.0);
        setup.probe.radius = 2.5;
        inputs.numbers.insert(names::TSA, 0.1);
    });
    assert_eq!(stopped(outcome), 61303);
    assert_eq!(alarms(&sim), [62303; 4]);
    let touched = |entry: &Entry| matches!(entry.step, Step::Touch { .. });
    assert_eq!(sim.trace.entries.iter().filter(touched).count(), 5);
}

#[test]
fn the_ball_goes_into_the_tool_on_demand() {
    // oracle: manual B:13656
    for (bit, radius) in [(0.0, 3.0), (1.0, 2.9)] {
        let (sim, outcome) = ring(101, |setup, _| {
            setup.control.set("_CBIT[15]", bit);
            setup.probe.radius = 2.9;
        });
        assert_eq!(outcome, Ok(()));
        close(sim.control.variable("$TC_DP6[9,1]").unwrap(), radius, "radius");
    }
}

#[test]
fn every_result_of_the_entry_is_written_and_no_other() {
    // oracle: self (the entry, which a test holds against the manual's tables)
    for variant in VARIANTS {
        for (axis, direction) in [(1.0, 0.0), (2.0, 1.0), (3.0, 1.0), (3.0, 0.0)] {
            let inputs = inputs(variant.number, axis, direction);
            if (axis == 3.0) == HOLE.holds(&inputs) || axis < 3.0 && LENGTH.holds(&inputs) {
                continue;
            }
            let mut setup = ready(Plane::G17, &inputs);
            setup.probe.stylus = Some(0.0); // a straight one stands in the way of the applicate in plus direction
            let mut sim = Sim::new(&setup);
            assert_eq!(run(&mut sim, &inputs), Ok(()));
            let mut written: Vec<&str> = Vec::new();
            for entry in sim.trace.entries.others() {
                match entry.step {
                    Step::Set { name, .. } if name.starts_with("_OV") => written.push(name),
                    _ => {}
                }
            }
            let mut wanted: Vec<&str> =
                CYCLE976.results.iter().filter(|field| field.when.holds(&inputs)).map(|field| field.name).collect();
            written.sort_unstable();
            wanted.sort_unstable();
            assert_eq!(written, wanted, "{} {axis} {direction}", variant.number);
        }
    }
}

#[test]
fn a_calibration_says_how_it_was_made() {
    // oracle: manual B:13658-13667; what another measurement then sees stands in `sinumerik::calibrated_as`
    for (plane, number) in [(Plane::G17, 17.0), (Plane::G18, 18.0), (Plane::G19, 19.0)] {
        for (probe, kind) in [(1.0, 0.0), (101.0, 100.0)] {
            let mut inputs = inputs(1, 1.0, 0.0);
            inputs.numbers.insert(names::PRNUM, probe);
            let mut sim = Sim::new(&ready(plane, &inputs));
            assert_eq!(run(&mut sim, &inputs), Ok(()));
            let noted = [9, 10].map(|field| sim.control.number(&format!("_WP[0,{field}]")));
            assert_eq!(noted, [number + kind, 1.0]);
        }
    }
    let (sim, outcome) = ring(1, |setup, inputs| {
        setup.probe.radius = 2.5;
        inputs.numbers.insert(names::TSA, 0.1);
    });
    assert_eq!(stopped(outcome), 61303);
    assert_eq!(sim.control.number("_WP[0,9]"), 0.0, "nothing was stored");
}

#[test]
fn the_tool_keeps_its_radius_where_the_diameter_is_kept() {
    // oracle: manual B:13656 (what goes into the tool is _WP[k,0]), B:5134 (which is stored beyond _TZL); hand (2 *
    // 0.03 mm)
    for (zone, radius) in [(0.05, 2.97), (0.07, 3.0)] {
        let (sim, outcome) = ring(101, |setup, inputs| {
            setup.control.set("_CBIT[15]", 1.0);
            setup.probe.radius = 2.97;
            inputs.numbers.insert(names::TZL, zone);
        });
        assert_eq!(outcome, Ok(()));
        close(mm(&sim.control, 0), 2.0 * radius, "diameter");
        let entered = sim.control.variable("$TC_DP6[9,1]").unwrap();
        close(entered, radius, "radius of the tool");
    }
}
