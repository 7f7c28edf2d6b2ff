//! CYCLE978 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::example::changed;
use crate::catalogue::sinumerik::testing::{
    WIDE_BANDS, at, call, called, close, motions, put, random_parts, run, setup, solid, stopped, touches, turns,
};
use crate::check::check;
use crate::control::{Plane, delivery};
use crate::diagnostic::Code;
use crate::entry::{Inputs, names};
use crate::form::fields;
use crate::geometry::{Degrees, Mcs, Rpy, Wcs};
use crate::machine::{MotionKind, Setup, Sim, Stop};
use crate::name::Name;
use crate::workpiece::Shape;
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

/// Beside a block of 100 mm whose faces lie at ±50 in the plane and whose upper face is at 0.
fn ready(plane: Plane, axis: usize, side: f64, error: f64) -> Setup {
    let mut setup = setup(plane);
    let shape = Shape::Block { size: [100.0; 3] };
    let mut block = solid(plane, shape, [0.0; 3], false);
    let mut shift = [0.0; 3];
    let mut position = [10.0, -5.0, -30.0];
    shift[axis] = error;
    position[axis] = if axis == 2 { 20.0 } else { side * 70.0 };
    block.errors.shift = at(plane, shift);
    setup.workpiece.solids.push(block);
    setup.position = Mcs(at(plane, position));
    setup
}

fn inputs(variant: i64, axis: usize, side: f64) -> Inputs {
    let set = if axis == 2 { 0.0 } else { side * 50.0 };
    let values = [("_SETVAL", set), ("_MA", axis as f64 + 1.0), ("_FA", 4.0), ("_TNUM", 20.0)];
    call("CYCLE978", variant, &[&values[..], &WIDE_BANDS].concat())
}

proptest! {
    #![proptest_config(random_parts(10))]

    /// The position of a surface is found again, in every variant, axis, direction and plane.
    #[test]
    fn the_position_is_recovered(error in -2.0..2.0_f64, plane in 0..3_usize, plus in any::<bool>()) {
        let (plane, side) = (PLANES[plane], if plus { 1.0 } else { -1.0 });
        for (variant, axes) in [(0, 3), (100, 3), (1000, 2), (1100, 2)] {
            for axis in 0..axes {
                let setup = ready(plane, axis, side, error);
                let mut sim = Sim::new(&setup);
                let inputs = inputs(variant, axis, side);
                prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
                // oracle: hand (the part as it was made)
                let actual = inputs.number(names::SETVAL) + error;
                close(&sim, "_OVR[4]", actual);
                close(&sim, &format!("_OVR[{}]", 5 + axis), actual);
                close(&sim, &format!("_OVR[{}]", 17 + axis), error);
                // End: the ball _FA before the set surface.
                let out = if axis == 2 { 1.0 } else { side };
                let end = inputs.number(names::SETVAL) + out * 7.0;
                prop_assert!((sim.position[plane.axes()[axis]] - end).abs() < 1e-9);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Two points of a face tell by how much the part is turned; the ball meets both at the same angle.
    #[test]
    fn the_tilt_is_recovered(
        tilt in -1.5..1.5_f64, plane in 0..3_usize, axis in 0..2_usize, plus in any::<bool>(), along in 5.0..25.0_f64,
    ) {
        let (plane, side) = (PLANES[plane], if plus { 1.0 } else { -1.0 });
        let other = plane.axes()[1 - axis];
        let measured = [-along, along].map(|place| {
            let mut setup = ready(plane, axis, side, 0.0);
            setup.workpiece.solids[0].errors.tilt = Rpy(at(plane, [0.0, 0.0, tilt]));
            setup.position[other] = place;
            let mut sim = Sim::new(&setup);
            assert_eq!(run(&mut sim, &inputs(0, axis, side)), Ok(()));
            sim.control.number("_OVR[4]")
        });
        // oracle: hand. x·cos a + y·sin a = 50, and the same turned by 90 degree for the other axis
        let turn = if axis == 0 { -1.0 } else { 1.0 };
        let rise = turn * tilt.to_radians().tan() * 2.0 * along;
        prop_assert!((measured[1] - measured[0] - rise).abs() < 1e-9, "{:?} {}", measured, rise);
    }

    /// A zero offset that was corrected and activated leaves nothing to correct, whatever the empirical value.
    #[test]
    fn a_corrected_zero_offset_measures_zero(error in -2.0..2.0_f64, plane in 0..3_usize, axis in 0..3_usize) {
        let setup = ready(PLANES[plane], axis, -1.0, error);
        let mut sim = Sim::new(&setup);
        let mut inputs = inputs(100, axis, -1.0);
        inputs.numbers.insert(names::KNUM, 1.0);
        prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
        sim.control.activate(1);
        sim.position = sim.control.to_machine(Wcs(setup.position.0));
        prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
        close(&sim, "_OVR[16]", 0.0);
    }

    /// An uncalibrated, skewed probe measures right by turning the spindle, and its skew is known afterwards, alone and
    /// in the trigger point.
    #[test]
    fn differential_measurement_finds_the_skew(
        skew in -0.5..0.5_f64, error in -1.0..1.0_f64, axis in 0..2_usize, plus in any::<bool>(), turned in 0..2_u32,
    ) {
        let side = if plus { 1.0 } else { -1.0 };
        let mut setup = ready(Plane::G17, axis, side, error);
        setup.probe.skew[axis] = skew;
        setup.control.spindle = Degrees(180.0 * f64::from(turned));
        (0..9).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0));
        let mut sim = Sim::new(&setup);
        prop_assert_eq!(run(&mut sim, &inputs(1000, axis, side)), Ok(()));
        close(&sim, "_OVR[16]", error);
        // oracle: hand: the ball stands the skew beside the spindle, the surface its radius before the ball
        let skew = if turned == 0 { skew } else { -skew };
        close(&sim, &format!("_WP[0,{}]", 7 + axis), skew);
        let trigger = 2 * axis + if plus { 1 } else { 2 };
        close(&sim, &format!("_WP[0,{trigger}]"), side * 3.0 - skew);
        prop_assert_eq!(sim.control.spindle, setup.control.spindle);
    }

    /// Faces made with the corrected tool get into place.
    #[test]
    fn the_tool_offset_loop_converges(wrong in -1.5..1.5_f64, axis in 0..3_usize, plus in any::<bool>()) {
        let side = if plus || axis == 2 { 1.0 } else { -1.0 };
        let mut inputs = inputs(0, axis, side);
        // A face is milled by the radius; the upper face by the length L1.
        inputs.numbers.insert(names::KNUM, if axis == 2 { 1.0 } else { 2001.0 });
        let mut setup = ready(Plane::G17, axis, side, 0.0);
        for round in 0..2 {
            let edge = setup.control.edge_of(20, 1).unwrap();
            let error = match axis {
                2 => edge.total_length(0) - 80.0 + wrong,
                // Believed thicker than it is: the face stays proud by the difference.
                _ => side * (edge.total_radius() - 10.0 + wrong),
            };
            setup.workpiece = ready(Plane::G17, axis, side, error).workpiece;
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
            close(&sim, "_OVR[16]", if round == 0 { error } else { 0.0 });
            setup.control = sim.control;
        }
    }
}

fn surface(error: f64, change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), Stop>) {
    let mut setup = ready(Plane::G17, 0, 1.0, error);
    let mut inputs = inputs(0, 0, 1.0);
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn every_alarm() {
    // oracle: manual A:15842-15944, B:6436-6440
    let value = |name: Name, value: f64| stopped(surface(0.0, |_, inputs| put(inputs, name.as_str(), value)).1);
    assert_eq!(value(names::MA, 4.0), 61325);
    assert_eq!(value(names::K, 0.0), 61318);
    assert_eq!(value(names::FA, -1.0), 61308);
    assert_eq!(value(names::KNUM, 5001.0), 61322);
    assert_eq!(stopped(surface(-4.5, |_, _| ()).1), 61301);
    assert_eq!(stopped(surface(4.5, |_, _| ()).1), 61302);
    assert_eq!(stopped(surface(3.5, |_, _| ()).1), 61303);
    for (error, shown) in [(2.45, 62304), (-2.45, 62305), (2.8, 62306)] {
        let (sim, outcome) = surface(error, |_, _| ());
        assert_eq!((alarms_of(&sim), outcome), (vec![shown], Ok(())));
    }
    let third = surface(0.0, |_, inputs| {
        inputs.variant = 1000;
        inputs.numbers.insert(names::MA, 3.0);
    });
    assert_eq!(stopped(third.1), 61325);
}

fn alarms_of(sim: &Sim) -> Vec<u32> {
    crate::catalogue::sinumerik::testing::alarms(sim)
}

#[test]
fn the_empirical_value_counts_with_either_sign() {
    // oracle: manual B:13924-13926
    for (bit, change) in [(0.0, 0.48), (1.0, 0.52)] {
        let (sim, outcome) = surface(0.5, |setup, inputs| {
            inputs.variant = 100;
            inputs.numbers.extend([(names::KNUM, 1.0), (names::EVNUM, 10.0)]);
            setup.control.set("_EV[9]", 0.02);
            setup.control.set("_CHBIT[5]", bit);
        });
        assert_eq!(outcome, Ok(()));
        assert!((sim.control.frames[&1].fine[0] - change).abs() < 1e-9);
        close(&sim, "_OVR[30]", 0.02);
        close(&sim, "_OVI[11]", 1.0);
    }
}

#[test]
fn measurements_at_the_same_place_are_averaged() {
    // oracle: hand (the touches of the trace)
    let (sim, outcome) = surface(0.5, |setup, inputs| {
        inputs.numbers.insert(names::NMSP, 4.0);
        setup.probe.repeatability = (0.01, 7);
    });
    assert_eq!(outcome, Ok(()));
    let touches: Vec<f64> = touches(&sim).iter().map(|touch| touch[0]).collect();
    assert_eq!(touches.len(), 4);
    assert!(touches[0] != touches[1]);
    close(&sim, "_OVR[4]", touches.iter().sum::<f64>() / 4.0 - 3.0);
}

// oracle: hand, with manual B:6376-6388 (start _FA before the surface, back to it), B:6402-6418 (twice for
// differential)
#[test]
fn only_the_measuring_axis_moves_to_the_start_into_the_surface_and_back() {
    use MotionKind::{Measuring, Positioning, Retract};
    for plane in PLANES {
        for (variant, touches, axes) in [(0, 1, 3), (100, 1, 3), (1000, 2, 2), (1100, 2, 2)] {
            for axis in 0..axes {
                let mut setup = ready(plane, axis, -1.0, 0.0);
                setup.control.set("_SPEED[1]", 1200.0);
                setup.control.set("_SPEED[2]", 700.0);
                let start = setup.position;
                let mut sim = Sim::new(&setup);
                assert_eq!(run(&mut sim, &inputs(variant, axis, -1.0)), Ok(()));
                // the ball of radius 3, 4 mm before the face at -50, and at the face; from above at 0
                let (before, at_face, feed) = match axis {
                    2 => (7.0, 3.0, 700.0),
                    _ => (-57.0, -53.0, 1200.0),
                };
                let mut expected = vec![(Positioning, before, feed)];
                for _ in 0..touches {
                    expected.push((Measuring, at_face, 300.0));
                    expected.push((Retract, before, feed));
                }
                let geometry = plane.axes()[axis];
                let found: Vec<_> =
                    motions(&sim, plane, [0.0; 3]).into_iter().map(|(kind, to, feed)| (kind, to[axis], feed)).collect();
                assert_eq!(found.len(), expected.len(), "{variant} {axis} {found:?}");
                for (is, wanted) in found.iter().zip(&expected) {
                    assert_eq!((is.0, is.2), (wanted.0, wanted.2), "{variant} {axis}");
                    assert!((is.1 - wanted.1).abs() < 1e-9, "{is:?} {wanted:?}");
                }
                for other in plane.axes().into_iter().filter(|i| *i != geometry) {
                    assert_eq!(sim.position[other], start[other]);
                }

                let wanted: &[f64] = if touches == 2 { &[180.0, 0.0] } else { &[] };
                assert_eq!(turns(&sim), wanted, "{variant}");
            }
        }
    }
}

#[test]
fn the_length_may_end_at_the_centre_or_the_circumference_of_the_ball() {
    // oracle: manual B:13646-13652, B:5581-5583: the face stands at 0.5 either way; the end is the ball _FA above 0
    for (bit, length, trigger, end) in [(0.0, 50.0, 3.0, 7.0), (1.0, 53.0, 0.0, 4.0)] {
        let mut setup = ready(Plane::G17, 2, 1.0, 0.5);
        setup.control.set("_CBIT[14]", bit);
        setup.control.set("_WP[0,5]", trigger);
        assert!(setup.control.set_variable("$TC_DP3[9,1]", length));
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &inputs(0, 2, 1.0)), Ok(()));
        close(&sim, "_OVR[16]", 0.5);
        assert!((sim.position[2] - end).abs() < 1e-9, "{:?}", sim.position);
    }
}

#[test]
fn a_mono_probe_is_known_by_its_triggers() {
    // oracle: hand: its ball stands 0.2 mm ahead of the spindle axis in every direction of probing
    for (axis, side) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
        let mut setup = ready(Plane::G17, axis, side, 0.5);
        setup.probe.skew = [0.2, 0.0];
        for (i, value) in [(1, 3.2), (2, -3.2), (3, 3.2), (4, -3.2)] {
            setup.control.set(format!("_WP[0,{i}]"), value);
        }
        let mut inputs = inputs(0, axis, side);
        inputs.numbers.insert(names::PRNUM, 101.0);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &inputs), Ok(()));
        close(&sim, "_OVR[16]", 0.5);
    }
}

#[test]
fn differential_measurement_in_a_mirrored_axis_stores_what_the_machine_knows() {
    // oracle: hand: towards minus of a mirrored abscissa the machine goes in plus direction, where the trigger is -3
    // less the skew of the machine
    let mut setup = ready(Plane::G17, 0, -1.0, 0.5);
    setup.control.active.mirror = [true, false, false];
    setup.probe.skew[0] = 0.2;
    (0..9).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0));
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, &inputs(1000, 0, 1.0)), Ok(()));
    close(&sim, "_OVR[16]", -0.5);
    close(&sim, "_WP[0,2]", -3.2);
    close(&sim, "_WP[0,7]", 0.2);
}

#[test]
fn a_zero_offset_has_no_mean_value_memory() {
    // oracle: manual B:1307
    let cycle = &super::CYCLE978;
    for (variant, memory) in [("0", "param-evnum"), ("100", "param-evnum-tool"), ("1100", "param-evnum-tool")] {
        let typed = changed(cycle, &[("_MVAR", variant), ("_EVNUM", "210001"), ("_KNUM", "1")]);
        let shown = fields(cycle, &typed, &delivery(cycle.dialect));
        let field = shown.iter().find(|field| field.name == names::EVNUM);
        assert_eq!(field.map(|field| &*field.label.key), Some(memory), "{variant}");
        let found = check(cycle, &typed, &delivery(cycle.dialect)).diagnostics;
        let refused = found.iter().any(|one| one.code == Code::Own(21));
        assert_eq!(refused, memory == "param-evnum", "{variant}");
    }
}
