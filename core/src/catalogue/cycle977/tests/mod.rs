//! CYCLE977 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod alarm;
mod motion;
mod probe;

use super::VARIANTS;
use crate::catalogue::sinumerik::testing::{
    WIDE_BANDS, at, call, called, close, element, random_parts, run, setup, solid, touches,
};
use crate::control::{Frame, Plane};
use crate::entry::{Inputs, names};
use crate::geometry::{Mcs, Rpy, Wcs};
use crate::machine::Setup;
use crate::machine::sim::Sim;
use crate::workpiece::Solid;
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Setpoint centre, abscissa and ordinate.
pub(super) const CENTRE: [f64; 2] = [40.0, -25.0];
/// Set sizes.
pub(super) const SIZE: [f64; 2] = [60.0, 44.0];

/// Nominal part of a variant with its upper face at 0.
pub(super) fn part(plane: Plane, variant: i64, across: bool) -> Solid {
    let shape = element(variant, SIZE);
    solid(plane, shape, [CENTRE[0], CENTRE[1], 0.0], across)
}

/// A call of a variant; the axis is 1 or 2.
pub(super) fn inputs(variant: i64, axis: f64) -> Inputs {
    let inside = variant % 2 == 1;
    let sizes = if inside { [20.0, 12.0] } else { [100.0, 90.0] };
    let values = [
        ("_SETVAL", SIZE[0]),
        ("_SETV[0]", SIZE[0]),
        ("_SETV[1]", SIZE[1]),
        ("_MA", axis),
        ("_ID", -20.0),
        ("_SZA", sizes[0]),
        ("_SZO", sizes[1]),
        ("_FA", 5.0),
        ("_TNUM", 20.0),
    ];
    call("CYCLE977", variant, &[&values[..], &WIDE_BANDS].concat())
}

/// The probe at the start of a variant.
pub(super) fn ready(plane: Plane, variant: i64) -> Setup {
    let mut setup = setup(plane);
    let inside = variant % 2 == 1 && variant < 1000;
    setup.position = Mcs(at(plane, [CENTRE[0], CENTRE[1], if inside { -10.0 } else { 10.0 }]));
    setup
}

/// Index of the centre's actual value.
fn centre_at(variant: i64) -> usize {
    if variant % 10 >= 5 { 6 } else { 5 }
}

proptest! {
    #![proptest_config(random_parts(VARIANTS.len()))]

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
            for (is, wanted) in sim.position.iter().zip(end.0) {
                prop_assert!((is - wanted).abs() < 1e-9, "{:?}", sim.position);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    /// A part that is also turned about the tool axis: the ball meets its walls at an angle, in every variant and
    /// plane.
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
            solid.errors.tilt = Rpy(at(plane, [0.0, 0.0, tilt]));
            setup.workpiece.solids.push(solid);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs(variant, axis as f64)), Ok(()), "variant {}", variant);
            // oracle: hand. A wall turned by a about (dx, dy) is met along the abscissa, from the setpoint centre, at
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
            setup.control.stored.channel.insert(0, Frame::translation([1.0, 1.0, 1.0]));
            setup.control.activate(1);
            let start = Wcs(setup.position.0);
            setup.position = setup.control.to_machine(start);
            let mut solid = part(plane, variant, false);
            solid.errors.shift = at(plane, [dx, dy, 0.0]);
            solid.at = setup.control.to_machine(Wcs(solid.at.0));
            setup.workpiece.solids.push(solid);
            let mut inputs = inputs(variant, 1.0);
            inputs.numbers.insert(names::KNUM, [1.0, 9999.0, 1011.0, 2000.0][code]);
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
            inputs.numbers.insert(names::KNUM, 2001.0);
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
pub(super) fn hole(errors: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), crate::machine::Stop>) {
    let mut setup = ready(Plane::G17, 1);
    setup.workpiece.solids.push(part(Plane::G17, 1, false));
    let mut inputs = inputs(1, 1.0);
    errors(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn the_ordinate_is_measured_through_the_centre_found_in_the_abscissa() {
    // oracle: manual B:5773-5799
    let (sim, outcome) = hole(|setup, _| setup.workpiece.solids[0].errors.shift = [0.8, -0.6, 0.0]);
    assert_eq!(outcome, Ok(()));
    let touches = touches(&sim);
    assert_eq!(touches.len(), 4);
    assert!(touches[0][0] > touches[1][0] && touches[2][1] > touches[3][1]);
    assert!(touches[2..].iter().all(|touch| (touch[0] - 40.8).abs() < 1e-9), "{touches:?}");
}
