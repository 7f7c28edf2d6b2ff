//! CYCLE974 on the simulated machine: how it moves, what it finds and corrects.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::lathe::testing::{inputs, placed, setup};
use crate::catalogue::sinumerik::motion_testing::{MEASURING_FEED, PLANE_FEED};
use crate::catalogue::sinumerik::testing;
use crate::catalogue::sinumerik::testing::{Motion, called, close, motions, run, same, stopped};
use crate::control::{Plane, Transverse, Units};
use crate::entry::{Inputs, names};
use crate::geometry::Degrees;
use crate::machine::{MotionKind, Setup, Sim, Stop};
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
const VARIANTS: [f64; 3] = [0.0, 100.0, 1000.0];

/// A call in one axis (0 abscissa), with a setpoint.
fn call(plane: Plane, variant: f64, axis: usize, set: f64) -> Inputs {
    let values = [("_MVAR", variant), ("_MA", axis as f64 + 1.0), ("_SETVAL", set)];
    inputs("CYCLE974", plane, &values)
}

/// How much a dimension is of a length: diameters in X (B:10623).
fn per(plane: Plane, transverse: Transverse, axis: usize) -> f64 {
    match plane.axes()[axis] {
        0 => transverse.shown(),
        _ => 1.0,
    }
}

/// Motions of an outside diameter of 45 mm, `_FA` = 5, ball 3: from X 53 + 10 to the contact at 25.5 and back to 30.5,
/// as radii in the ordinate.
fn touch(feed: f64) -> Vec<Motion> {
    vec![(MotionKind::Measuring, [0.0, 25.5, 0.0], feed), (MotionKind::Retract, [0.0, 30.5, 0.0], PLANE_FEED)]
}

#[test]
fn only_the_measuring_axis_moves() {
    // oracle: manual B:10513-10523, B:10784, B:1111-1121, hand (figures)
    let plane = Plane::G18;
    for (variant, repeats, turns) in
        [(0.0, 1.0, &[][..]), (0.0, 3.0, &[]), (100.0, 1.0, &[]), (1000.0, 2.0, &[30.0, 210.0])]
    {
        let mut call = call(plane, variant, 1, 45.0);
        call.numbers.extend([(names::NMSP, repeats), (names::STA1, 30.0)]);
        let mut setup = placed(setup(plane, Transverse::Diameter), &call);
        setup.control.set("_SPEED[1]", PLANE_FEED);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        let mut expected = vec![(MotionKind::Positioning, [0.0, 30.5, 0.0], PLANE_FEED)];
        let touches = repeats * turns.len().max(1) as f64;
        (0..touches as usize).for_each(|_| expected.extend(touch(MEASURING_FEED)));
        let origin = [0.0, 0.0, 250.0];
        same(&motions(&sim, plane, origin), &expected, &format!("{variant} {repeats}"));
        assert_eq!(testing::turns(&sim), turns);
    }
}

/// What the call has to find on the proposed part with these errors, in the measuring axis: with reversal an
/// eccentricity is gone.
fn expected(geometry: usize, variant: f64, set: f64, shift: f64, size: f64) -> f64 {
    let side = if set < 0.0 { -1.0 } else { 1.0 };
    match geometry {
        2 => set + shift,
        _ if variant == 1000.0 => set + side * size / 2.0,
        _ => set + side * size / 2.0 + shift,
    }
}

/// A part with errors along the measuring axis, and the call carried out on it.
fn measured(
    (plane, transverse, variant, axis, set): (Plane, Transverse, f64, usize, f64),
    shift: f64,
    size: f64,
) -> (Sim, Result<(), Stop>) {
    let dimension = set * per(plane, transverse, axis);
    let mut call = call(plane, variant, axis, dimension);
    call.numbers.insert(names::STA1, 0.0);
    let mut setup = placed(setup(plane, transverse), &call);
    let part = &mut setup.workpiece.solids[0];
    part.errors.shift[plane.axes()[axis]] = shift;
    part.errors.size = size;
    called(&setup, &call)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    // oracle: hand (the part as it was made)
    #[test]
    fn the_dimension_is_found(
        set in 12.0..80.0_f64, minus in any::<bool>(), shift in -0.5..0.5_f64, size in -0.5..0.5_f64,
        radius in any::<bool>(),
    ) {
        let transverse = if radius { Transverse::Radius } else { Transverse::Diameter };
        for plane in PLANES {
            for axis in 0..3 {
                let geometry = plane.axes()[axis];
                let set = if minus && geometry != 2 { -set } else { set };
                for variant in VARIANTS {
                    let (sim, outcome) = measured((plane, transverse, variant, axis, set), shift, size);
                    prop_assert_eq!(outcome, Ok(()));
                    let per = per(plane, transverse, axis);
                    let actual = expected(geometry, variant, set, shift, size) * per;
                    close(&sim, "_OVR[0]", set * per);
                    close(&sim, &format!("_OVR[{}]", 1 + axis), set * per);
                    close(&sim, "_OVR[4]", actual);
                    close(&sim, &format!("_OVR[{}]", 5 + axis), actual);
                    close(&sim, "_OVR[16]", actual - set * per);
                    close(&sim, &format!("_OVR[{}]", 17 + axis), actual - set * per);
                }
            }
        }
    }
}

/// Which geometry length of a turning tool works in an axis of the plane (B:974-985).
const LENGTHS: [&str; 3] = ["$TC_DP13[7,1]", "$TC_DP12[7,1]", "$TC_DP14[7,1]"];

#[test]
fn a_corrected_tool_makes_the_next_part_right() {
    // oracle: manual B:8945-8947, B:10743-10748: the length is longer by so much that the tool stands further out
    for plane in PLANES {
        for (axis, length) in LENGTHS.into_iter().enumerate() {
            let geometry = plane.axes()[axis];
            for transverse in [Transverse::Diameter, Transverse::Radius] {
                let case = (plane, transverse, 0.0, axis, 30.0);
                let (shift, size) = if geometry == 2 { (0.3, 0.0) } else { (0.0, 0.6) };
                let (sim, outcome) = measured(case, shift, size);
                assert_eq!(outcome, Ok(()));
                let longer = sim.control.variable(length).unwrap();
                assert!((longer + 0.3).abs() < 1e-9, "{longer}");
                close(&sim, "_OVR[20]", -0.3);
                let (again, size) = match geometry {
                    2 => (shift + longer, 0.0),
                    _ => (0.0, size + 2.0 * longer),
                };
                let (sim, outcome) = measured(case, again, size);
                assert_eq!(outcome, Ok(()));
                close(&sim, "_OVR[16]", 0.0);
            }
        }
    }
}

#[test]
fn a_corrected_zero_offset_gives_the_setpoint() {
    // oracle: manual B:10525, B:2003
    for plane in PLANES {
        for axis in 0..3 {
            let transverse = Transverse::Diameter;
            let dimension = 30.0 * per(plane, transverse, axis);
            let call = call(plane, 100.0, axis, dimension);
            let mut setup = placed(setup(plane, transverse), &call);
            let geometry = plane.axes()[axis];
            setup.workpiece.solids[0].errors.shift[geometry] = 0.4;
            let mut sim = Sim::new(&setup);
            assert_eq!(run(&mut sim, &call), Ok(()));
            let fine = ["X", "Y", "Z"][geometry];
            let moved = sim.control.variable(&format!("$P_UIFR[1,{fine},FI]")).unwrap();
            assert!((moved - 0.4).abs() < 1e-9, "{moved}");
            close(&sim, "_OVI[11]", 1.0);
            sim.control.activate(1);
            assert_eq!(run(&mut sim, &call), Ok(()));
            close(&sim, "_OVR[16]", 0.0);
        }
    }
}

#[test]
fn y_counts_like_x_with_its_bit() {
    // oracle: manual B:14023-14027: setpoint as a diameter, offset in L1, zero offset in X
    let plane = Plane::G18;
    for variant in [0.0, 100.0] {
        let mut call = call(plane, variant, 2, 60.0);
        call.settings.insert("_CHBIT[19]", 1.0);
        let mut setup = placed(setup(plane, Transverse::Diameter), &call);
        setup.control.set("_CHBIT[19]", 1.0);
        setup.workpiece.solids[0].errors.shift[1] = 0.2;
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        close(&sim, "_OVR[7]", 60.4);
        close(&sim, "_OVR[19]", 0.4);
        let value = |name: &str| sim.control.variable(name).unwrap_or(0.0);
        if variant == 0.0 {
            assert!((value("$TC_DP12[7,1]") + 0.2).abs() < 1e-9);
        } else {
            assert!((value("$P_UIFR[1,X,FI]") - 0.2).abs() < 1e-9);
            assert_eq!(value("$P_UIFR[1,Y,FI]"), 0.0);
        }
    }
}

#[test]
fn empirical_value_and_radius() {
    // oracle: manual B:1302, B:13924-13926; a radius outside grows smaller (sign as in milling)
    let plane = Plane::G18;
    let mut call = call(plane, 0.0, 1, 60.0);
    call.numbers.extend([(names::EVNUM, 1.0), (names::KNUM, 2001.0)]);
    let mut setup = placed(setup(plane, Transverse::Diameter), &call);
    setup.control.set("_EV[0]", 0.1);
    setup.workpiece.solids[0].errors.size = 0.5;
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, &call), Ok(()));
    close(&sim, "_OVR[30]", 0.1);
    let wear = sim.control.variable("$TC_DP15[7,1]").unwrap();
    assert!((wear + 0.2).abs() < 1e-9, "{wear}");
}

#[test]
fn an_inch_machine_finds_the_same() {
    // oracle: self (the same part, measured in the other system; values of the call are mm inside)
    let plane = Plane::G18;
    let found = |units: Units| {
        let call = call(plane, 0.0, 1, 60.0);
        let metric = setup(plane, Transverse::Diameter);
        let mut start = Setup::turning_in(plane, units);
        start.control.tools = metric.control.tools.clone();
        let mut start = placed(start, &call);
        start.workpiece.solids[0].errors.size = 0.5;
        let mut sim = Sim::new(&start);
        assert_eq!(run(&mut sim, &call), Ok(()));
        let results = [0, 4, 16, 20].map(|i| sim.control.number(&format!("_OVR[{i}]")));
        results.map(|value| value * units.factor())
    };
    for (metric, inch) in found(Units::Metric).iter().zip(found(Units::Inch)) {
        assert!((metric - inch).abs() < 1e-9, "{metric} {inch}");
    }
}

#[test]
fn a_skewed_probe_is_calibrated_away() {
    // oracle: hand (trigger points as a calibration finds them: the ball stands 0.2 beside where it is believed)
    let plane = Plane::G18;
    let call = call(plane, 0.0, 1, 60.0);
    let mut setup = placed(setup(plane, Transverse::Diameter), &call);
    setup.probe.skew = [0.1, 0.2];
    setup.probe.pre_travel.0 = 0.05;
    setup.control.set("_WP[0,3]", 3.0 - 0.2 - 0.05);
    let mut sim = Sim::new(&setup);
    sim.control.spindle = Degrees(70.0);
    assert_eq!(run(&mut sim, &call), Ok(()));
    close(&sim, "_OVR[4]", 60.0);
}

#[test]
fn what_cannot_be_measured_is_refused() {
    // oracle: manual A:15856, A:15866, A:15882, A:15916
    let plane = Plane::G18;
    let refused = |variant: f64, axis: f64, change: fn(&mut Setup)| {
        let mut call = call(plane, variant, 1, 60.0);
        let mut setup = placed(setup(plane, Transverse::Diameter), &call);
        call.numbers.insert(names::MA, axis);
        change(&mut setup);
        stopped(run(&mut Sim::new(&setup), &call))
    };
    let tip = |setup: &mut Setup| setup.control.edge_of_mut(9, 1).unwrap().tip = 3;
    assert_eq!(refused(0.0, 2.0, tip), 61315);
    assert_eq!(refused(0.0, 4.0, |_| ()), 61325);
    let empty = |setup: &mut Setup| (3..5).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0));
    assert_eq!(refused(0.0, 2.0, empty), 61341);
    let fixed = |setup: &mut Setup| setup.control.spindle_positions = false;
    assert_eq!(refused(1000.0, 2.0, fixed), 61372);
}
