#![allow(clippy::unwrap_used, clippy::panic)]
//! What arcs meet, against the distance of the part at many places of them.

use super::Route;
use crate::geometry::{Around, Degrees, Dir, Mcs, V3};
use crate::machine::ideal_probe;
use crate::workpiece::feeler_tests::{any_solid, boundary, least};
use crate::workpiece::{Boundary, Feeler, Obstacle, Shape, Solid, Touching};
use proptest::prelude::*;

const RADIUS: f64 = 3.0;
/// Places at which the part is asked for its distance.
const PLACES: u32 = 200;

/// From a place so far round an axis through a point, with a climb.
fn around(from: V3, centre: V3, axis: V3, degrees: f64, climb: f64) -> Route {
    let around = Around { centre: centre.into(), axis: axis.normalize().into(), degrees: Degrees(degrees) };
    Route { from: from.into(), to: around.end(from.into(), climb), around: Some(around) }
}

fn met(part: &Boundary, probe: &Feeler, way: &Route) -> (Option<Obstacle>, usize) {
    let mut effort = 0;
    let met = way.obstacle(part, probe, Dir::default(), &mut effort);
    (met, effort)
}

/// Least of a measure on a part of the way, by places close together.
fn lowest(way: &Route, end: f64, measure: impl Fn(V3) -> f64) -> f64 {
    let places = (0..=PLACES).map(|i| way.at(end * f64::from(i) / f64::from(PLACES)));
    places.map(|place| measure(place.into())).fold(f64::INFINITY, f64::min)
}

/// Arcs, helices and circles: upright to an axis, or askew.
fn any_arc() -> impl Strategy<Value = Route> {
    let place = || [-35.0..35.0, -35.0..35.0, -30.0..12.0].prop_map(V3::from);
    let axis = prop_oneof![
        3 => Just(V3::z()),
        1 => Just(V3::x()),
        1 => Just(V3::y()),
        2 => [-1.0..1.0, -1.0..1.0, 0.1..1.0].prop_map(V3::from),
    ];
    let degrees = prop_oneof![Just(360.0), Just(-360.0), -800.0..800.0];
    let climb = prop_oneof![Just(0.0), -9.0..9.0];
    let centre = prop_oneof![Just(V3::zeros()), place()];
    (place(), centre, axis, degrees, climb)
        .prop_map(|(from, centre, axis, degrees, climb)| around(from, centre, axis, degrees, climb))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    // oracle: definition: until it is met no place is nearer than the radius, and there one is as near
    #[test]
    fn a_ball_is_stopped_where_the_part_is_as_near_as_its_radius(solid in any_solid(), way in any_arc()) {
        let part = boundary(vec![solid]);
        let gap = |place: V3| part.distance(place.into()) - RADIUS;
        prop_assume!(gap(way.from.into()) > 0.0);
        let (found, _) = met(&part, &Feeler::ball(RADIUS), &way);
        let least = lowest(&way, found.map_or(1.0, |met| met.part), gap);
        prop_assert!(least > -2e-5, "{least} {found:?}");
        if let Some(found) = found {
            let there = gap(found.ball.into());
            prop_assert!(there.abs() < 1e-8, "{there} {found:?}");
            let on = V3::from(way.at(found.part)) - V3::from(found.stop);
            prop_assert!(on.norm() < 1e-9, "{on}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    // oracle: definition: as above, of the axis of the stylus
    #[test]
    fn a_stylus_is_stopped_where_the_part_is_as_near_as_its_radius(solid in any_solid(), way in any_arc()) {
        let part = boundary(vec![solid]);
        let (probe, radius) = (Feeler::new(&ideal_probe(), Dir::new([0.0, 0.0, 1.0])), ideal_probe().stylus_radius());
        prop_assume!(least(&part, way.from.into()) > RADIUS);
        let (found, _) = met(&part, &probe, &way);
        let end = found.map_or(1.0, |met| met.part);
        for step in 0..=12 {
            let distance = least(&part, V3::from(way.at(end * f64::from(step) / 12.0)));
            prop_assert!(distance > radius - 0.005, "{distance} {found:?}");
        }
        if let Some(found) = found.filter(|met| met.by == Touching::Stylus) {
            let distance = least(&part, found.ball.into());
            prop_assert!((distance - radius).abs() < 0.005, "{distance} {found:?}");
        }
    }
}

fn solid(shape: Shape) -> Solid {
    Solid::new(shape, Mcs::default())
}

/// A full circle at this distance from the Z axis.
fn circle(radius: f64, z: f64) -> Route {
    around(V3::new(radius, 0.0, z), V3::zeros(), V3::z(), -360.0, 0.0)
}

// oracle: hand: the ball of 3 mm touches at 17 mm in a hole of 40 mm, at 23 mm beside a shaft of it, 13 mm from the
// centre of a sphere of 20 mm; a circle that is free by a millionth of that is told so without a look
#[test]
fn a_circle_close_to_a_round_wall_is_told_free_at_once() {
    let probe = Feeler::new(&ideal_probe(), Dir::new([0.0, 0.0, 1.0]));
    let depth = 30.0;
    let hole = Shape::Hole { diameter: 40.0, depth };
    let shaft = Shape::Shaft { diameter: 40.0, height: depth };
    let sphere = Shape::Sphere { diameter: 20.0 };
    let block = Shape::Block { size: [100.0, 100.0, 20.0] };
    for (shape, wall, free, z) in
        [(&hole, 17.0, -1.0, -10.0), (&hole, 17.0, -1.0, -2.0), (&shaft, 23.0, 1.0, -10.0), (&sphere, 13.0, 1.0, 0.0)]
    {
        let part = boundary(vec![solid(shape.clone())]);
        for gap in [0.0, 1e-6, 0.1] {
            let (found, effort) = met(&part, &probe, &circle(wall + free * gap, z));
            assert_eq!(found, None, "{shape:?} {gap}");
            assert!(effort < 8, "{shape:?} {gap}: {effort}");
        }
        let (found, _) = met(&part, &probe, &circle(wall - free * 1e-4, z));
        assert!(found.is_some(), "{shape:?}");
    }
    let part = boundary(vec![solid(block)]);
    assert_eq!(met(&part, &probe, &circle(10.0, 3.0)).0, None);
    assert!(met(&part, &probe, &circle(10.0, 2.9999)).0.is_some());
}

// oracle: hand: half a circle of 10 mm about [0, -12.5] reaches -2.5 at its top, a wall stands there 3 mm away less a
// bit
#[test]
fn a_graze_is_met_where_it_is_deepest() {
    let block = Shape::Block { size: [100.0, 100.0, 20.0] };
    for (deep, meets) in [(1e-4, true), (2e-5, true), (-1e-7, false)] {
        let part = boundary(vec![Solid { at: Mcs([0.0, 50.5 - deep, 10.0]), ..solid(block.clone()) }]);
        let way = around(V3::new(-10.0, -12.5, 0.0), V3::new(0.0, -12.5, 0.0), V3::z(), -180.0, 0.0);
        let (found, effort) = met(&part, &Feeler::ball(RADIUS), &way);
        assert_eq!(found.is_some(), meets, "{deep}");
        assert!(effort < 200, "{effort}");
        let at = found.map_or(0.5, |met| met.part);
        assert!((at - 0.5).abs() < 0.01, "{at}");
    }
}

// oracle: hand: an arc of 10 km past a block; and one of a nanometre beside it
#[test]
fn arcs_of_any_size_come_to_an_end() {
    let block = boundary(vec![solid(Shape::Block { size: [100.0, 100.0, 20.0] })]);
    let probe = Feeler::new(&ideal_probe(), Dir::new([0.0, 0.0, 1.0]));
    let huge = around(V3::new(0.0, 70.0, -5.0), V3::new(1e7, 70.0, -5.0), V3::z(), 360.0, 0.0);
    let (found, effort) = met(&block, &probe, &huge);
    let stop = V3::from(found.unwrap().stop);
    assert!((stop - V3::new(0.0, 53.0, -5.0)).norm() < 1e-3, "{stop}");
    assert!(effort < 400, "{effort}");
    let tiny = around(V3::new(0.0, 53.1, -5.0), V3::new(0.0, 53.1 + 1e-6, -5.0), V3::z(), 360.0, 0.0);
    assert_eq!(met(&block, &probe, &tiny).0, None);
}

// oracle: hand: a ball that is 0.2 mm in a wall goes out on an arc as on a line; one that goes on into it is stopped
#[test]
fn a_ball_may_leave_what_it_is_pressed_into() {
    let block = boundary(vec![solid(Shape::Block { size: [100.0, 100.0, 20.0] })]);
    let from = V3::new(52.8, 0.0, -5.0);
    let away = around(from, from + V3::new(0.0, 20.0, 0.0), V3::z(), 90.0, 0.0);
    assert_eq!(met(&block, &Feeler::ball(RADIUS), &away).0, None);
    let into = around(from, from + V3::new(0.0, 20.0, 0.0), V3::z(), -180.0, 0.0);
    let found = met(&block, &Feeler::ball(RADIUS), &into).0.unwrap();
    assert_eq!(found.part, 0.0);
    let short = around(from, from + V3::new(0.0, 20.0, 0.0), V3::z(), 0.3, 0.0);
    let found = met(&block, &Feeler::ball(RADIUS), &short).0.unwrap(); // 0.1 mm out
    assert_eq!((found.part, found.stop), (0.0, Mcs(from.into())));
}
