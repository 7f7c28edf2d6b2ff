//! Every motion of every variant of CYCLE961: order, ways, heights, feeds.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, Lettered, PLANE_FEED, lettered, same_lettered};
use crate::catalogue::sinumerik::testing::{at, call, run, setup, solid};
use crate::control::Plane;
use crate::geometry::{Degrees, Mcs};
use crate::machine::Sim;
use crate::workpiece::Shape;

/// Motions at a right corner at the zero between plus abscissa and plus ordinate, part or pocket.
fn motions(plane: Plane, variant: i64, values: &[(&'static str, f64)], start: [f64; 3]) -> Vec<Lettered> {
    let (angle, length) = (Degrees(90.0), [200.0; 2]);
    let shape = match variant % 2 == 0 {
        true => Shape::OuterCorner { angle, length, height: 50.0 },
        false => Shape::InnerCorner { angle, length, depth: 50.0 },
    };
    let mut setup = setup(plane);
    setup.workpiece.solids.push(solid(plane, shape, [0.0; 3], false));
    setup.control.set("_SPEED[1]", PLANE_FEED);
    setup.control.set("_SPEED[2]", DEPTH_FEED);
    setup.position = Mcs(at(plane, start));
    let mut sim = Sim::new(&setup);
    assert_eq!(run(&mut sim, &call("CYCLE961", variant, values)), Ok(()), "{variant} {plane:?}");
    lettered(&sim, plane)
}

/// Positioning to a place in the plane, a touch at 3 mm before the edge, back.
fn touch(place: [f64; 2], axis: usize, ball: f64, height: f64) -> Vec<Lettered> {
    let before = [place[0], place[1], height];
    let mut contact = before;
    contact[axis] = ball;
    vec![('m', contact), ('r', before)]
}

#[test]
fn variants_with_distances_move_as_their_tables_say() {
    // oracle: manual B:7984-8016 (order, half distances, 10 degree, over the corner, around it, end), hand (figures)
    let height = -10.0;
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for (variant, lift) in [(105, 0.0), (107, 0.0), (106, 25.0), (108, 25.0), (106, 0.0), (108, 0.0)] {
            let outside = variant % 2 == 0;
            let start = if outside { [-14.0, -15.0, height] } else { [14.0, 15.0, height] };
            let (sine, cosine) = 10.0_f64.to_radians().sin_cos();
            // away from the edges: outside to the minus sides, inside to the plus sides
            let away = if outside { -sine } else { sine };
            let first = |way: f64| [start[0] + way * cosine, start[1] + way * away];
            let second = |way: f64| [start[0] + way * away, start[1] + way * cosine];
            let ball = if outside { -3.0 } else { 3.0 };
            let to = |place: [f64; 2], height: f64| [place[0], place[1], height];
            let [p1, p2, p3, p4] = [first(50.0), first(100.0), second(40.0), second(80.0)];
            let mut wanted = vec![('p', to(p2, height))];
            wanted.extend(touch(p2, 1, ball, height));
            wanted.push(('p', to(p1, height)));
            wanted.extend(touch(p1, 1, ball, height));
            match (outside, lift) {
                (true, 0.0) => wanted.extend([('p', start), ('p', to(p3, height))]),
                (true, lift) => {
                    wanted.extend([('d', to(p1, height + lift)), ('p', to(p3, height + lift)), ('d', to(p3, height))])
                }
                _ => wanted.push(('p', to(p3, height))),
            }
            wanted.extend(touch(p3, 0, ball, height));
            if variant > 106 {
                wanted.push(('p', to(p4, height)));
                wanted.extend(touch(p4, 0, ball, height));
            }
            wanted.push(('p', start));
            let values = [
                ("_STA1", 0.0),
                ("_INCA", 90.0),
                ("_SETV[0]", 100.0),
                ("_SETV[1]", 80.0),
                ("_SETV[4]", 1.0),
                ("_ID", lift),
            ];
            let found = motions(plane, variant, &values, start);
            same_lettered(&found, &wanted, &format!("{variant} {plane:?}"));
        }
    }
}

#[test]
fn variants_with_points_move_as_their_tables_say() {
    // oracle: manual B:8046-8050, B:8158-8170 (order, heights, end), hand (figures)
    let (over, height) = (20.0, -10.0);
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for variant in [117, 118] {
            let side = if variant == 118 { -1.0 } else { 1.0 };
            let places = [[40.0, 14.0 * side], [90.0, 12.0 * side], [13.0 * side, 35.0], [11.0 * side, 70.0]];
            let mut wanted = Vec::new();
            for (index, axis) in [(1, 1), (0, 1), (2, 0), (3, 0)] {
                let place = places[index];
                wanted.push(('p', [place[0], place[1], over]));
                wanted.push(('d', [place[0], place[1], height]));
                wanted.extend(touch(place, axis, 3.0 * side, height));
                wanted.push(('d', [place[0], place[1], over]));
            }
            let mut values = vec![("_ID", height - over)];
            for (names, place) in super::super::params::PLACES.into_iter().zip(places) {
                values.extend([(names[0].as_str(), place[0]), (names[1].as_str(), place[1])]);
            }
            let found = motions(plane, variant, &values, [30.0, 50.0, over]);
            same_lettered(&found, &wanted, &format!("{variant} {plane:?}"));
        }
    }
}

#[test]
fn the_path_is_at_least_twenty_millimetres_before_and_behind() {
    // oracle: manual B:8146-8154, B:7921: a corner 39 mm before the points is reached with _FA = 2, one at 41 mm is not
    let reached = |away: f64| {
        let mut setup = setup(Plane::G17);
        let (angle, length) = (Degrees(90.0), [200.0; 2]);
        let shape = Shape::OuterCorner { angle, length, height: 50.0 };
        setup.workpiece.solids.push(solid(Plane::G17, shape, [0.0; 3], false));
        setup.position = Mcs([30.0, 50.0, 20.0]);
        let out = -away - 3.0;
        let places = [[60.0, out], [90.0, out], [out, 65.0], [out, 90.0]];
        let mut values = vec![("_ID", -30.0), ("_FA", 2.0)];
        for (names, place) in super::super::params::PLACES.into_iter().zip(places) {
            values.extend([(names[0].as_str(), place[0]), (names[1].as_str(), place[1])]);
        }
        run(&mut Sim::new(&setup), &call("CYCLE961", 118, &values)).is_ok()
    };
    assert!(reached(39.0) && !reached(41.0));
}
