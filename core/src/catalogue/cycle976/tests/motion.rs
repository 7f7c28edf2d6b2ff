//! Every motion of every variant of CYCLE976: order, side, feed, how the spindle stands.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use super::super::directions::{angle, turned};
use super::super::params::{HOLE, LENGTH, ONE, TWO, UNKNOWN};
use super::simulate::{inputs, ready};
use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, MEASURING_FEED, PLANE_FEED, expand};
use crate::catalogue::sinumerik::testing::{Motion, motions, run, same, turns};
use crate::control::Plane;
use crate::entry::{Inputs, names};
use crate::geometry::Degrees;
use crate::machine::{MotionKind, Sim};

/// What [`moved`] tells: the motions, and the angles to which the spindle was turned.
type Moved = (Vec<Motion>, Vec<f64>);

fn moved(plane: Plane, inputs: &Inputs) -> Moved {
    let mut setup = ready(plane, inputs);
    setup.probe.stylus = Some(0.0); // a straight one stands in the way of the applicate in plus direction
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    setup.control.spindle = Degrees(30.0);
    let start = setup.position;
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, inputs), Ok(()), "{}", inputs.variant);
    let mut found = motions(&sim, plane, start.0);
    for (_, [abscissa, ordinate, _], _) in &mut found {
        [*abscissa, *ordinate] = turned([*abscissa, *ordinate], angle(inputs));
    }
    (found, turns(&sim))
}

/// Ways in a hole of 60 mm in the axes of calibration; ball of radius 3, `_FA` 5: 60/2 - 3 = 27, and 5 before it.
fn table(inputs: &Inputs) -> &'static str {
    let (second, minus) = (inputs.integer(names::MA) == 2, inputs.integer(names::MD) == 1);
    let four = "x22 [27] x-22 [-27] x0 y22 [27] y-22 [-27] y0";
    match (ONE.holds(inputs), TWO.holds(inputs), second, minus) {
        (true, _, false, false) => "x22 [27] x0",
        (true, _, false, true) => "x-22 [-27] x0",
        (true, _, true, false) => "y22 [27] y0",
        (true, _, true, true) => "y-22 [-27] y0",
        (_, true, false, _) => "x22 [27] x-22 [-27] x0",
        (_, true, true, _) => "y22 [27] y-22 [-27] y0",
        _ => four,
    }
}

// oracle: manual B:5196-5214, B:5309-5336 (order, two runs, end in the middle), hand (figures)
#[test]
fn every_hole_is_touched_as_its_table_says() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for variant in VARIANTS {
            for (axis, direction) in [(1.0, 0.0), (1.0, 1.0), (2.0, 0.0), (2.0, 1.0)] {
                let inputs = inputs(variant.number, axis, direction);
                let counts = ONE.holds(&inputs) || direction == 0.0 && (TWO.holds(&inputs) || axis == 1.0);
                if !HOLE.holds(&inputs) || !counts {
                    continue;
                }
                let (found, turns) = moved(plane, &inputs);
                let mut expected = expand(table(&inputs), 0.0);
                let mut spindle: &[f64] = &[];
                if UNKNOWN.holds(&inputs) {
                    expected = [expected.clone(), expected].concat();
                    spindle = &[210.0, 30.0];
                }
                let what = format!("{} {axis} {direction} {plane:?}", variant.number);
                same(&found, &expected, &what);
                assert_eq!(turns, spindle, "{what}");
            }
        }
    }
}

// oracle: manual B:864-871, B:13624-13626, B:5292-5296 (a mono probe looks along each direction, and is not turned
// over)
#[test]
fn a_mono_probe_is_turned_into_each_direction() {
    for (variant, expected) in [
        (1, &[0.0, 180.0, 270.0, 90.0][..]),
        (100_001, &[330.0, 150.0, 240.0, 60.0]),
        (8, &[0.0, 180.0, 270.0, 90.0, 0.0, 180.0, 270.0, 90.0]),
    ] {
        let mut inputs = inputs(variant, 1.0, 0.0);
        inputs.numbers.insert(names::PRNUM, 101.0);
        inputs.numbers.insert(names::STA1, 30.0);
        assert_eq!(moved(Plane::G17, &inputs).1, expected, "{variant}");
    }
    let mut face = inputs(0, 2.0, 1.0);
    face.numbers.extend([(names::PRNUM, 101.0), (names::CORA, 7.0)]);
    assert_eq!(moved(Plane::G17, &face).1, [97.0]);
}

// oracle: manual B:5447-5455 (in the plane back to where it stood, along the applicate `_FA` before the face),
// B:5579-5593 (the length: from where it stands, and back there)
#[test]
fn a_surface_is_touched_once() {
    use MotionKind::{Measuring, Positioning, Retract};
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for (axis, direction) in [(1, 0), (1, 1), (2, 0), (2, 1), (3, 0), (3, 1)] {
            for variant in [0, 10_000] {
                let inputs = inputs(variant, f64::from(axis), f64::from(direction));
                let with_length = LENGTH.holds(&inputs);
                if with_length && axis != 3 {
                    continue;
                }
                // The ball stands 10 before the face, or 5 where the length is searched on a way of 10.
                let sign = if direction == 1 { -1.0 } else { 1.0 };
                let at = |way: f64| {
                    let mut to = [0.0; 3];
                    to[axis as usize - 1] = sign * way;
                    to
                };
                let feed = if axis == 3 { DEPTH_FEED } else { PLANE_FEED };
                let mut expected = match with_length {
                    true => vec![(Measuring, at(5.0), MEASURING_FEED), (Retract, at(0.0), feed)],
                    false => vec![
                        (Positioning, at(5.0), feed),
                        (Measuring, at(10.0), MEASURING_FEED),
                        (Retract, at(5.0), feed),
                    ],
                };
                if axis < 3 {
                    expected.push((Positioning, at(0.0), feed));
                }
                let (found, turns) = moved(plane, &inputs);
                same(&found, &expected, &format!("{variant} {axis} {direction}"));
                assert!(turns.is_empty());
            }
        }
    }
}

// oracle: manual B:2348-2356 (from the start of the block each time)
#[test]
fn measurements_at_the_same_place_start_anew() {
    let mut inputs = inputs(1001, 1.0, 0.0);
    inputs.numbers.insert(names::NMSP, 3.0);
    let expected = "x22 [27] x22 [27] x22 [27] x0";
    let repeated = expand(expected, 0.0);
    // going to where the probe stands already is no motion
    let all: Vec<Motion> =
        repeated.iter().enumerate().filter(|(index, _)| ![3, 6].contains(index)).map(|(_, motion)| *motion).collect();
    same(&moved(Plane::G17, &inputs).0, &all, "_NMSP");
}
