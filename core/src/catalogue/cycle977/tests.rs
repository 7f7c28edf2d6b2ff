//! CYCLE977 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::VARIANTS;
use crate::catalogue::sinumerik::testing::{alarms, at, call, close, run, setup, solid, stopped};
use crate::check::Inputs;
use crate::control::{Frame, Plane};
use crate::run::Setup;
use crate::run::machine::Sim;
use crate::run::trace::Step;
use crate::workpiece::{Shape, Solid};
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Set centre, abscissa and ordinate.
pub(super) const CENTRE: [f64; 2] = [40.0, -25.0];
/// Set sizes.
const SIZE: [f64; 2] = [60.0, 44.0];

/// Nominal part of a variant with its upper face at 0.
pub(super) fn part(plane: Plane, variant: i64, across: bool) -> Solid {
    let [length, width] = SIZE;
    let shape = match variant % 10 {
        1 => Shape::Hole {
            diameter: length,
            depth: 40.0,
        },
        2 => Shape::Shaft {
            diameter: length,
            height: 40.0,
        },
        3 => Shape::Groove {
            width: length,
            depth: 40.0,
            length: 200.0,
        },
        4 => Shape::Web {
            width: length,
            height: 40.0,
            length: 200.0,
        },
        5 => Shape::Pocket {
            length: [length, width],
            depth: 40.0,
        },
        _ => Shape::Island {
            length: [length, width],
            height: 40.0,
        },
    };
    solid(plane, shape, [CENTRE[0], CENTRE[1], 0.0], across)
}

/// A call of a variant; the axis is 1 or 2.
pub(super) fn inputs(variant: i64, axis: f64) -> Inputs {
    let inside = variant % 2 == 1;
    let sizes = if inside { [20.0, 12.0] } else { [100.0, 90.0] };
    call(
        "CYCLE977",
        variant,
        &[
            ("_SETVAL", SIZE[0]),
            ("_SETV[0]", SIZE[0]),
            ("_SETV[1]", SIZE[1]),
            ("_MA", axis),
            ("_ID", -20.0),
            ("_SZA", sizes[0]),
            ("_SZO", sizes[1]),
            ("_FA", 5.0),
            ("_TSA", 3.0),
            ("_TDIF", 2.5),
            ("_TUL", 2.4),
            ("_TLL", -2.4),
            ("_TMV", 2.0),
            ("_TZL", 0.0),
            ("_TNUM", 20.0),
        ],
    )
}

/// The probe at the start of a variant.
pub(super) fn ready(plane: Plane, variant: i64) -> Setup {
    let mut setup = setup(plane);
    let inside = variant % 2 == 1 && variant < 1000;
    setup.position = at(
        plane,
        [CENTRE[0], CENTRE[1], if inside { -10.0 } else { 10.0 }],
    );
    setup
}

/// Index of the centre's actual value.
fn centre_at(variant: i64) -> usize {
    if variant % 10 >= 5 { 6 } else { 5 }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Shifts and sizes of the part are found again, in every variant and plane.
    #[test]
    fn part_errors_are_recovered(
        dx in -1.0..1.0_f64, dy in -1.0..1.0_f64, grown in -1.0..1.0_f64, plane in 0..3_usize, axis in 1..3_usize,
    ) {
        let plane = PLANES[plane];
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            let single = matches!(variant % 10, 3 | 4);
            let mut setup = ready(plane, variant);
            let mut solid = part(plane, variant, single && axis == 2);
            solid.errors.shift = at(plane, [dx, dy, 0.0]);
            solid.errors.size = grown;
            setup.workpiece.solids.push(solid);
            let mut sim = Sim::new(&setup);
            let inputs = inputs(variant, axis as f64);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()), "variant {}", variant);
            // oracle: hand (the part as it was made)
            let mut centre = [CENTRE[0] + dx, CENTRE[1] + dy];
            if single {
                centre[2 - axis] = CENTRE[2 - axis];
            }
            close(&sim, "_OVR[4]", SIZE[0] + grown);
            let first = centre_at(variant);
            if first == 6 {
                close(&sim, "_OVR[5]", SIZE[1] + grown);
            }
            close(&sim, &format!("_OVR[{first}]"), centre[0]);
            close(&sim, &format!("_OVR[{}]", first + 1), centre[1]);
            let mut end = setup.position;
            end[plane.axes()[0]] = centre[0];
            end[plane.axes()[1]] = centre[1];
            for (is, wanted) in sim.position.iter().zip(end) {
                prop_assert!((is - wanted).abs() < 1e-9, "{:?}", sim.position);
            }
        }
    }

    /// A zero offset that was corrected and activated leaves nothing to correct.
    /// A part that is also turned about the tool axis: the ball meets its walls at an angle, in every variant and plane.
    #[test]
    fn a_turned_part_is_measured_as_geometry_says(
        dx in -1.0..1.0_f64, dy in -1.0..1.0_f64, grown in -1.0..1.0_f64, tilt in -1.0..1.0_f64,
        plane in 0..3_usize, axis in 1..3_usize,
    ) {
        let plane = PLANES[plane];
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            let single = matches!(variant % 10, 3 | 4);
            let mut setup = ready(plane, variant);
            let mut solid = part(plane, variant, single && axis == 2);
            solid.errors.shift = at(plane, [dx, dy, 0.0]);
            solid.errors.size = grown;
            solid.errors.tilt = at(plane, [0.0, 0.0, tilt]);
            setup.workpiece.solids.push(solid);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs(variant, axis as f64)), Ok(()), "variant {}", variant);
            // oracle: hand. A wall turned by a about (dx, dy) is met along the abscissa, from the set centre, at
            // dx + dy·tan a ± (W/2 ∓ R)/cos a; then along the ordinate through that centre.
            let (tan, cos) = (tilt.to_radians().tan(), tilt.to_radians().cos());
            let ball = if variant % 2 == 1 { 6.0 } else { -6.0 };
            let size = |set: f64| match variant % 10 {
                1 | 2 => set + grown,
                _ => (set + grown - ball) / cos + ball,
            };
            let centre = match (variant % 10, axis) {
                (1 | 2, _) => [dx, dy],
                (3 | 4, 1) => [dx + dy * tan, 0.0],
                (3 | 4, _) => [0.0, dy - dx * tan],
                _ => [dx + dy * tan, dy + dy * tan * tan],
            };
            close(&sim, "_OVR[4]", size(SIZE[0]));
            let first = centre_at(variant);
            if first == 6 {
                close(&sim, "_OVR[5]", size(SIZE[1]));
            }
            close(&sim, &format!("_OVR[{first}]"), CENTRE[0] + centre[0]);
            close(&sim, &format!("_OVR[{}]", first + 1), CENTRE[1] + centre[1]);
        }
    }

    #[test]
    fn a_corrected_zero_offset_measures_zero(
        dx in -1.0..1.0_f64, dy in -1.0..1.0_f64, plane in 0..3_usize, code in 0..4_usize,
    ) {
        let plane = PLANES[plane];
        for variant in VARIANTS.iter().map(|variant| variant.number).filter(|number| number / 100 % 10 == 1) {
            let mut setup = ready(plane, variant);
            setup.control.frames.insert(1, Frame::translation([3.0, -2.0, 1.0]));
            setup.control.channel_basic.insert(0, Frame::translation([1.0, 1.0, 1.0]));
            setup.control.activate(1);
            let start = setup.position;
            setup.position = setup.control.to_machine(start);
            let mut solid = part(plane, variant, false);
            solid.errors.shift = at(plane, [dx, dy, 0.0]);
            solid.at = setup.control.to_machine(solid.at);
            setup.workpiece.solids.push(solid);
            let mut inputs = inputs(variant, 1.0);
            inputs.numbers.insert("_KNUM", [1.0, 9999.0, 1011.0, 2000.0][code]);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
            sim.control.activate(1);
            sim.position = sim.control.to_machine(start);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
            let first = 12 + centre_at(variant);
            close(&sim, &format!("_OVR[{first}]"), 0.0);
            close(&sim, &format!("_OVR[{}]", first + 1), 0.0);
        }
    }

    /// Parts made with the corrected radius get to size, inside and outside.
    #[test]
    fn the_tool_offset_loop_converges(wrong in -0.9..0.9_f64) {
        for variant in [1, 2, 3, 4, 5, 6, 1001, 1006] {
            let mut inputs = inputs(variant, 1.0);
            inputs.numbers.insert("_KNUM", 2001.0);
            let mut setup = ready(Plane::G17, variant);
            for round in 0..3 {
                // The part grows (hole) or shrinks (shaft) when the mill is really thinner or thicker than believed.
                let believed = setup.control.edge_of(20, 1).unwrap().total_radius();
                let error = 2.0 * (10.0 + wrong / 2.0 - believed);
                let mut solid = part(Plane::G17, variant, false);
                solid.errors.size = if variant % 2 == 1 { error } else { -error };
                setup.workpiece.solids = vec![solid];
                let mut sim = Sim::new(&setup);
                prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
                if round == 2 {
                    close(&sim, "_OVR[16]", 0.0);
                }
                setup.control = sim.control;
            }
        }
    }
}

/// Runs a hole with these data and values changed.
pub(super) fn hole(
    errors: impl Fn(&mut Setup, &mut Inputs),
) -> (Sim, Result<(), crate::run::Stop>) {
    let mut setup = ready(Plane::G17, 1);
    setup.workpiece.solids.push(part(Plane::G17, 1, false));
    let mut inputs = inputs(1, 1.0);
    errors(&mut setup, &mut inputs);
    let mut sim = Sim::new(&setup);
    let outcome = run(&mut sim, &inputs);
    (sim, outcome)
}

#[test]
fn alarms_before_the_first_motion() {
    // oracle: manual A:15847-15931
    let alarm = |errors: &dyn Fn(&mut Setup, &mut Inputs)| {
        let (sim, outcome) = hole(errors);
        let moved = sim
            .trace
            .entries
            .iter()
            .any(|entry| matches!(entry.step, Step::Motion { .. }));
        assert!(!moved);
        let number = stopped(outcome);
        assert_eq!(sim.control.number("_OVI[9]"), f64::from(number));
        number
    };
    let value = |name: &'static str, value: f64| {
        alarm(&move |_, inputs| {
            inputs.numbers.insert(name, value);
        })
    };
    let datum =
        |name: &'static str, value: f64| alarm(&move |setup, _| setup.control.set(name, value));
    assert_eq!(value("_FA", 0.0), 61308);
    assert_eq!(value("_PRNUM", 4.0), 61313);
    assert_eq!(value("_PRNUM", 0.0), 61313);
    assert_eq!(value("_K", 0.0), 61318);
    assert_eq!(value("_KNUM", 3001.0), 61322);
    assert_eq!(value("_KNUM", 1.0), 61322);
    assert_eq!(value("_KNUM", 20_001.0), 61323);
    assert_eq!(value("_KNUM", 500_001.0), 61324);
    assert_eq!(value("_KNUM", 9_000_001.0), 61407);
    assert_eq!(value("_KNUM", 2000.0), 61328);
    assert_eq!(value("_KNUM", 2012.0), 61345);
    assert_eq!(value("_KNUM", 2002.0), 61410);
    assert_eq!(value("_KNUM", 1_002_001.0), 61406);
    assert_eq!(value("_KNUM", 2_002_001.0), 61405);
    assert_eq!(datum("_SPEED[0]", -1.0), 61339);
    assert_eq!(datum("_SPEED[1]", 0.0), 61338);
    assert_eq!(
        alarm(&|setup, _| (0..7).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0))),
        61341
    );
    assert_eq!(alarm(&|setup, _| setup.control.edge = 0), 61311);
    assert_eq!(
        alarm(&|setup, _| assert!(setup.control.set_variable("$TC_DP1[9,1]", 500.0))),
        61309
    );
    let tool = |number: f64, name: &'static str| {
        alarm(&move |_, inputs| {
            inputs
                .numbers
                .extend([("_KNUM", 2001.0), ("_TNUM", number)]);
            inputs.texts.insert("_TNAME", name.to_string());
        })
    };
    assert_eq!(tool(0.0, ""), 61320);
    assert_eq!(tool(0.0, "NOBODY"), 61343);
    let zero = |number: f64| {
        alarm(&move |_, inputs| {
            inputs.variant = 101;
            inputs.numbers.insert("_KNUM", number);
        })
    };
    assert_eq!(zero(100.0), 61321);
    assert_eq!(zero(1000.0), 61412);
    let zone = |size: f64| {
        alarm(&move |_, inputs| {
            inputs.variant = 1001;
            inputs.numbers.insert("_SZA", size);
        })
    };
    assert_eq!(zone(50.0), 61334);
}

#[test]
fn no_signal_is_tried_five_times_or_once() {
    // oracle: manual B:13999-14001
    for (bit, attempts) in [(0.0, 5), (1.0, 1)] {
        let (sim, outcome) = hole(|setup, _| {
            setup.workpiece.solids.clear();
            setup.control.set("_CHBIT[15]", bit);
        });
        assert_eq!(stopped(outcome), 61301);
        let probings = sim.trace.entries.iter().filter(|entry| {
            matches!(
                entry.step,
                Step::Motion {
                    kind: crate::run::trace::MotionKind::Measuring,
                    ..
                }
            )
        });
        assert_eq!(probings.count(), attempts);
    }
}

#[test]
fn a_probe_that_touches_on_its_way_alarms() {
    // oracle: manual B:13743-13763 (the hole is 12 mm smaller than _FA allows)
    let (sim, outcome) = hole(|_, inputs| {
        inputs.numbers.insert("_SETVAL", 80.0);
    });
    assert_eq!(stopped(outcome), 61302);
    assert_eq!(sim.control.number("_OVI[9]"), 61302.0);
}

#[test]
fn a_limit_switch_shortens_the_way_to_an_outer_element() {
    // oracle: manual A:15920-15921, with a shaft of 60 mm at X40: the ball touches it at X73, the block begins at X78
    let case = |limit: f64| {
        let mut setup = ready(Plane::G17, 2);
        setup.workpiece.solids.push(part(Plane::G17, 2, false));
        setup.control.limits.plus[0] = Some(limit);
        let mut sim = Sim::new(&setup);
        let outcome = run(&mut sim, &inputs(2, 1.0));
        (sim, outcome)
    };
    assert_eq!(stopped(case(71.0).1), 61402);
    // oracle: hand: from X75 the way down is free, and the block measures what it would from X78
    let (sim, outcome) = case(75.0);
    assert_eq!(outcome, Ok(()));
    close(&sim, "_OVR[4]", SIZE[0]);
    close(&sim, "_OVR[5]", CENTRE[0]);
}

#[test]
fn a_limit_switch_before_the_wall_is_told() {
    // oracle: manual A:15920: the hole's wall is touched at X67
    let case = |limit: f64| {
        let (_, outcome) = hole(|setup, _| setup.control.limits.plus[0] = Some(limit));
        outcome
    };
    assert_eq!(stopped(case(66.9)), 61401);
    assert_eq!(case(67.0), Ok(()));
    assert_eq!(stopped(case(50.0)), 61401);
}

#[test]
fn limits_are_told_and_repeated() {
    // oracle: manual B:6123-6137, B:13572-13580
    let case = |grown: f64, bits: &'static [&'static str]| {
        let (sim, outcome) = hole(move |setup, inputs| {
            setup.workpiece.solids[0].errors.size = grown;
            bits.iter().for_each(|bit| setup.control.set(*bit, 1.0));
            inputs
                .numbers
                .extend([("_TUL", 0.5), ("_TLL", -0.5), ("_TDIF", 1.0)]);
        });
        (alarms(&sim), outcome, sim)
    };
    assert_eq!(case(0.7, &[]).0, [62304]);
    assert_eq!(case(-0.7, &[]).0, [62305]);
    let (alarms, outcome, sim) = case(1.5, &[]);
    assert_eq!((alarms, outcome), (vec![62306], Ok(())));
    assert_eq!(sim.control.number("_OVI[9]"), 62306.0);
    let (alarms, outcome, _) = case(3.5, &[]);
    assert_eq!((alarms, stopped(outcome)), (vec![], 61303));
    let (alarms, outcome, _) = case(1.5, &["_CBIT[0]", "_CBIT[1]"]);
    assert_eq!((alarms, outcome), (vec![62306; 5], Ok(())));
    let (alarms, outcome, sim) = case(3.5, &["_CBIT[0]", "_CBIT[1]"]);
    assert_eq!((alarms, stopped(outcome)), (vec![62303; 4], 61303));
    let touches = sim
        .trace
        .entries
        .iter()
        .filter(|entry| matches!(entry.step, Step::Touch { .. }));
    assert_eq!(touches.count(), 20);
}

#[test]
fn the_ordinate_is_measured_through_the_centre_found_in_the_abscissa() {
    // oracle: manual B:5773-5799
    let (sim, outcome) = hole(|setup, _| setup.workpiece.solids[0].errors.shift = [0.8, -0.6, 0.0]);
    assert_eq!(outcome, Ok(()));
    let touches: Vec<[f64; 3]> = sim
        .trace
        .entries
        .iter()
        .filter_map(|entry| match entry.step {
            Step::Touch { latched, .. } => Some(latched),
            _ => None,
        })
        .collect();
    assert_eq!(touches.len(), 4);
    assert!(touches[0][0] > touches[1][0] && touches[2][1] > touches[3][1]);
    assert!(
        touches[2..]
            .iter()
            .all(|touch| (touch[0] - 40.8).abs() < 1e-9),
        "{touches:?}"
    );
}
