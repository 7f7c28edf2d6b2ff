#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! Identities of contact: they need no second implementation.

use super::{Boundary, Contact, Heights, Obstacle, PartErrors, Shape, Solid, Workpiece};
use crate::geometry::{Degrees, Mcs, Rpy, V3, rigid};
use proptest::prelude::*;
use std::sync::Arc;

fn part(shape: Shape, errors: PartErrors) -> Workpiece {
    Workpiece { solids: vec![Solid { shape, at: Mcs::default(), rotation: Rpy::default(), errors }] }
}

fn first(part: &Workpiece, radius: f64, from: [f64; 3], to: [f64; 3]) -> Contact {
    Boundary::of(part).first(radius, Mcs(from), Mcs(to))
}

fn distance(part: &Workpiece, point: [f64; 3]) -> f64 {
    Boundary::of(part).distance(Mcs(point))
}

fn shapes() -> Vec<Shape> {
    vec![
        Shape::Hole { diameter: 30.0, depth: 20.0 },
        Shape::Shaft { diameter: 30.0, height: 20.0 },
        Shape::Groove { width: 24.0, depth: 20.0, length: 60.0 },
        Shape::Web { width: 24.0, height: 20.0, length: 60.0 },
        Shape::Pocket { length: [40.0, 26.0], depth: 20.0 },
        Shape::Island { length: [40.0, 26.0], height: 20.0 },
        Shape::Block { size: [60.0, 50.0, 20.0] },
        Shape::Turned { diameter: 30.0, length: 20.0, bore: [0.0; 2] },
        Shape::Turned { diameter: 46.0, length: 22.0, bore: [28.0, 14.0] },
        Shape::Sphere { diameter: 30.0 },
        Shape::OuterCorner { angle: Degrees(50.0), length: [60.0, 50.0], height: 20.0 },
        Shape::InnerCorner { angle: Degrees(115.0), length: [40.0, 50.0], depth: 20.0 },
    ]
}

fn shape() -> impl Strategy<Value = Shape> {
    prop::sample::select(shapes())
}

fn errors() -> impl Strategy<Value = PartErrors> {
    let shift = [-5.0..5.0, -5.0..5.0, -5.0..5.0];
    let tilt = [-4.0..4.0, -4.0..4.0, -180.0..180.0];
    let lobes = prop_oneof![Just((0.0, 0)), (-0.2..0.2f64, 2..6u32)];
    (shift, -0.5..0.5, tilt, prop_oneof![Just(0.0), -0.1..0.1], lobes).prop_map(
        |(shift, size, tilt, taper, out_of_round)| PartErrors { shift, size, tilt: Rpy(tilt), taper, out_of_round },
    )
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [-45.0..45.0, -45.0..45.0, -30.0..25.0]
}

// oracle: hand: a ball of radius 2 in the middle of a hole of 50 has 23 mm to go
#[test]
fn hole_touched_centrally() {
    let hole = part(Shape::Hole { diameter: 50.0, depth: 20.0 }, PartErrors::default());
    for direction in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.6, 0.8]] {
        let to = [40.0 * direction[0], 40.0 * direction[1], -5.0];
        let Contact::Hit(Obstacle { part: t, point, normal, .. }) = first(&hole, 2.0, [0.0, 0.0, -5.0], to) else {
            panic!("no hit")
        };
        assert!((t * 40.0 - 23.0).abs() < 1e-12, "{t}");
        assert!((point[0] - 25.0 * direction[0]).abs() < 1e-12 && (normal[0] + direction[0]).abs() < 1e-12);
    }
}

// oracle: hand: chord of a hole at 10 mm beside the centre, radius 25 − 2 = 23
#[test]
fn hole_touched_beside_the_centre() {
    let hole = part(Shape::Hole { diameter: 50.0, depth: 20.0 }, PartErrors::default());
    let Contact::Hit(Obstacle { ball, .. }) = first(&hole, 2.0, [0.0, 10.0, -5.0], [40.0, 10.0, -5.0]) else {
        panic!("no hit")
    };
    assert!((ball[0] - (23.0f64 * 23.0 - 100.0).sqrt()).abs() < 1e-12);
}

// oracle: hand: rim of the hole: ball centre 1 mm above the face, sqrt(r² − 1) off the edge
#[test]
fn rim_of_a_hole() {
    let hole = part(Shape::Hole { diameter: 50.0, depth: 20.0 }, PartErrors::default());
    let Contact::Hit(Obstacle { ball, point, .. }) = first(&hole, 2.0, [0.0, 0.0, 1.0], [40.0, 0.0, 1.0]) else {
        panic!("no hit")
    };
    assert!((ball[0] - (25.0 - 3f64.sqrt())).abs() < 1e-11, "{ball:?}");
    assert!((point[0] - 25.0).abs() < 1e-12 && point[2].abs() < 1e-12);
}

// oracle: hand: ball of 3 on a sphere of 25, 4 mm beside its centre and 8 mm above it: 28² = x² + 4² + 8²
#[test]
fn sphere_touched_beside_the_centre() {
    let sphere = part(Shape::Sphere { diameter: 50.0 }, PartErrors::default());
    let Contact::Hit(Obstacle { ball, normal, .. }) = first(&sphere, 3.0, [40.0, 4.0, 8.0], [0.0, 4.0, 8.0]) else {
        panic!("no hit")
    };
    let reached = (28.0_f64 * 28.0 - 80.0).sqrt();
    assert!((ball[0] - reached).abs() < 1e-12, "{ball:?}");
    for (is, wanted) in normal.iter().zip([reached, 4.0, 8.0]) {
        assert!((is - wanted / 28.0).abs() < 1e-12, "{normal:?}");
    }
}

// oracle: hand: r(angle) = 25 + 0.1·cos(3·angle)
#[test]
fn lobed_hole_along_its_lobes() {
    let errors = PartErrors { out_of_round: (0.1, 3), ..PartErrors::default() };
    let hole = part(Shape::Hole { diameter: 50.0, depth: 20.0 }, errors);
    let reach = |x: f64| match first(&hole, 0.5, [0.0, 0.0, -5.0], [x, 0.0, -5.0]) {
        Contact::Hit(Obstacle { ball, .. }) => ball[0],
        other => panic!("{other:?}"),
    };
    assert!((reach(40.0) - 24.6).abs() < 1e-9, "{}", reach(40.0));
    assert!((reach(-40.0) + 24.4).abs() < 1e-9, "{}", reach(-40.0));
}

// oracle: hand
#[test]
fn touching_at_the_start() {
    let block = part(Shape::Block { size: [60.0, 50.0, 20.0] }, PartErrors::default());
    let deep = first(&block, 2.0, [0.0, 0.0, 1.9], [0.0, 0.0, 10.0]);
    assert!(matches!(deep, Contact::Already(_, depth) if (depth - 0.1).abs() < 1e-12), "{deep:?}");
    let inside = first(&block, 2.0, [0.0, 0.0, -1.0], [0.0, 0.0, 10.0]);
    assert!(matches!(inside, Contact::Already(_, depth) if (depth - 3.0).abs() < 1e-12), "{inside:?}");
    assert_eq!(first(&block, 2.0, [0.0, 0.0, 2.0], [0.0, 0.0, 10.0]), Contact::None);
    assert_eq!(first(&block, 2.0, [0.0, 0.0, 2.0], [9.0, 0.0, 2.0]), Contact::None);
    assert!(matches!(first(&block, 2.0, [0.0, 0.0, 2.0], [0.0, 0.0, 1.0]), Contact::Hit(Obstacle { part: 0.0, .. })));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: definition: at the hit the ball touches, before it nothing is closer than its radius
    #[test]
    fn the_hit_touches_and_is_the_first(
        shape in shape(), errors in errors(), radius in 0.3..4.0, from in point(), to in point()
    ) {
        let part = part(shape, errors);
        let (start, end) = (V3::from(from), V3::from(to));
        match first(&part, radius, from, to) {
            Contact::Already(..) => prop_assert!(distance(&part, from) < radius),
            Contact::None => check_free(&part, radius, start, end)?,
            Contact::Hit(Obstacle { part: t, ball, point, normal, .. }) => {
                prop_assert!((0.0..=1.0).contains(&t));
                prop_assert!((distance(&part, ball.0) - radius).abs() < 1e-9);
                let away = V3::from(ball) - V3::from(point);
                prop_assert!((away.norm() - radius).abs() < 1e-9);
                prop_assert!((away / radius - V3::from(normal)).norm() < 1e-8);
                check_free(&part, radius, start, V3::from(ball))?;
                // and it enters there
                let deeper = V3::from(ball) + (end - start).normalize() * 1e-3;
                prop_assert!(distance(&part, deeper.into()) < radius + 1e-9);
            }
        }
    }

    // oracle: definition: turning and moving part and path together changes nothing
    #[test]
    fn rigid_motion_changes_nothing(
        shape in shape(), errors in errors(), radius in 0.3..4.0, from in point(), to in point(),
        turn in [-180.0..180.0, -80.0..80.0, -180.0..180.0], at in [-300.0..300.0, -300.0..300.0, -300.0..300.0]
    ) {
        let plain = PartErrors { shift: [0.0; 3], tilt: Rpy::default(), ..errors };
        let part = part(shape.clone(), plain);
        let moved = Workpiece { solids: vec![Solid { shape, at: Mcs(at), rotation: Rpy(turn), errors: plain }] };
        let place = rigid::placed(V3::from(at), rigid::rotation(Rpy(turn)));
        let there = |p: [f64; 3]| <[f64; 3]>::from(place.transform_point(&V3::from(p).into()).coords);
        match (first(&part, radius, from, to), first(&moved, radius, there(from), there(to))) {
            (Contact::Hit(one), Contact::Hit(other)) => {
                let length = (V3::from(to) - V3::from(from)).norm();
                prop_assert!((one.part - other.part).abs() * length < 1e-7, "{one:?} {other:?}");
                prop_assert!((V3::from(there(one.point.0)) - V3::from(other.point)).norm() < 1e-3);
            }
            (Contact::None, Contact::None) | (Contact::Already(..), Contact::Already(..)) => {}
            (one, other) => prop_assert!(false, "{one:?} {other:?}"),
        }
    }
}

/// No point of the way is nearer to the part than the radius (sampled).
fn check_free(part: &Workpiece, radius: f64, from: V3, to: V3) -> Result<(), TestCaseError> {
    for i in 0..=60 {
        let p = from + (to - from) * (f64::from(i) / 60.0);
        let gap = distance(part, p.into());
        prop_assert!(gap > radius - 1e-8, "at {i}/60: {gap} < {radius}");
    }
    Ok(())
}

// oracle: hand: the second edge runs along (1/2, √3/2), its wall faces (√3/2, -1/2) into the part. A wall stands out by
// half of the error of size, in a pocket away from the ball.
#[test]
fn the_walls_of_a_corner_stand_out_by_half_of_its_error() {
    let errors = PartErrors { size: 0.4, ..PartErrors::default() };
    let (angle, length, depth) = (Degrees(60.0), [50.0, 40.0], 30.0);
    let outer = Shape::OuterCorner { angle, length, height: depth };
    let inner = Shape::InnerCorner { angle, length, depth };
    let root = 3.0_f64.sqrt() / 2.0;
    let first_wall = |way: f64| [25.0, way, -15.0];
    let second_wall = |way: f64| [10.0 + root * way, 20.0 * root - way / 2.0, -15.0];
    for (shape, into) in [(outer, -7.0), (inner, 7.0)] {
        let part = part(shape, errors);
        for place in [first_wall(into), second_wall(into)] {
            let found = distance(&part, place);
            let wanted = if into < 0.0 { 6.8 } else { 7.2 };
            assert!((found - wanted).abs() < 1e-9, "{place:?} {found}");
        }
    }
}

// oracle: hand: on a plane that falls by 3 in 4 the centre of a ball stands 5/4 of its radius above what it touches
#[test]
fn a_free_surface_is_touched_like_any_solid() {
    let heights = Heights::over([40.0, 40.0], [10, 10], |x, _| -0.75 * x);
    let surface = heights.surface().unwrap();
    let free = part(Shape::Free(Arc::new(surface)), PartErrors::default());
    let free = Boundary::of(&free);
    let found = free.first(4.0, Mcs([0.0, 1.0, 30.0]), Mcs([0.0, 1.0, -30.0]));
    let Contact::Hit(Obstacle { ball, normal, .. }) = found else { panic!("{found:?}") };
    assert!((ball[2] - 5.0).abs() < 1e-9);
    assert!((normal[0] - 0.6).abs() < 1e-9 && (normal[2] - 0.8).abs() < 1e-9);
    let under = free.first(4.0, Mcs([0.0, 0.0, -9.0]), Mcs([0.0, 0.0, -9.0]));
    assert!(matches!(under, Contact::Already(..)));
    assert!((free.distance(Mcs([0.0, 0.0, 5.0])) - 4.0).abs() < 1e-9);
    assert!((free.distance(Mcs([0.0, 0.0, -5.0])) + 4.0).abs() < 1e-9);
}
