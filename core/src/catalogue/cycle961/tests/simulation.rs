//! CYCLE961 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::lines::Point;
use super::super::params::PLACES;
use super::bench::{Case, Real, cases, close_angle, done};
use crate::catalogue::sinumerik::testing::{at, called, close, put, random_parts, stopped};
use crate::control::{Frame, Plane, Units};
use crate::entry::{Inputs, names};
use crate::geometry::{Mcs, Rpy};
use crate::machine::{Setup, Sim, Stop};
use crate::name::Name;
use crate::workpiece::Shape;
use proptest::prelude::*;

proptest! {
    #![proptest_config(random_parts(1))]

    /// The corner and the direction of the reference edge are found again, in the WCS and in the machine, whatever the
    /// opening, its sense and how wrong the set angles are, in mirrored coordinates too.
    #[test]
    fn the_corner_is_recovered(case in cases(), mirrored in any::<bool>()) {
        let mut case = case;
        case.frame.mirror[case.plane.axes()[1]] = mirrored;
        let (setup, inputs) = case.ready();
        let sim = done(&setup, &inputs);
        // oracle: hand (the part as it was made)
        let Real { corner: [x, y], edge, .. } = case.real;
        let axes = case.plane.axes();
        close_angle(&sim, "_OVR[4]", edge);
        close(&sim, "_OVR[5]", x);
        close(&sim, "_OVR[6]", y);
        let machine = setup.workpiece.solids[0].at;
        close_angle(&sim, "_OVR[20]", case.in_machine(edge));
        close(&sim, "_OVR[21]", machine[axes[0]]);
        close(&sim, "_OVR[22]", machine[axes[1]]);
        for (name, value) in [("_OVI[2]", 961.0), ("_OVI[3]", case.variant as f64), ("_OVI[5]", 1.0), ("_OVI[9]",
            0.0)] {
            close(&sim, name, value);
        }
        // manual B:8016, B:8170: back at the start, or over P4 at positioning height
        let end = case.plane.axes().map(|axis| sim.control.to_workpiece(sim.position)[axis]);
        let start = case.plane.axes().map(|axis| setup.control.to_workpiece(setup.position)[axis]);
        let wanted = if case.by_points() {
            let [.., p4] = case.places();
            [p4[0], p4[1], start[2]]
        } else {
            start
        };
        for (is, wanted) in end.iter().zip(wanted) {
            prop_assert!((is - wanted).abs() < 1e-9, "{:?} {:?}", end, wanted);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// With the corrected frame the corner is its zero and the reference edge its abscissa, in every frame that can be
    /// corrected; the applicate and its place stay.
    #[test]
    fn the_corner_becomes_the_zero(
        case in cases(), target in prop::sample::select(vec![1, 2, 1011, 2000, 9999]), beside in 1..5_u8,
        mirrored in any::<bool>(),
    ) {
        let mut case = case;
        case.frame.mirror[case.plane.axes()[1]] = mirrored;
        let (mut setup, mut inputs) = case.ready();
        setup.control.frames.insert(2, Frame {
            coarse: [11.0, 22.0, 33.0],
            fine: [0.5, 0.25, 0.125],
            rotation: Rpy(at(case.plane, [0.0, 0.0, 50.0])),
            ..Frame::default()
        });
        inputs.numbers.insert(names::KNUM, f64::from(target));
        if case.variant <= 106 {
            inputs.numbers.insert(names::SETV4, f64::from(beside));
        }
        let wanted = match (case.variant <= 106, beside) {
            (true, 2) => [-7.0, 0.0],
            (true, 3) => [-7.0, 4.0],
            (true, 4) => [0.0, 4.0],
            _ => [0.0; 2],
        };
        let applicate = case.plane.axes()[2];
        let frames = setup.control.frames.clone();
        setup.control = done(&setup, &inputs).control;
        if target != 9999 {
            setup.control.activate(if target == 2 { 2 } else { 1 });
        }
        let seen = setup.control.to_workpiece(setup.workpiece.solids[0].at);
        let found = case.plane.axes().map(|axis| seen[axis]);
        prop_assert!((found[0] - wanted[0]).abs() < 1e-9 && (found[1] - wanted[1]).abs() < 1e-9, "{:?}", found);
        if let Some(before) = frames.get(&(target as usize)) {
            let corrected = setup.control.frames[&(target as usize)];
            prop_assert_eq!(corrected.fine, [0.0; 3]);
            prop_assert_eq!(corrected.origin()[applicate], before.origin()[applicate]);
        }
        if !case.by_points() {
            let sim = done(&setup, &inputs);
            close_angle(&sim, "_OVR[4]", 0.0);
            close(&sim, "_OVR[5]", wanted[0]);
            close(&sim, "_OVR[6]", wanted[1]);
        }
    }

    /// A ball beside the spindle axis changes nothing once it is calibrated.
    #[test]
    fn a_calibrated_skew_does_not_count(skew in prop::array::uniform2(-0.4..0.4_f64), case in cases()) {
        let case = Case { plane: Plane::G17, frame: Frame::default(), ..case };
        let (mut setup, inputs) = case.ready();
        setup.probe.skew = skew;
        for (axis, skew) in skew.into_iter().enumerate() {
            setup.control.set(format!("_WP[0,{}]", 2 * axis + 1), 3.0 - skew);
            setup.control.set(format!("_WP[0,{}]", 2 * axis + 2), -3.0 - skew);
            setup.control.set(format!("_WP[0,{}]", 7 + axis), skew);
        }
        let sim = done(&setup, &inputs);
        close(&sim, "_OVR[5]", case.real.corner[0]);
        close(&sim, "_OVR[6]", case.real.corner[1]);
        close_angle(&sim, "_OVR[4]", case.real.edge);
    }
}

/// The outside corner of 80 degree with something changed.
fn corner(change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), Stop>) {
    let case = Case {
        variant: 108,
        plane: Plane::G17,
        frame: Frame::default(),
        real: Real { corner: [20.0, 10.0], edge: -35.0, opening: 80.0 },
        wrong: [0.0; 2],
    };
    let (mut setup, mut inputs) = case.ready();
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn without_a_target_nothing_is_corrected() {
    // oracle: manual B:7842
    let (sim, outcome) = corner(|_, inputs| _ = inputs.numbers.insert(names::KNUM, 0.0));
    assert_eq!(outcome, Ok(()));
    assert_eq!(sim.control.frames[&1], Frame::default());
    close(&sim, "_OVR[5]", 20.0);
}

#[test]
fn an_inch_machine_finds_the_same_corner() {
    // oracle: self (B:1787-1795)
    let (sim, outcome) = corner(|setup, _| {
        let inch = Setup::calibrated_in(crate::dialect::Dialect::Sinumerik, Plane::G17, Units::Inch);
        setup.control = inch.control;
    });
    assert_eq!(outcome, Ok(()));
    close(&sim, "_OVR[5]", 20.0 / 25.4);
    close(&sim, "_OVR[22]", 10.0 / 25.4);
    close_angle(&sim, "_OVR[4]", -35.0);
    let frame = sim.control.frames[&1];
    assert!((frame.coarse[0] - 20.0).abs() < 1e-9 && (frame.coarse[1] - 10.0).abs() < 1e-9);
}

#[test]
fn alarms_stop() {
    // oracle: manual A:15842-15922
    let value = |name: Name, value: f64| stopped(corner(|_, inputs| put(inputs, name.as_str(), value)).1);
    assert_eq!(value(names::KNUM, 100.0), 61321);
    assert_eq!(value(names::FA, 0.0), 61308);
    // the way to P2 leads into the part
    assert_eq!(value(names::STA1, 5.0), 61302);
    // P4 lies beyond the end of the part
    assert_eq!(value(names::SETV1, 900.0), 61301);
    let limited = corner(|setup, _| setup.control.limits.plus[1] = Some(-40.0));
    assert_eq!(stopped(limited.1), 61401);
}

#[test]
fn a_measured_corner_may_be_none_though_the_points_make_one() {
    // oracle: manual A:15912-15913, hand: four points of one straight face; a rib that ends before the middle of a face
    let outcome = |variant, blocks: &[([f64; 3], [f64; 3])], places: [Point; 4]| {
        stopped(
            corner(|setup, inputs| {
                let solid = setup.workpiece.solids[0].clone();
                let block = |(size, at): &([f64; 3], [f64; 3])| crate::workpiece::Solid {
                    shape: Shape::Block { size: *size },
                    at: Mcs(*at),
                    rotation: Rpy::default(),
                    ..solid.clone()
                };
                setup.workpiece.solids = blocks.iter().map(block).collect();
                setup.position = Mcs([0.0, -20.0, 25.0]);
                inputs.variant = variant;
                inputs.numbers.insert(names::ID, -40.0);
                for (names, place) in PLACES.into_iter().zip(places) {
                    inputs.numbers.extend([(names[0], place[0]), (names[1], place[1])]);
                }
            })
            .1,
        )
    };
    let face = ([400.0, 40.0, 60.0], [0.0, 20.0, 0.0]);
    let places = [[0.0, -20.0], [40.0, -22.0], [60.0, -22.0], [100.0, -20.0]];
    assert_eq!(outcome(118, &[face], places), 61368);
    let rib = ([10.0, 80.0, 60.0], [75.0, -55.0, 0.0]);
    let places = [[0.0, -20.0], [100.0, -20.0], [60.0, -30.0], [60.0, -60.0]];
    assert_eq!(outcome(117, &[face, rib], places), 61369);
}
