#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! Stylus and body of the probe against parts: hand-made ones, and random ones against the distance of the part.

use super::{Boundary, Contact, Feeler, Obstacle, PartErrors, Probe, ProbeBody, Shape, Solid, Touching, Workpiece};
use crate::geometry::{Degrees, Dir, Mcs, Rpy, V3};
use crate::machine::ideal_probe;
use proptest::prelude::*;

const UP: Dir<Mcs> = Dir::new([0.0, 0.0, 1.0]);

fn solid(shape: Shape, at: [f64; 3]) -> Solid {
    Solid::new(shape, Mcs(at))
}

pub(crate) fn boundary(solids: Vec<Solid>) -> Boundary {
    Boundary::of(&Workpiece { solids })
}

/// A block whose upper face lies at `at`.
fn block(size: [f64; 3], at: [f64; 3]) -> Boundary {
    boundary(vec![solid(Shape::Block { size }, at)])
}

/// The ideal probe: ball 3 mm, stylus 1.35 mm, 50 mm long.
fn slim() -> Feeler {
    Feeler::new(&ideal_probe(), UP)
}

/// With a body of 20 mm, 30 mm above the ball.
fn held() -> Feeler {
    let body = ProbeBody { radius: 20.0, distance: 30.0 };
    let probe = Probe { body: Some(body), length: 120.0, ..ideal_probe() };
    Feeler::new(&probe, UP)
}

fn caught(part: &Boundary, probe: &Feeler, from: [f64; 3], to: [f64; 3]) -> Option<Obstacle> {
    probe.caught(part, Mcs(from), Mcs(to))
}

/// Where the ball is when stylus or body touch.
fn stop(from: [f64; 3], to: [f64; 3], met: &Obstacle) -> V3 {
    V3::from(from) + (V3::from(to) - V3::from(from)) * met.part
}

fn near(found: V3, expected: [f64; 3]) {
    assert!((found - V3::from(expected)).norm() < 1e-9, "{found:?}");
}

// oracle: hand: a hole that is 20 mm wide above and 32 mm at a depth of 30 mm: its rim is 1.35 mm from the stylus first
#[test]
fn an_undercut_is_met_by_the_stylus() {
    let mut undercut = solid(Shape::Hole { diameter: 20.0, depth: 45.0 }, [0.0; 3]);
    undercut.errors.taper = 0.4;
    let part = boundary(vec![undercut]);
    for (sine, cosine) in [(0.0, 1.0), (0.6, -0.8), (-1.0, 0.0)] {
        let (from, to) = ([0.0, 0.0, -30.0], [20.0 * cosine, 20.0 * sine, -30.0]);
        let met = caught(&part, &slim(), from, to).unwrap();
        assert_eq!(met.by, Touching::Stylus);
        near(stop(from, to, &met), [8.65 * cosine, 8.65 * sine, -30.0]);
        near(met.point.into(), [10.0 * cosine, 10.0 * sine, 0.0]);
        near(met.normal.into(), [-cosine, -sine, 0.0]);
    }
}

// oracle: hand: a plate above the ball ends at X = 20; askew it is met where the stylus is as far from its edge
#[test]
fn a_plate_above_is_met_by_the_stylus() {
    let part = block([40.0, 60.0, 5.0], [40.0, 0.0, 0.0]);
    let ways = [
        ([0.0, 0.0, -20.0], [40.0, 0.0, -20.0], [18.65, 0.0, -20.0]),
        ([0.0, 5.0, -20.0], [40.0, -5.0, -30.0], [18.65, 0.3375, -24.6625]),
    ];
    for (from, to, expected) in ways {
        let ball = part.first(3.0, Mcs(from), Mcs(to));
        assert_eq!(ball, Contact::None);
        let met = caught(&part, &slim(), from, to).unwrap();
        near(stop(from, to, &met), expected);
        near(met.normal.into(), [-1.0, 0.0, 0.0]);
        assert!((met.point[0] - 20.0).abs() < 1e-9 && (-5.0..=0.0).contains(&met.point[2]));
    }
    // above the plate, beside it and below the spindle nothing is met
    for (from, to) in [
        ([0.0, 0.0, 3.1], [40.0, 0.0, 3.1]),
        ([0.0, 32.0, -20.0], [40.0, 32.0, -20.0]),
        ([0.0, 0.0, -57.0], [40.0, 0.0, -57.0]),
    ] {
        assert_eq!(caught(&part, &slim(), from, to), None, "{from:?}");
    }
    // its corner, by Pythagoras
    let (from, to) = ([0.0, 30.8, -20.0], [40.0, 30.8, -20.0]);
    let met = caught(&part, &slim(), from, to).unwrap();
    near(stop(from, to, &met), [20.0 - (1.35_f64 * 1.35 - 0.64).sqrt(), 30.8, -20.0]);
}

// oracle: hand: the stylus stands in the plate already, the ball below it
#[test]
fn what_the_stylus_goes_through_stops_it_at_once() {
    let part = block([40.0, 60.0, 5.0], [0.0; 3]);
    let met = caught(&part, &slim(), [0.0, 0.0, -20.0], [5.0, 0.0, -20.0]).unwrap();
    assert_eq!((met.part, met.by), (0.0, Touching::Stylus));
}

// oracle: hand: a face that leans over by an angle is met by the stylus at its upper edge when the ball is farther than
// the face leans
#[test]
fn a_leaning_face_is_met_above_the_ball() {
    let mut leaning = solid(Shape::Block { size: [40.0, 40.0, 40.0] }, [0.0; 3]);
    leaning.errors.tilt = Rpy([0.0, 20.0, 0.0]); // about Y: the upper edge at +X comes down and out
    let part = boundary(vec![leaning]);
    let (sine, cosine) = 20_f64.to_radians().sin_cos();
    let edge = [20.0 * cosine, -20.0 * sine]; // the upper face turns about the origin
    let (from, to) = ([60.0, 0.0, -30.0], [0.0, 0.0, -30.0]);
    let met = caught(&part, &slim(), from, to).unwrap();
    near(stop(from, to, &met), [edge[0] + 1.35, 0.0, -30.0]);
    near(met.point.into(), [edge[0], 0.0, edge[1]]);
}

// oracle: hand: two round things across each other touch when their axes are as far apart as both radii
#[test]
fn a_lying_shaft_and_a_ball_are_met_across() {
    let mut shaft = solid(Shape::Turned { diameter: 30.0, length: 80.0, bore: [0.0; 2] }, [0.0; 3]);
    shaft.rotation = Rpy([90.0, 0.0, 0.0]); // its axis along Y
    shaft.at = Mcs([0.0, -40.0, 0.0]);
    let (from, to) = ([60.0, 0.0, -20.0], [0.0, 0.0, -20.0]);
    for (part, reach) in
        [(boundary(vec![shaft]), 16.35_f64), (boundary(vec![solid(Shape::Sphere { diameter: 30.0 }, [0.0; 3])]), 16.35)]
    {
        let met = caught(&part, &slim(), from, to).unwrap();
        near(stop(from, to, &met), [reach, 0.0, -20.0]);
        near(met.point.into(), [15.0, 0.0, 0.0]);
        near(met.normal.into(), [1.0, 0.0, 0.0]);
    }
}

// oracle: hand: the lower face of the body is 30 mm above the ball
#[test]
fn beside_a_deep_hole_the_body_stands_on_the_step() {
    let (from, to) = ([0.0, 0.0, 10.0], [0.0, 0.0, -40.0]);
    let step = block([60.0, 60.0, 50.0], [45.0, 0.0, 0.0]); // from X = 15 on
    let pin = block([4.0, 4.0, 50.0], [10.0, 0.0, 0.0]); // altogether below the body
    let web = block([1.0, 200.0, 50.0], [10.3, 0.0, 0.0]);
    for part in [step, pin, web] {
        let met = caught(&part, &held(), from, to).unwrap();
        assert_eq!(met.by, Touching::Body);
        near(stop(from, to, &met), [0.0, 0.0, -30.0]);
        assert!(met.point[2].abs() < 1e-9 && met.normal[2] > 1.0 - 1e-9);
        assert_eq!(caught(&part, &slim(), from, to), None);
    }
    let far = block([60.0, 60.0, 50.0], [50.1, 0.0, 0.0]); // from X = 20.1 on
    assert_eq!(caught(&far, &held(), from, to), None);
}

// oracle: hand: above a wall the body is 20 mm from the axis, the ball 3 mm
#[test]
fn a_wall_that_is_higher_than_the_stylus_is_met_by_the_body() {
    let part = block([60.0, 60.0, 90.0], [60.0, 0.0, 40.0]); // X from 30, Z from -50 to 40
    let (from, to) = ([0.0, 0.0, -20.0], [60.0, 0.0, -20.0]);
    let met = caught(&part, &held(), from, to).unwrap();
    assert_eq!(met.by, Touching::Body);
    assert!((stop(from, to, &met).x - 10.0).abs() < 1e-6, "{met:?}");
}

// oracle: hand: a stylus of 5 mm radius above a ball of 3 mm meets an upright wall first
#[test]
fn a_stylus_that_is_thicker_than_its_ball_touches_before_it() {
    let probe = Probe { stylus: Some(5.0), ..ideal_probe() };
    let part = block([40.0, 40.0, 60.0], [0.0; 3]);
    let (from, to) = ([60.0, 0.0, -30.0], [0.0, 0.0, -30.0]);
    let thick = Feeler::new(&probe, UP);
    let met = caught(&part, &thick, from, to).unwrap();
    near(stop(from, to, &met), [25.0, 0.0, -30.0]);
    let (from, to) = ([0.0, 0.0, 30.0], [0.0, 0.0, -30.0]);
    let met = caught(&part, &thick, from, to).unwrap(); // from above its end is as high as the middle of the ball
    near(stop(from, to, &met), [0.0, 0.0, 0.0]);
}

/// A solid with errors, small enough that a probe may stand beside it.
pub(crate) fn any_solid() -> impl Strategy<Value = Solid> {
    let shape = prop_oneof![
        Just(Shape::Hole { diameter: 30.0, depth: 20.0 }),
        Just(Shape::Shaft { diameter: 24.0, height: 25.0 }),
        Just(Shape::Groove { width: 26.0, depth: 15.0, length: 50.0 }),
        Just(Shape::Pocket { length: [36.0, 28.0], depth: 22.0 }),
        Just(Shape::Island { length: [30.0, 20.0], height: 25.0 }),
        Just(Shape::Block { size: [30.0, 40.0, 12.0] }),
        Just(Shape::OuterCorner { angle: Degrees(70.0), length: [30.0, 40.0], height: 20.0 }),
        Just(Shape::Turned { diameter: 40.0, length: 30.0, bore: [24.0, 20.0] }),
        Just(Shape::Sphere { diameter: 30.0 }),
    ];
    let angles = prop_oneof![
        Just([0.0; 3]),
        [-15.0..15.0, -15.0..15.0, -180.0..180.0],
        [-180.0..180.0, -90.0..90.0, -180.0..180.0],
    ];
    let round = prop_oneof![Just((0.0, 0)), Just((0.2, 3))];
    (shape, angles, -0.3..0.3, round).prop_map(|(shape, tilt, taper, out_of_round)| Solid {
        shape,
        at: Mcs::default(),
        rotation: Rpy::default(),
        errors: PartErrors { tilt: Rpy(tilt), taper, out_of_round, ..PartErrors::default() },
    })
}

/// Least distance of the part from the axis of the stylus, by places close together.
pub(crate) fn least(part: &Boundary, ball: V3) -> f64 {
    let places = (0..=250).map(|step| ball + V3::z() * f64::from(step) * 0.2);
    places.map(|place| part.distance(place.into())).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    // oracle: definition: until then no place of the axis is nearer to the part than the radius, then one is as near
    #[test]
    fn the_stylus_stops_where_the_part_is_as_near_as_its_radius(
        solid in any_solid(),
        from in [-40.0..40.0, -40.0..40.0, -45.0..10.0],
        to in [-40.0..40.0, -40.0..40.0, -45.0..10.0],
    ) {
        let part = boundary(vec![solid]);
        let radius = ideal_probe().stylus_radius();
        prop_assume!(least(&part, V3::from(from)) > radius + 0.01);
        let to = match part.first(ideal_probe().radius, Mcs(from), Mcs(to)) {
            Contact::None => to,
            Contact::Hit(Obstacle { ball, .. }) => ball.0,
            Contact::Already(..) => return Err(TestCaseError::reject("the ball is in the part")),
        };
        let met = caught(&part, &slim(), from, to);
        let end = met.map_or(1.0, |met| met.part);
        let way = V3::from(to) - V3::from(from);
        for step in 0..=10 {
            let ball = V3::from(from) + way * (end * f64::from(step) / 10.0);
            let distance = least(&part, ball);
            prop_assert!(distance > radius - 0.005, "{distance} {met:?} {ball:?}");
        }
        if let Some(met) = met {
            let distance = least(&part, stop(from, to, &met));
            prop_assert!((distance - radius).abs() < 0.005, "{distance} {met:?}");
            let away = part.distance(met.point);
            prop_assert!(away.abs() < 1e-6, "{away} {met:?}");
        }
    }
}
