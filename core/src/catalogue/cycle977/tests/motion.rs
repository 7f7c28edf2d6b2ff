//! Every motion of every variant of CYCLE977: order, side, height, feed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use super::super::tests::{CENTRE, inputs, part, ready};
use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, PLANE_FEED, expand};
use crate::catalogue::sinumerik::testing::{Motion, at, motions, run, same};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::machine::Sim;

/// Ways as [`expand`] reads them, from the setpoint centre.
/// Ball of radius 3, `_FA` 5, sizes 60 and 44: inside 60/2 - 3 = 27 and 5 before it, outside 60/2 + 3 = 33 and 5 before
/// it.
fn table(variant: i64, axis: usize) -> &'static str {
    match (variant % 10, axis) {
        (1, _) => "x22 [27] x-22 [-27] x0 y22 [27] y-22 [-27] y0",
        (2, _) => "x38 [33] x-38 [-33] x0 y38 [33] y-38 [-33] y0",
        (3, 1) => "x22 [27] x-22 [-27] x0",
        (3, _) => "y22 [27] y-22 [-27] y0",
        (4, 1) => "x38 [33] x-38 [-33] x0",
        (4, _) => "y38 [33] y-38 [-33] y0",
        (5, _) => "x22 [27] x-22 [-27] x0 y14 [19] y-14 [-19] y0",
        _ => "x38 [33] x-38 [-33] x0 y30 [25] y-30 [-25] y0",
    }
}

/// What a call does on the nominal part, from the setpoint centre at the height of the start.
fn driven(plane: Plane, variant: i64, inputs: &Inputs, across: bool) -> Vec<Motion> {
    let mut setup = ready(plane, variant);
    setup.workpiece.solids.push(part(plane, variant, across));
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, inputs), Ok(()), "{variant}");
    motions(&sim, plane, setup.position.0)
}

/// The infeed of [`inputs`] counts outside and with a protection zone.
fn infeed(variant: i64) -> f64 {
    if variant % 2 == 1 && variant < 1000 { 0.0 } else { -20.0 }
}

// oracle: manual B:5773-5809, B:5892-5957 (order, heights, end above the centre), hand (figures)
#[test]
fn every_variant_moves_as_its_table_says() {
    assert_eq!(at(Plane::G17, [CENTRE[0], CENTRE[1], 0.0])[0], CENTRE[0]);
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            for axis in [1, 2] {
                let across = matches!(variant % 10, 3 | 4) && axis == 2;
                let found = driven(plane, variant, &inputs(variant, axis as f64), across);
                let expected = expand(table(variant, axis), infeed(variant));
                same(&found, &expected, &format!("{variant} {axis} {plane:?}"));
            }
        }
    }
}

// oracle: hand, with our reading of B:5943-5951. The path is what lies between zone and element less a ball of 6:
// (60 - 44)/2 - 6 = 2 inside, (80 - 60)/2 - 6 = 4 outside; rectangles have their own in each axis, at most _FA.
#[test]
fn a_narrow_zone_shortens_the_path_before_and_behind_the_surface() {
    for (variant, zone, table) in [
        (1001, [44.0, 0.0], "x25 [27] x-25 [-27] x0 y25 [27] y-25 [-27] y0"),
        (1103, [44.0, 0.0], "x25 [27] x-25 [-27] x0"),
        (1105, [44.0, 22.0], "x25 [27] x-25 [-27] x0 y14 [19] y-14 [-19] y0"),
        (1002, [80.0, 0.0], "x37 [33] x-37 [-33] x0 y37 [33] y-37 [-33] y0"),
        (1104, [80.0, 0.0], "x37 [33] x-37 [-33] x0"),
        (1006, [80.0, 58.0], "x37 [33] x-37 [-33] x0 y26 [25] y-26 [-25] y0"),
    ] {
        let mut inputs = inputs(variant, 1.0);
        inputs.numbers.insert(names::SZA, zone[0]);
        inputs.numbers.insert(names::SZO, zone[1]);
        let found = driven(Plane::G17, variant, &inputs, false);
        same(&found, &expand(table, -20.0), &variant.to_string());
    }
}
