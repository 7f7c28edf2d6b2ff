//! Probes and settings of CYCLE977: mono and multi probes, turned coordinates, feeds, ways, units.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::tests::{CENTRE, hole};
use crate::catalogue::sinumerik::testing::{at, close, motions, stopped, turns};
use crate::control::Plane;
use crate::entry::names;
use crate::geometry::{Mcs, Rpy, Wcs};
use crate::machine::{MotionKind, Setup, Step, Stop};

/// The hole in coordinates that are turned by an angle about the tool axis.
fn turned(setup: &mut Setup, angle: f64) {
    setup.control.active.rotation = Rpy([0.0, 0.0, angle]);
    setup.position = setup.control.to_machine(Wcs([CENTRE[0], CENTRE[1], -10.0]));
    setup.workpiece.solids[0].at = setup.control.to_machine(Wcs([CENTRE[0], CENTRE[1], 0.0]));
}

/// A multi probe whose ball stands beside the spindle axis, calibrated with the spindle at 0
/// (triggers and skew in the order of B:13441-13452).
fn skewed(setup: &mut Setup) {
    setup.probe.skew = [0.3, -0.2];
    let data = [(1, 2.7), (2, -3.3), (3, 3.2), (4, -2.8), (7, 0.3), (8, -0.2)];
    data.iter().for_each(|(i, value)| setup.control.set(format!("_WP[0,{i}]"), *value));
}

#[test]
fn a_mono_probe_is_turned_before_each_touch() {
    // oracle: manual B:864-871, B:13624-13626; the ordinate is 270 degree of the spindle (B:13985)
    let (sim, outcome) = hole(|_, inputs| {
        inputs.numbers.extend([(names::PRNUM, 101.0), (names::CORA, 0.5)]);
    });
    assert_eq!(outcome, Ok(()));
    assert_eq!(turns(&sim), [0.5, 180.5, 270.5, 90.5]);
}

#[test]
fn a_multi_probe_may_turn_with_the_coordinates() {
    // oracle: manual B:13973-13987
    for (reverse, angle) in [(0.0, 330.0), (1.0, 30.0)] {
        let (sim, outcome) = hole(|setup, _| {
            setup.control.set("_CHBIT[13]", 1.0);
            setup.control.set("_CHBIT[14]", reverse);
            turned(setup, 30.0);
        });
        assert_eq!(outcome, Ok(()));
        assert!((sim.control.spindle.0 - angle).abs() < 1e-9, "{:?}", sim.control.spindle);
        close(&sim, "_OVR[4]", 60.0);
    }
}

#[test]
fn coordinates_that_turn_within_mirrored_ones_turn_the_probe_the_other_way() {
    // oracle: hand: a rotation by 40 degree in a frame that mirrors X is one by -40 on the machine. Only there the ball
    // is touched where it was calibrated, and the hole is found where it is.
    let (sim, outcome) = hole(|setup, _| {
        skewed(setup);
        setup.control.program_frame.rotation = Rpy([0.0, 0.0, 40.0]);
        mirrored(setup, [true, false, false]);
        setup.control.set("_CHBIT[13]", 1.0);
    });
    assert_eq!(outcome, Ok(()));
    assert!((sim.control.spindle.0 - 40.0).abs() < 1e-9);
    for (name, value) in [("_OVR[4]", 60.0), ("_OVR[17]", 0.0), ("_OVR[18]", 0.0)] {
        close(&sim, name, value);
    }
}

#[test]
fn the_fast_touch_is_followed_by_a_slow_one() {
    // oracle: manual B:13772
    let (sim, outcome) = hole(|setup, _| setup.control.set("_CHBIT[17]", 1.0));
    assert_eq!(outcome, Ok(()));
    let all = motions(&sim, Plane::G17, [0.0; 3]).into_iter();
    let measuring = all.filter(|(kind, ..)| *kind == MotionKind::Measuring);
    let feeds: Vec<f64> = measuring.map(|(_, _, feed)| feed).collect();
    assert_eq!(feeds, [900.0, 300.0, 900.0, 300.0, 900.0, 300.0, 900.0, 300.0]);
}

#[test]
fn results_count_in_the_active_units() {
    // oracle: hand (60 mm and a tolerance of 2.4 mm in inch)
    let (sim, outcome) = hole(|setup, _| setup.control.active_units = crate::control::Units::Inch);
    assert_eq!(outcome, Ok(()));
    close(&sim, "_OVR[0]", 60.0 / 25.4);
    close(&sim, "_OVR[8]", 2.4 / 25.4);
}

#[test]
fn a_skewed_multi_probe_with_calibrated_triggers_measures_right() {
    // oracle: hand: triggers and skew as sequence of B:13441-13452 with F2 and F3
    let (sim, outcome) = hole(|setup, _| skewed(setup));
    assert_eq!(outcome, Ok(()));
    for (name, value) in [("_OVR[4]", 60.0), ("_OVR[5]", 40.0), ("_OVR[6]", -25.0)] {
        close(&sim, name, value);
    }
}

#[test]
fn a_mono_probe_looks_along_turned_coordinates() {
    // oracle: hand: it switches in the direction of the motion only, which the frame turns by 30 degree
    let (sim, outcome) = hole(|setup, inputs| {
        turned(setup, 30.0);
        inputs.numbers.insert(names::PRNUM, 101.0);
    });
    assert_eq!(outcome, Ok(()));
    for (found, wanted) in turns(&sim).iter().zip([330.0, 150.0, 240.0, 60.0]) {
        assert!((found - wanted).abs() < 1e-9, "{:?}", turns(&sim));
    }
    close(&sim, "_OVR[4]", 60.0);
}

#[test]
fn a_skewed_multi_probe_has_to_turn_with_the_coordinates() {
    // oracle: manual B:13973-13987 (the same places of the ball are touched as in calibration, by default), and hand:
    // without coupling the cycle takes the skew as that of the WCS, where it is turned back by the angle.
    let case = |coupled: f64| {
        let (sim, outcome) = hole(|setup, _| {
            skewed(setup);
            turned(setup, 40.0);
            setup.control.set("_CHBIT[13]", coupled);
        });
        assert_eq!(outcome, Ok(()));
        sim
    };
    let sim = case(1.0);
    for (name, value) in [("_OVR[4]", 60.0), ("_OVR[17]", 0.0), ("_OVR[18]", 0.0)] {
        close(&sim, name, value);
    }
    let sim = case(0.0);
    let (sine, cosine) = 40.0_f64.to_radians().sin_cos();
    let real = [0.3 * cosine - 0.2 * sine, -0.2 * cosine - 0.3 * sine];
    close(&sim, "_OVR[4]", 60.0);
    close(&sim, "_OVR[17]", 0.3 - real[0]);
    close(&sim, "_OVR[18]", -0.2 - real[1]);
}

#[test]
fn ways_and_retraction_have_their_feeds() {
    // oracle: manual B:13743-13778, B:14005-14007; 0 is rapid traverse
    for (monitored, fast, way, kind, back) in [
        (1.0, 0.0, 1200.0, MotionKind::Positioning, 1200.0),
        (1.0, 1.0, 1200.0, MotionKind::Positioning, 0.0),
        (0.0, 0.0, 0.0, MotionKind::Rapid, 0.0),
        (0.0, 1.0, 0.0, MotionKind::Rapid, 0.0),
    ] {
        let (sim, outcome) = hole(|setup, _| {
            let data = [("_CHBIT[2]", monitored), ("_CHBIT[16]", fast), ("_SPEED[1]", 1200.0)];
            data.iter().for_each(|(name, value)| setup.control.set(*name, *value));
        });
        assert_eq!(outcome, Ok(()));
        for (found, _, feed) in motions(&sim, Plane::G17, [0.0; 3]) {
            match found {
                MotionKind::Measuring => assert_eq!(feed, 300.0),
                MotionKind::Retract => assert_eq!(feed, back),
                other => assert_eq!((other, feed), (kind, way)),
            }
        }
    }
}

#[test]
fn without_monitoring_a_collision_is_a_crash() {
    // oracle: manual B:13766 (the user must ensure that collisions are ruled out)
    let (sim, outcome) = hole(|setup, inputs| {
        setup.control.set("_CHBIT[2]", 0.0);
        inputs.numbers.insert(names::SETVAL, 80.0);
    });
    assert!(matches!(outcome, Err(Stop::Fault(_))));
    let crash = |step: &Step| matches!(step, Step::Crash { .. });
    assert!(sim.trace.entries.iter().any(|entry| crash(&entry.step)));
}

#[test]
fn a_probe_calibrated_otherwise_is_refused() {
    // oracle: manual B:13658-13667; 17: the plane, 1: L1 to the centre of the ball
    let case = |plane: f64, reference: f64, monitored: f64| {
        let (_, outcome) = hole(|setup, _| {
            let data = [("_WP[0,9]", plane), ("_WP[0,10]", reference), ("_CBIT[16]", monitored)];
            data.iter().for_each(|(name, value)| setup.control.set(*name, *value));
        });
        outcome
    };
    assert_eq!(case(17.0, 1.0, 1.0), Ok(()));
    for (plane, reference) in [(18.0, 1.0), (117.0, 1.0), (17.0, 2.0)] {
        assert_eq!(stopped(case(plane, reference, 1.0)), 61341);
        assert_eq!(case(plane, reference, 0.0), Ok(()));
    }
}

#[test]
fn the_coarse_part_takes_the_fine_one_in() {
    // oracle: manual B:14035-14039: a hole 0.5 mm off, with 0.1 mm in the fine part before
    for (bit, coarse, fine) in [(0.0, 0.0, 0.6), (1.0, 0.6, 0.0)] {
        let (sim, outcome) = hole(|setup, inputs| {
            let frame = crate::control::Frame { fine: [0.1, 0.0, 0.0], ..Default::default() };
            setup.control.frames.insert(1, frame);
            setup.control.activate(1);
            setup.control.set("MD18600", 1.0);
            setup.control.set("_CHBIT[21]", bit);
            setup.workpiece.solids[0].errors.shift = [0.6, 0.0, 0.0];
            setup.position = Mcs(at(Plane::G17, [CENTRE[0] + 0.1, CENTRE[1], -10.0]));
            inputs.variant = 101;
            inputs.numbers.insert(names::KNUM, 1.0);
        });
        assert_eq!(outcome, Ok(()));
        close(&sim, "_OVR[17]", 0.5);
        let frame = sim.control.frames[&1];
        assert!((frame.coarse[0] - coarse).abs() < 1e-9, "{frame:?}");
        assert!((frame.fine[0] - fine).abs() < 1e-9, "{frame:?}");
    }
}

#[test]
fn a_programmed_stop_follows_an_alarm_that_informs() {
    // oracle: manual B:13584-13586
    let halts = |bit: f64| {
        let (sim, outcome) = hole(|setup, inputs| {
            setup.control.set("_CBIT[2]", bit);
            setup.workpiece.solids[0].errors.size = 0.7;
            inputs.numbers.extend([(names::TUL, 0.5), (names::TLL, -0.5)]);
        });
        assert_eq!(outcome, Ok(()));
        let halt = |step: &Step| matches!(step, Step::Decision { message } if message.key == "evaluate-halt");
        sim.trace.entries.iter().filter(|entry| halt(&entry.step)).count()
    };
    assert_eq!((halts(0.0), halts(1.0)), (0, 1));
}

/// The hole in coordinates of which some axes are mirrored.
fn mirrored(setup: &mut Setup, axes: [bool; 3]) {
    setup.control.active.mirror = axes;
    setup.position = setup.control.to_machine(Wcs([CENTRE[0], CENTRE[1], -10.0]));
    setup.workpiece.solids[0].at = setup.control.to_machine(Wcs([CENTRE[0], CENTRE[1], 0.0]));
}

#[test]
fn mirrored_axes_take_the_values_of_the_other_direction() {
    // oracle: manual B:6153 (mirroring can be active), hand (the hole as it was made)
    for axes in [[true, false, false], [false, true, false], [true, true, false]] {
        let (sim, outcome) = hole(|setup, _| {
            skewed(setup);
            mirrored(setup, axes);
            setup.workpiece.solids[0].errors.shift = [0.4, 0.7, 0.0];
        });
        assert_eq!(outcome, Ok(()));
        let seen = |axis: usize, way: f64| if axes[axis] { -way } else { way };
        close(&sim, "_OVR[4]", 60.0);
        close(&sim, "_OVR[17]", seen(0, 0.4));
        close(&sim, "_OVR[18]", seen(1, 0.7));
    }
}

#[test]
fn a_mono_probe_looks_where_a_mirrored_axis_goes() {
    // oracle: hand: plus abscissa is minus on the machine
    let (sim, outcome) = hole(|setup, inputs| {
        mirrored(setup, [true, false, false]);
        inputs.numbers.insert(names::PRNUM, 101.0);
    });
    assert_eq!(outcome, Ok(()));
    assert_eq!(turns(&sim), [180.0, 0.0, 270.0, 90.0]);
}
