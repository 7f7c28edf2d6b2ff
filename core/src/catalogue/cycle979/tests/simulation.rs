//! CYCLE979 on the simulated machine: what it finds, corrects and refuses.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use crate::catalogue::sinumerik::testing::{
    WIDE_BANDS, alarms, at, call, called, close, element, put, random_parts, run, setup, solid, stopped, turns,
};
use crate::control::{Frame, Plane};
use crate::dialect::Dialect;
use crate::entry::{Inputs, names};
use crate::geometry::{Degrees, Mcs, Rpy, Wcs};
use crate::machine::Setup;
use crate::machine::sim::Sim;
use crate::machine::trace::{MotionKind, Step};
use crate::run::Limits;
use crate::syntax::read;
use crate::workpiece::Solid;
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Setpoint centre, abscissa and ordinate.
pub(super) const CENTRE: [f64; 2] = [40.0, -25.0];
/// Setpoint diameter or width.
pub(super) const SIZE: f64 = 60.0;
/// Height of the ball centre while measuring; the upper face stands at 0.
pub(super) const HEIGHT: f64 = -10.0;

pub(super) fn round(variant: i64) -> bool {
    variant % 10 <= 2
}

/// Nominal part of a variant, its width in the direction of `angle`.
pub(super) fn part(plane: Plane, variant: i64, angle: f64) -> Solid {
    let shape = element(variant, [SIZE; 2]);
    let mut part = solid(plane, shape, [CENTRE[0], CENTRE[1], 0.0], false);
    part.errors.tilt = Rpy(at(plane, [0.0, 0.0, angle]));
    part
}

/// A call of a variant; `four` points of a circle or three.
pub(super) fn inputs(variant: i64, angle: f64, step: f64, four: bool) -> Inputs {
    let values = [
        ("_SETVAL", SIZE),
        ("_CPA", CENTRE[0]),
        ("_CPO", CENTRE[1]),
        ("_STA1", angle),
        ("_INCA", step),
        ("_RF", 900.0),
        ("_ID", 20.0),
        ("_PRNUM", if four { 1001.0 } else { 1.0 }),
        ("_FA", 5.0),
        ("_TNUM", 20.0),
    ];
    call("CYCLE979", variant, &[&values[..], &WIDE_BANDS].concat())
}

/// The probe inside, or outside at P1 beyond the start of the first block.
pub(super) fn ready(plane: Plane, variant: i64, angle: f64) -> Setup {
    let mut setup = setup(plane);
    let (sine, cosine) = Degrees(angle).sin_cos();
    let away = if variant % 2 == 1 { 3.0 } else { SIZE / 2.0 + 15.0 };
    let place = [CENTRE[0] + away * cosine, CENTRE[1] + away * sine, HEIGHT];
    setup.position = Mcs(at(plane, place));
    setup
}

/// The values of a three-point or four-point circle, or of two sides.
fn cases() -> impl Iterator<Item = (i64, bool)> {
    let numbers = VARIANTS.iter().map(|variant| variant.number);
    numbers.flat_map(|number| [(number, false), (number, round(number))])
}

proptest! {
    #![proptest_config(random_parts(cases().count()))]

    // oracle: hand (the part as it was made; a width is found in its direction only)
    #[test]
    fn part_errors_are_recovered(
        shift in prop::array::uniform2(-1.0..1.0_f64), grown in -1.0..1.0_f64,
        skew in prop::array::uniform2(-0.5..0.5_f64),
        angle in -100.0..100.0_f64, step in prop_oneof![20.0..80.0_f64, -80.0..-20.0_f64], plane in 0..3_usize,
    ) {
        let plane = PLANES[plane];
        for (variant, four) in cases() {
            let mut setup = ready(plane, variant, angle);
            setup.probe.skew = skew;
            [(7, skew[0]), (8, skew[1])].iter().for_each(|(i, value)| setup.control.set(format!("_WP[0,{i}]"), *value));
            let mut part = part(plane, variant, angle);
            part.errors.shift = at(plane, [shift[0], shift[1], 0.0]);
            part.errors.size = grown;
            setup.workpiece.solids.push(part);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs(variant, angle, step, four)), Ok(()), "{} {}", variant, four);
            let (sine, cosine) = Degrees(angle).sin_cos();
            let along = shift[0] * cosine + shift[1] * sine;
            let [x, y] = if round(variant) { shift } else { [along * cosine, along * sine] };
            for (name, value) in [
                ("_OVR[1]", CENTRE[0]), ("_OVR[2]", CENTRE[1]),
                ("_OVR[4]", SIZE + grown), ("_OVR[5]", CENTRE[0] + x), ("_OVR[6]", CENTRE[1] + y),
                ("_OVR[16]", grown), ("_OVR[17]", x), ("_OVR[18]", y),
            ] {
                close(&sim, name, value);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    // oracle: self (afterwards nothing is left to correct), for every sort of frame, in turned and mirrored coordinates
    #[test]
    fn a_corrected_zero_offset_measures_zero(
        shift in prop::array::uniform2(-1.0..1.0_f64), turn in -180.0..180.0_f64, plane in 0..3_usize,
        code in 0..4_usize,
        mirrored in any::<bool>(),
    ) {
        let plane = PLANES[plane];
        for variant in [101, 102, 103, 104] {
            let mut setup = ready(plane, variant, 30.0);
            let turned = Frame {
                rotation: Rpy(at(plane, [0.0, 0.0, turn])),
                mirror: at(plane, [1.0, 0.0, 0.0]).map(|abscissa| mirrored && abscissa == 1.0),
                ..Frame::translation([3.0, -2.0, 1.0])
            };
            let angle = if mirrored { 150.0 } else { 30.0 };
            setup.control.frames.insert(1, turned);
            setup.control.stored.channel.insert(0, Frame::translation([1.0, 1.0, 1.0]));
            setup.control.activate(1);
            let start = Wcs(setup.position.0);
            setup.position = setup.control.to_machine(start);
            let mut part = part(plane, variant, angle + turn);
            part.at = setup.control.to_machine(Wcs(part.at.0));
            part.errors.shift = at(plane, [shift[0], shift[1], 0.0]);
            setup.workpiece.solids.push(part);
            let mut inputs = inputs(variant, 30.0, 80.0, false);
            inputs.numbers.insert(names::KNUM, [1.0, 9999.0, 1011.0, 2000.0][code]);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
            prop_assert_eq!(sim.control.number("_OVI[11]"), 1.0);
            sim.control.activate(1);
            sim.position = sim.control.to_machine(start);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
            close(&sim, "_OVR[17]", 0.0);
            close(&sim, "_OVR[18]", 0.0);
        }
    }

    // oracle: hand (a mill that is really thicker makes holes larger and shafts smaller)
    #[test]
    fn the_next_part_gets_to_size(wrong in -0.9..0.9_f64) {
        for variant in [1, 2, 3, 4] {
            let mut inputs = inputs(variant, 30.0, 80.0, false);
            inputs.numbers.insert(names::KNUM, 2001.0);
            let mut setup = ready(Plane::G17, variant, 30.0);
            for part_number in 0..2 {
                let believed = setup.control.edge_of(20, 1).unwrap().total_radius();
                let error = 2.0 * (10.0 + wrong / 2.0 - believed);
                let mut solid = part(Plane::G17, variant, 30.0);
                solid.errors.size = if variant % 2 == 1 { error } else { -error };
                setup.workpiece.solids = vec![solid];
                let mut sim = Sim::new(&setup);
                prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
                close(&sim, "_OVR[16]", if part_number == 0 { setup.workpiece.solids[0].errors.size } else { 0.0 });
                setup.control = sim.control;
            }
        }
    }
}

/// Runs a variant on its part with something changed.
fn changed(variant: i64, change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), crate::machine::Stop>) {
    let mut setup = ready(Plane::G17, variant, 30.0);
    setup.workpiece.solids.push(part(Plane::G17, variant, 30.0));
    let mut inputs = inputs(variant, 30.0, 80.0, false);
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn what_cannot_be_measured_is_refused_before_it_moves() {
    // oracle: manual B:6873, A:15857-15931
    let alarm = |variant: i64, change: &dyn Fn(&mut Setup, &mut Inputs)| {
        let (sim, outcome) = changed(variant, change);
        assert!(sim.trace.entries.iter().all(|entry| !matches!(entry.step, Step::Motion { .. })));
        let number = stopped(outcome);
        assert_eq!(sim.control.number("_OVI[9]"), f64::from(number));
        number
    };
    let value = |variant: i64, name: &'static str, value: f64| {
        alarm(variant, &move |_, inputs| {
            put(inputs, name, value);
        })
    };
    assert_eq!(alarm(3, &|setup, _| setup.control.set("_WP[0,0]", 0.0)), 61341);
    assert_eq!(value(1, "_RF", 0.0), 61365);
    assert_eq!(value(1, "_FA", 0.0), 61308);
    assert_eq!(value(1, "_K", 0.0), 61318);
    assert_eq!(value(1, "_KNUM", 1.0), 61322);
    assert_eq!(value(101, "_KNUM", 100.0), 61321);
    assert_eq!(value(101, "_KNUM", 1000.0), 61412);
}

#[test]
fn points_upon_each_other_make_no_circle() {
    // oracle: manual A:15857
    let (_, outcome) = changed(1, |_, inputs| {
        inputs.numbers.insert(names::INCA, 360.0);
    });
    assert_eq!(stopped(outcome), 61316);
}

#[test]
fn a_measurement_is_repeated_from_its_first_point() {
    // oracle: manual B:13572-13580: four repetitions, each of which ends where the cycle ends; hand: without a
    // collision
    for (variant, points) in [(1, 3), (2, 3), (3, 2), (4, 2), (102, 3), (104, 2)] {
        let (sim, outcome) = changed(variant, |setup, inputs| {
            setup.control.set("_CBIT[0]", 1.0);
            setup.control.set("_CBIT[1]", 1.0);
            setup.workpiece.solids[0].errors.shift = [0.4, 0.2, 0.0];
            setup.workpiece.solids[0].errors.size = 1.0;
            inputs.numbers.extend([(names::TSA, 0.3), (names::TDIF, 0.3), (names::TUL, 0.2), (names::TLL, -0.2)]);
        });
        assert_eq!(stopped(outcome), 61303, "{variant}");
        assert_eq!(alarms(&sim), [62303; 4]);
        let touches = sim.trace.entries.iter();
        let touches = touches.filter(|entry| matches!(entry.step, Step::Touch { .. }));
        assert_eq!(touches.count(), 5 * points, "{variant}");
    }
}

#[test]
fn a_mono_probe_looks_at_the_wall() {
    // oracle: manual B:864-871, B:13624-13626: inside along the angle of the point, outside against it, and
    // B:6744-6752; the spindle counts from the ordinate to the abscissa (B:13985)
    let turned = |variant: i64, probe: f64| {
        let (sim, outcome) = changed(variant, |setup, inputs| {
            setup.control.set("_CBIT[8]", 1.0);
            inputs.numbers.extend([(names::PRNUM, probe), (names::CORA, 5.0)]);
        });
        assert_eq!(outcome, Ok(()));
        turns(&sim)
    };
    assert_eq!(turned(1, 101.0), [335.0, 255.0, 175.0]);
    assert_eq!(turned(1, 1101.0), [335.0, 255.0, 175.0, 95.0]);
    assert_eq!(turned(2, 101.0), [155.0, 75.0, 355.0]);
    assert_eq!(turned(2, 1101.0), [155.0, 75.0, 355.0, 275.0]);
    assert_eq!(turned(3, 101.0), [335.0, 155.0]);
    assert_eq!(turned(4, 101.0), [155.0, 335.0]);
}

#[test]
fn a_multi_probe_turns_with_the_coordinates_however_many_points() {
    // oracle: manual B:13973-13987 (90 degree of the coordinates are 270 of the spindle), B:6744-6752
    for probe in [1.0, 1001.0] {
        let (sim, _) = changed(1, |setup, inputs| {
            setup.control.active.rotation = Rpy([0.0, 0.0, 90.0]);
            setup.control.set("_CHBIT[13]", 1.0);
            inputs.numbers.insert(names::PRNUM, probe);
        });
        assert_eq!(turns(&sim), [270.0], "{probe}");
    }
}

#[test]
fn a_mono_probe_is_known_by_its_active_ball() {
    // oracle: hand: a ball that stands 0.2 mm ahead of the spindle axis makes an active radius of 3.2, whichever way
    // it looks; the position deviation of the data field belongs to a spindle that stands still
    let (sim, outcome) = changed(1, |setup, inputs| {
        setup.probe.skew = [0.2, 0.0];
        [(0, 6.4), (7, 9.0)].iter().for_each(|(i, value)| setup.control.set(format!("_WP[0,{i}]"), *value));
        inputs.numbers.insert(names::PRNUM, 101.0);
    });
    assert_eq!(outcome, Ok(()));
    for (name, value) in [("_OVR[4]", SIZE), ("_OVR[5]", CENTRE[0]), ("_OVR[6]", CENTRE[1])] {
        close(&sim, name, value);
    }
}

#[test]
fn a_wrong_ball_diameter_shows_in_the_diameter_alone() {
    // oracle: hand: 0.1 mm too large a ball makes a hole 0.1 larger, a shaft 0.1 smaller
    for (variant, error) in [(1, 0.1), (2, -0.1), (3, 0.1), (4, -0.1)] {
        let (sim, outcome) = changed(variant, |setup, _| setup.control.set("_WP[0,0]", 6.1));
        assert_eq!(outcome, Ok(()));
        for (name, value) in [("_OVR[16]", error), ("_OVR[17]", 0.0), ("_OVR[18]", 0.0)] {
            close(&sim, name, value);
        }
    }
}

#[test]
fn without_monitoring_the_ways_are_rapid_and_the_circle_keeps_its_feed() {
    // oracle: manual B:13743-13763, B:6911-6913
    let (sim, outcome) = changed(1, |setup, _| setup.control.set("_CHBIT[2]", 0.0));
    assert_eq!(outcome, Ok(()));
    let motion = |step: &Step| match step {
        Step::Motion { kind, feed, .. } => Some((*kind, *feed)),
        _ => None,
    };
    let mut kinds: Vec<(MotionKind, f64)> = sim.trace.entries.iter().filter_map(|entry| motion(&entry.step)).collect();
    kinds.dedup();
    let touch = [(MotionKind::Measuring, 300.0), (MotionKind::Retract, 0.0)];
    let round = [(MotionKind::Positioning, 900.0)];
    let begin = [(MotionKind::Rapid, 0.0)];
    assert_eq!(kinds, [&begin[..], &touch, &round, &touch, &round, &touch].concat());
}

#[test]
fn in_mirrored_coordinates_the_circle_goes_the_other_way_round() {
    // oracle: manual B:7133 (mirroring can be active), hand (the part as it was made); a skewed probe meets it too
    for variant in [1, 2, 3, 4] {
        let (sim, outcome) = changed(variant, |setup, _| {
            setup.probe.skew = [0.3, -0.2];
            [(7, 0.3), (8, -0.2)].iter().for_each(|(i, value)| setup.control.set(format!("_WP[0,{i}]"), *value));
            setup.control.active.mirror = [false, true, false];
            let part = &mut setup.workpiece.solids[0];
            part.at[1] = -part.at[1];
            part.errors.tilt[2] = -part.errors.tilt[2];
            part.errors.shift = [0.5, -0.5 * 30.0_f64.to_radians().tan(), 0.0];
            setup.position[1] = -setup.position[1];
        });
        assert_eq!(outcome, Ok(()), "{variant}");
        close(&sim, "_OVR[4]", SIZE);
        close(&sim, "_OVR[17]", 0.5);
        close(&sim, "_OVR[18]", 0.5 * 30.0_f64.to_radians().tan());
        let touched = |step: &Step| match step {
            Step::Touch { point, .. } => Some((point[1] + CENTRE[1]).atan2(point[0] - CENTRE[0])),
            _ => None,
        };
        let entries = sim.trace.entries.iter();
        let angles: Vec<f64> = entries.filter_map(|entry| touched(&entry.step)).collect();
        assert!(variant > 2 || angles[1] < angles[0], "{angles:?}");
    }
}

#[test]
fn inch_and_millimetre_measure_the_same() {
    // oracle: self (the same part, programmed in both systems; results count in the active one)
    let results = |code: &str, unit: f64| {
        let mut setup = ready(Plane::G17, 1, 30.0);
        let mut part = part(Plane::G17, 1, 0.0);
        (part.errors.shift, part.errors.size) = ([0.3, -0.2, 0.0], 0.1);
        setup.workpiece.solids.push(part);
        let text = format!(
            "{code} G17 G90 G54 T9 D1\n_MVAR=1 _SETVAL={} _CPA={} _CPO={} _STA1=30 _INCA=80 _RF=900 _KNUM=0 _PRNUM=1\n\
            _FA=5 _TSA=3 _TDIF=2.5 _TUL={} _TLL=0 _TMV=2 _TZL=0 _K=1 _NMSP=1 _VMS=0 _EVNUM=0\nCYCLE979\nM30\n",
            SIZE / unit,
            CENTRE[0] / unit,
            CENTRE[1] / unit,
            0.4 / unit,
        );
        let outcome = crate::run::run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default());
        assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
        (0..32).map(|i| outcome.control.number(&format!("_OVR[{i}]")) * unit).collect::<Vec<f64>>()
    };
    let (metric, inch) = (results("G71", 1.0), results("G70", 25.4));
    assert!((metric[4] - SIZE - 0.1).abs() < 1e-9);
    for (index, (one, other)) in metric.iter().zip(&inch).enumerate() {
        assert!((one - other).abs() < 1e-9, "_OVR[{index}]: {one} {other}");
    }
}
