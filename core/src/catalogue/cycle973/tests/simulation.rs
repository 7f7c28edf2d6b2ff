//! CYCLE973 on the simulated machine: how it moves, what it finds, and that measuring with it is right.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::lathe::testing::{inputs, placed, setup};
use crate::catalogue::sinumerik::motion_testing::{MEASURING_FEED, PLANE_FEED};
use crate::catalogue::sinumerik::testing::{at, close, motions, run, same, stopped};
use crate::control::{Frame, Plane, Transverse, Units};
use crate::entry::Inputs;
use crate::machine::trace::MotionKind::{Measuring, Positioning, Retract};
use crate::machine::{Setup, Sim};
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
const TWO: [f64; 4] = [2013.0, 2113.0, 12_013.0, 12_113.0];
/// Walls and base of both grooves: their ball centres for a ball of 3 mm touch at 57.123 and 53.054, at 37.118 and
/// 33.047.
const WALLS: [[f64; 2]; 2] = [[60.123, 50.054], [40.118, 30.047]];
const BASES: [f64; 2] = [15.021, 20.015];

fn call(plane: Plane, values: &[(&'static str, f64)]) -> Inputs {
    let mut all = vec![("_CALNUM", 1.0), ("_FA", 3.0), ("_TSA", 3.0), ("_TZL", 0.0)];
    all.extend(values);
    inputs("CYCLE973", plane, &all)
}

/// Axis of the plane of the walls and of the base, for a cutting edge position.
fn axes(tip: i64) -> [usize; 2] {
    if tip == 7 { [1, 0] } else { [0, 1] }
}

/// The machine with a probe of this position before the groove, in a frame that does not matter.
fn ready(plane: Plane, tip: i64, call: &Inputs) -> Setup {
    let mut setup = setup(plane, Transverse::Diameter);
    setup.control.edge_of_mut(9, 1).unwrap().tip = tip;
    let frame = Frame::translation([3.0, -4.0, 250.0]);
    setup.control.frames.insert(1, frame);
    setup.control.activate(1);
    placed(setup, call)
}

/// Trigger point of an axis and direction (1 minus, 2 plus).
fn trigger(axis: usize, sign: usize) -> String {
    format!("_WP[0,{}]", 2 * axis + sign)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20))]

    // oracle: hand (position at switching minus surface, by the sense of B:13441-13449: the ball stands `skew` beside
    // where it is believed, and switches late)
    #[test]
    fn trigger_values_ball_and_skew_are_found(
        radius in 2.9..3.1_f64, skew in prop::array::uniform2(-0.3..0.3_f64), late in 0.0..0.05_f64,
        variant in 0..4_usize,
    ) {
        for plane in PLANES {
            for tip in [7, 8] {
                let [walls, _] = axes(tip);
                let call = call(plane, &[("_MVAR", TWO[variant]), ("_MA", walls as f64 + 1.0)]);
                let mut setup = ready(plane, tip, &call);
                setup.probe.radius = radius;
                setup.probe.skew = skew;
                setup.probe.pre_travel.0 = late;
                let mut sim = Sim::new(&setup);
                prop_assert_eq!(run(&mut sim, &call), Ok(()));
                let active = radius - late;
                close(&sim, &trigger(walls, 1), active - skew[walls]);
                close(&sim, &trigger(walls, 2), -active - skew[walls]);
                let number = TWO[variant] as i64;
                let [ball, beside] = [number / 100 % 10 == 1, number / 10_000 == 1];
                close(&sim, "_WP[0,0]", if ball { 2.0 * active } else { 6.0 });
                close(&sim, &format!("_WP[0,{}]", 7 + walls), if beside { skew[walls] } else { 0.0 });
                prop_assert_eq!(sim.control.active, setup.control.active);
                prop_assert_eq!(&sim.control.basic, &setup.control.basic);
            }
        }
    }

    // oracle: hand, as above
    #[test]
    fn one_direction_is_found(skew in prop::array::uniform2(-0.3..0.3_f64), late in 0.0..0.05_f64,
    short in any::<bool>()) {
        let variant = if short { 13.0 } else { 1013.0 };
        for plane in PLANES {
            for tip in [7, 8] {
                for (axis, minus) in [(axes(tip)[0], true), (axes(tip)[0], false), (axes(tip)[1], true)] {
                    let direction = if minus { 1.0 } else { 0.0 };
                    let call = call(plane, &[("_MVAR", variant), ("_MA", axis as f64 + 1.0), ("_MD", direction)]);
                    let mut setup = ready(plane, tip, &call);
                    (setup.probe.skew, setup.probe.pre_travel.0) = (skew, late);
                    let mut sim = Sim::new(&setup);
                    prop_assert_eq!(run(&mut sim, &call), Ok(()));
                    let found = if minus { 3.0 - late } else { late - 3.0 } - skew[axis];
                    close(&sim, &trigger(axis, if minus { 1 } else { 2 }), found);
                    let first = 8 + 4 * axis + if minus { 0 } else { 2 };
                    close(&sim, &format!("_OVR[{first}]"), found);
                    let before = if minus { 3.0 } else { -3.0 };
                    close(&sim, &format!("_OVR[{}]", first + 1), found - before);
                }
            }
        }
    }

    // oracle: hand, as above; a surface of the workpiece system, X as a diameter
    #[test]
    fn a_surface_gives_the_trigger_value(
        set in -60.0..60.0_f64, skew in prop::array::uniform2(-0.3..0.3_f64), late in 0.0..0.05_f64, tip in 5..9_i64,
    ) {
        for plane in PLANES {
            for axis in 0..3 {
                for minus in [true, false] {
                    let per = if plane.axes()[axis] == 0 { 2.0 } else { 1.0 };
                    let values = [
                        ("_MVAR", 0.0),
                        ("_MA", axis as f64 + 1.0),
                        ("_MD", if minus { 1.0 } else { 0.0 }),
                        ("_SETVAL", set * per),
                    ];
                    let call = call(plane, &values);
                    let mut setup = placed(setup(plane, Transverse::Diameter), &call);
                    setup.control.edge_of_mut(9, 1).unwrap().tip = tip;
                    let mut along = [0.0; 2];
                    if axis < 2 {
                        along[axis] = skew[axis];
                    }
                    (setup.probe.skew, setup.probe.pre_travel.0) = (along, late);
                    let mut sim = Sim::new(&setup);
                    prop_assert_eq!(run(&mut sim, &call), Ok(()), "{:?} {}", plane, axis);
                    let found = if minus { 3.0 - late } else { late - 3.0 };
                    let found = found - along.get(axis).copied().unwrap_or(0.0);
                    close(&sim, &trigger(axis, if minus { 1 } else { 2 }), found);
                }
            }
        }
    }
}

#[test]
fn the_way_leads_over_the_middle_into_the_groove() {
    // oracle: manual B:10216-10230, A:11516 (by itself to the middle of the groove), B:10323 (end _FA before the last
    // surface), hand (figures: half of the depth of 12 mm, ball 3, _FA 3)
    for plane in PLANES {
        for (index, tip) in [7, 8].into_iter().enumerate() {
            let ([walls, base], [plus, minus]) = (axes(tip), WALLS[index]);
            let place = |wall: f64, height: f64| {
                let mut place = [0.0; 3];
                (place[walls], place[base]) = (wall, height);
                place
            };
            let middle = (plus + minus) / 2.0;
            let both = call(plane, &[("_MVAR", 2013.0), ("_MA", walls as f64 + 1.0)]);
            let mut setup = ready(plane, tip, &both);
            setup.position[plane.axes()[walls]] += 40.0;
            setup.control.set("_SPEED[1]", PLANE_FEED);
            let mut sim = Sim::new(&setup);
            assert_eq!(run(&mut sim, &both), Ok(()));
            let above = BASES[index] + 12.0 + 11.0;
            let height = BASES[index] + 6.0;
            let expected = [
                (Positioning, place(middle, above), PLANE_FEED),
                (Positioning, place(middle, height), PLANE_FEED),
                (Positioning, place(plus - 6.0, height), PLANE_FEED),
                (Measuring, place(plus - 3.0, height), MEASURING_FEED),
                (Retract, place(plus - 6.0, height), PLANE_FEED),
                (Positioning, place(minus + 6.0, height), PLANE_FEED),
                (Measuring, place(minus + 3.0, height), MEASURING_FEED),
                (Retract, place(minus + 6.0, height), PLANE_FEED),
            ];
            same(&motions(&sim, plane, [0.0; 3]), &expected, &format!("{plane:?} {tip}"));
            let one = call(plane, &[("_MVAR", 13.0), ("_MA", base as f64 + 1.0), ("_MD", 1.0)]);
            let mut sim = Sim::new(&setup);
            assert_eq!(run(&mut sim, &one), Ok(()));
            let bottom = BASES[index];
            let expected = [
                (Positioning, place(middle, above), PLANE_FEED),
                (Positioning, place(middle, bottom + 6.0), PLANE_FEED),
                (Measuring, place(middle, bottom + 3.0), MEASURING_FEED),
                (Retract, place(middle, bottom + 6.0), PLANE_FEED),
            ];
            same(&motions(&sim, plane, [0.0; 3]), &expected, &format!("{plane:?} {tip} base"));
        }
    }
}

#[test]
fn a_displaced_groove_shows_in_the_trigger_values() {
    // oracle: hand: both walls stand 0.2 mm further in plus direction than `_KB` says, and 0.1 mm further apart
    for plane in PLANES {
        let call = call(plane, &[("_MVAR", 2013.0), ("_MA", 2.0)]);
        let mut setup = ready(plane, 7, &call);
        let groove = setup.workpiece.solids.first_mut().unwrap();
        groove.errors.shift[plane.axes()[1]] = 0.2;
        groove.errors.size = 0.1;
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        close(&sim, &trigger(1, 1), 3.0 + 0.2 - 0.05);
        close(&sim, &trigger(1, 2), -3.0 + 0.2 + 0.05);
    }
}

#[test]
fn a_turned_surface_stands_in_its_chuck() {
    // oracle: hand: the part of 60 mm is held; a face that no turned part has, and the groove of the machine, are not
    let setup = setup(Plane::G18, Transverse::Diameter);
    let held = |values: &[(&'static str, f64)]| {
        let mut all = vec![("_MD", 1.0), ("_SETVAL", 60.0)];
        all.extend(values);
        let call = call(Plane::G18, &all);
        (call.cycle.work().unwrap().propose)(&call, &setup.control).fixture.len()
    };
    assert_eq!(held(&[("_MVAR", 0.0), ("_MA", 2.0)]), 1);
    assert_eq!(held(&[("_MVAR", 0.0), ("_MA", 1.0)]), 1);
    assert_eq!(held(&[("_MVAR", 0.0), ("_MA", 3.0)]), 1);
    assert_eq!(held(&[("_MVAR", 0.0), ("_MA", 1.0), ("_MD", 0.0)]), 0);
    assert_eq!(held(&[("_MVAR", 2013.0), ("_MA", 2.0)]), 0);
}

#[test]
fn a_long_path_begins_in_the_middle() {
    // oracle: hand: with 5 mm the ball would stand in the other wall
    let plane = Plane::G18;
    let call = call(plane, &[("_MVAR", 2013.0), ("_MA", 2.0), ("_FA", 5.0)]);
    let mut sim = Sim::new(&ready(plane, 7, &call));
    assert_eq!(run(&mut sim, &call), Ok(()));
    close(&sim, &trigger(1, 1), 3.0);
    let middle = at(plane, [21.021, 55.0885, 0.0]);
    for (is, wanted) in sim.position.iter().zip(middle) {
        assert!((is - wanted).abs() < 1e-9, "{:?}", sim.position);
    }
}

#[test]
fn with_a_calibrated_probe_the_right_size_is_measured() {
    // oracle: hand (calibrate, measure: a perfect part has no deviation, whatever is wrong with the probe)
    let plane = Plane::G18;
    let calibrate = call(plane, &[("_MVAR", 2013.0), ("_MA", 2.0)]);
    let mut setup = ready(plane, 7, &calibrate);
    (setup.probe.skew, setup.probe.pre_travel.0) = ([0.1, -0.2], 0.03);
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, &calibrate), Ok(()));
    let values = [("_MVAR", 0.0), ("_MA", 2.0), ("_SETVAL", 60.0), ("_TSA", 3.0)];
    let measure = inputs("CYCLE974", plane, &values);
    let mut part = crate::catalogue::lathe::testing::setup(plane, Transverse::Diameter);
    part.control = sim.control.clone();
    part.probe = setup.probe;
    let mut sim = Sim::new(&placed(part, &measure));
    assert_eq!(run(&mut sim, &measure), Ok(()));
    close(&sim, "_OVR[4]", 60.0);
    close(&sim, "_OVR[16]", 0.0);
}

#[test]
fn an_inch_machine_finds_the_same() {
    // oracle: self (the same groove on the other machine)
    let found = |units: Units| {
        let call = call(Plane::G18, &[("_MVAR", 12_113.0), ("_MA", 2.0)]);
        let mut setup = placed(Setup::turning_in(Plane::G18, units), &call);
        setup.probe.skew = [0.0, 0.1];
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        let names = ["_WP[0,0]", "_WP[0,3]", "_WP[0,4]", "_WP[0,8]", "_OVR[12]", "_OVR[21]"];
        names.map(|name| sim.control.number(name) * units.factor())
    };
    for (metric, inch) in found(Units::Metric).iter().zip(found(Units::Inch)) {
        assert!((metric - inch).abs() < 1e-9, "{metric} {inch}");
    }
}

#[test]
fn what_cannot_be_calibrated_is_refused() {
    // oracle: manual A:15844, A:15856, A:15866-15867, A:15876, B:10177
    let plane = Plane::G18;
    let refused = |values: &[(&'static str, f64)], tip: i64| {
        let good = call(plane, &[("_MVAR", 2013.0), ("_MA", 2.0)]);
        let setup = ready(plane, 7, &good);
        let mut sim = Sim::new(&setup);
        sim.control.edge_of_mut(9, 1).unwrap().tip = tip;
        let outcome = run(&mut sim, &call(plane, values));
        assert_eq!(sim.control.active, setup.control.active, "the frames are back");
        stopped(outcome)
    };
    assert_eq!(refused(&[("_MVAR", 2013.0), ("_MA", 2.0)], 5), 61315);
    assert_eq!(refused(&[("_MVAR", 2013.0), ("_MA", 3.0)], 7), 61325);
    assert_eq!(refused(&[("_MVAR", 2013.0), ("_MA", 1.0)], 7), 61326);
    assert_eq!(refused(&[("_MVAR", 13.0), ("_MA", 1.0), ("_MD", 0.0)], 7), 61326);
    assert_eq!(refused(&[("_MVAR", 13.0), ("_MA", 2.0), ("_MD", 2.0)], 7), 61326);
    assert_eq!(refused(&[("_MVAR", 2013.0), ("_MA", 2.0), ("_CALNUM", 4.0)], 7), 61333);
}
