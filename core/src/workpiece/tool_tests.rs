//! Tools against tool probes.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::tool_probe::{Contact, first, obstacle, touch};
use super::{Cut, Cutter, Nose, Obstacle, PartErrors, Shape, Solid, Spindle, Tool, ToolProbe, Workpiece, tool::Piece};
use crate::control::{Control, Edge, Plane, delivery, tools::side};
use crate::dialect::Dialect;
use crate::geometry::{Convex, Degrees, Mcs, Rpy, V3, rigid};
use crate::workpiece::{Boundary, Noise, contact::Contact as BallContact};
use proptest::prelude::*;

/// Cube of 20 mm, its upper side at Z 80 about X 39 Y 31, as in the manual's examples (B:4433-4446).
fn cube(plane: Plane) -> ToolProbe {
    probe(plane, Shape::Block { size: [20.0, 20.0, 15.0] })
}

fn disc(plane: Plane) -> ToolProbe {
    probe(plane, Shape::Turned { diameter: 20.0, length: 15.0, bore: [0.0; 2] })
}

fn probe(plane: Plane, shape: Shape) -> ToolProbe {
    let rotation = Rpy(match plane {
        Plane::G17 => [0.0; 3],
        Plane::G18 => [-90.0, 0.0, 0.0],
        Plane::G19 => [0.0, 90.0, 0.0],
    });
    ToolProbe::ideal(Solid { shape, at: Mcs(at(plane, [39.0, 31.0, 80.0])), rotation, errors: PartErrors::default() })
}

fn at(plane: Plane, place: [f64; 3]) -> [f64; 3] {
    let mut point = [0.0; 3];
    for (axis, value) in plane.axes().into_iter().zip(place) {
        point[axis] = value;
    }
    point
}

fn mill(cutter: Cutter) -> Tool {
    Tool { length: [70.0, 0.0, 0.0], cut: Cut::Cutter(cutter) }
}

/// Way of a tool between two points of abscissa, ordinate, applicate until it meets the probe.
fn way(probe: &ToolProbe, tool: &Tool, plane: Plane, spindle: Spindle, from: [f64; 3], to: [f64; 3]) -> Option<f64> {
    let (from, to) = (at(plane, from), at(plane, to));
    let pieces = tool.pieces(V3::from(from), plane, spindle);
    first(std::slice::from_ref(probe), &pieces, Mcs(from), Mcs(to)).map(|contact| contact.meeting.way)
}

fn near(found: Option<f64>, expected: f64) {
    let found = found.expect("contact");
    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
}

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

#[test]
fn a_smooth_cutter_stands_off_by_its_radius_and_its_end() {
    // oracle: hand: faces of the probe at 29, 49 / 21, 41 / 80; cutter of 18 mm radius
    let tool = mill(Cutter::smooth(18.0));
    for plane in PLANES {
        for probe in [cube(plane), disc(plane)] {
            let way = |from, to| way(&probe, &tool, plane, Spindle::Turns, from, to);
            near(way([90.0, 31.0, 76.0], [39.0, 31.0, 76.0]), 90.0 - 67.0);
            near(way([-10.0, 31.0, 76.0], [39.0, 31.0, 76.0]), 11.0 + 10.0);
            near(way([39.0, 90.0, 76.0], [39.0, 31.0, 76.0]), 90.0 - 59.0);
            near(way([39.0, 31.0, 90.0], [39.0, 31.0, 70.0]), 10.0);
            assert_eq!(way([90.0, 31.0, 80.5], [39.0, 31.0, 80.5]), None, "passes above");
        }
    }
}

#[test]
fn a_disc_is_round_and_a_cube_has_edges() {
    // oracle: hand: circles of 10 and 5 mm 12 mm apart meet where their centres are 15 mm apart: 9 mm; past the edge of
    // the cube at 2 mm the cutter of 5 mm comes nearer by sqrt(25 - 4)
    let tool = mill(Cutter::smooth(5.0));
    for plane in PLANES {
        let (from, to) = ([90.0, 43.0, 76.0], [39.0, 43.0, 76.0]);
        let along = |probe: ToolProbe| way(&probe, &tool, plane, Spindle::Turns, from, to);
        near(along(disc(plane)), 51.0 - 9.0);
        near(along(cube(plane)), 41.0 - 21.0_f64.sqrt());
    }
}

#[test]
fn a_tooth_that_stands_touches_where_it_points() {
    // oracle: hand: two teeth at 30 and 210 degree reach 18·cos 30 along the abscissa; along the ordinate they are
    // wider than the cube, whose edge 10 mm beside the middle the one at 30 degree meets, there 10·tan 30 before the
    // axis
    let tool = mill(Cutter { teeth: 2, angle: Degrees(20.0), ..Cutter::smooth(18.0) });
    let (sine, cosine) = Degrees(30.0).sin_cos();
    for plane in PLANES {
        let probe = cube(plane);
        let way = |spindle, from, to| way(&probe, &tool, plane, spindle, from, to);
        let across = |spindle| way(spindle, [90.0, 31.0, 76.0], [39.0, 31.0, 76.0]);
        near(across(Spindle::Stands(Degrees(10.0))), 41.0 - 18.0 * cosine);
        near(across(Spindle::Turns), 41.0 - 18.0);
        let other = way(Spindle::Stands(Degrees(10.0)), [39.0, -30.0, 76.0], [39.0, 31.0, 76.0]);
        near(other, 51.0 - 10.0 * sine / cosine);
    }
}

#[test]
fn a_cutter_that_runs_out_touches_with_its_highest_edge() {
    // oracle: hand: two teeth across the direction of 0.3 mm runout reach sqrt(R² + 0.3²); along it R + 0.3, and the
    // tooth in that direction stands 0.2 mm lower
    let runs_out = |runout_angle| mill(Cutter { teeth: 2, runout: [0.3, 0.2], runout_angle, ..Cutter::smooth(5.0) });
    for (angle, reach, low) in [(90.0, 25.09_f64.sqrt(), 0.0), (0.0, 5.3, 0.2), (180.0, 5.3, 0.2)] {
        let tool = runs_out(Degrees(angle));
        let way = |from, to| way(&cube(Plane::G17), &tool, Plane::G17, Spindle::Turns, from, to);
        near(way([90.0, 31.0, 76.0], [39.0, 31.0, 76.0]), 41.0 - reach);
        near(way([39.0, 31.0, 90.0], [39.0, 31.0, 70.0]), 10.0 - low);
    }
}

#[test]
fn corner_radius_chamfer_and_point_touch_the_rim_later() {
    // oracle: hand: at 1 mm below the upper side a corner radius of 3 mm stands back by 3 - sqrt(9 - 4), a chamfer of
    // 2 x 2 mm by 1 mm, a drill's point of 118 degree by R - 1·tan 59
    let (from, to) = ([90.0, 31.0, 79.0], [39.0, 31.0, 79.0]);
    let way = |cutter: Cutter| {
        let probe = cube(Plane::G17);
        way(&probe, &mill(cutter), Plane::G17, Spindle::Turns, from, to)
    };
    let corner = Cutter { corner: 3.0, ..Cutter::smooth(8.0) };
    near(way(corner), 41.0 - (5.0 + 5.0_f64.sqrt()));
    let chamfer = Cutter { chamfer: [2.0, 2.0], ..Cutter::smooth(8.0) };
    near(way(chamfer), 41.0 - 7.0);
    let drill = Edge { kind: 200, radius: 8.0, ..Edge::default() };
    let control = delivery(Dialect::Sinumerik);
    let Cut::Cutter(drill) = Tool::nominal(&drill, &control).cut else {
        panic!("a drill is a cutter");
    };
    let found = way(drill).unwrap();
    assert!((found - (41.0 - 59.0_f64.to_radians().tan())).abs() < 1e-8, "{found}");
}

#[test]
fn a_tool_whose_radius_is_below_nothing_has_none() {
    // oracle: hand: no tool is narrower than 0, whatever wear and corner radius say
    for kind in [120, 200, 500] {
        for (radius, wear, corner) in
            [(0.0, -0.01, 0.0), (-5.0, 0.0, 1.0), (1.0, -1e300, f64::NAN), (f64::NAN, 0.0, -1.0)]
        {
            let edge = Edge { kind, radius, radius_wear: wear, further: [(7, corner)].into(), ..Edge::default() };
            for dialect in [Dialect::Sinumerik, Dialect::Nct] {
                let found = match Tool::nominal(&edge, &delivery(dialect)).cut {
                    Cut::Cutter(cutter) => [cutter.radius, cutter.corner],
                    Cut::Nose(nose) => [nose.radius, 0.0],
                };
                assert_eq!(found, [0.0; 2], "{edge:?}");
            }
        }
    }
}

#[test]
fn a_cutter_lies_along_the_axis_in_which_its_length_counts() {
    // oracle: manual B:762-817 (L1 along the applicate), B:9192 (as a turning tool: L2 along the abscissa, axial
    // position)
    let mill = Edge { kind: 120, radius: 8.0, ..Edge::default() };
    let mut control = delivery(Dialect::Sinumerik);
    let axis = |control: &Control| match Tool::nominal(&mill, control).cut {
        Cut::Cutter(cutter) => cutter.axis,
        Cut::Nose(_) => panic!("a mill is a cutter"),
    };
    assert_eq!(axis(&control), 2);
    control.set("SD42950", 2.0);
    assert_eq!(axis(&control), 0);
}

#[test]
fn a_turning_tool_touches_with_its_nose() {
    // oracle: hand: P is the centre of the nose plus its radius towards the tip; in the direction of the tip the
    // contact is at P, in the other 2 R behind it
    for (position, along) in [(3, -1.0), (2, -1.0), (7, -1.0), (1, 1.0), (4, 1.0), (5, 1.0)] {
        let nose = Nose { radius: 0.8, side: side(position, false) };
        let tool = Tool { length: [0.0; 3], cut: Cut::Nose(nose) };
        let (from, face) = (39.0 - along * 40.0, 39.0 - along * 10.0);
        let centred = 31.0 + nose.side[1] * nose.radius;
        let (from, to) = ([from, centred, 76.0], [39.0, centred, 76.0]);
        let probe = cube(Plane::G18);
        let found = way(&probe, &tool, Plane::G18, Spindle::Stands(Degrees(0.0)), from, to);
        near(found, (face - from[0]).abs());
    }
    let nose = Nose { radius: 0.8, side: side(3, false) };
    let tool = Tool { length: [0.0; 3], cut: Cut::Nose(nose) };
    let probe = cube(Plane::G18);
    let (from, to) = ([0.0, 30.2, 76.0], [39.0, 30.2, 76.0]);
    let found = way(&probe, &tool, Plane::G18, Spindle::Stands(Degrees(0.0)), from, to);
    near(found, 29.0 - 1.6);
}

#[test]
fn a_probe_that_gave_way_lets_the_tool_out() {
    // oracle: hand
    let probes = [cube(Plane::G17)];
    let tool = mill(Cutter::smooth(5.0));
    let meets = |from: [f64; 3], to: [f64; 3]| -> Option<Contact> {
        let pieces: Vec<Piece> = tool.pieces(V3::from(from), Plane::G17, Spindle::Turns);
        obstacle(&probes, &pieces, Mcs(from), Mcs(to))
    };
    assert!(meets([53.9, 31.0, 76.0], [60.0, 31.0, 76.0]).is_none());
    assert!(meets([54.0, 31.0, 76.0], [60.0, 31.0, 76.0]).is_none());
    let deeper = meets([53.9, 31.0, 76.0], [50.0, 31.0, 76.0]).unwrap();
    assert_eq!(deeper.meeting.way, 0.0);
    assert!(meets([39.0, 31.0, 76.0], [90.0, 31.0, 76.0]).is_some(), "from inside");
}

#[test]
fn the_signal_comes_late_and_scatters() {
    // oracle: hand: 0.02 mm of travel and 1 ms at 300 mm/min are 0.025 mm
    let late = ToolProbe { pre_travel: 0.02, delay: 0.001, ..cube(Plane::G17) };
    let tool = mill(Cutter::smooth(5.0));
    let (from, to) = (Mcs([60.0, 31.0, 76.0]), Mcs([48.0, 31.0, 76.0]));
    let pieces = tool.pieces(V3::from(from), Plane::G17, Spindle::Turns);
    let mut noise = Noise::new(1);
    let (contact, signal) = touch(std::slice::from_ref(&late), &pieces, from, to, 300.0, &mut noise).unwrap();
    near(Some(contact.meeting.way), 6.0);
    near(Some(signal), 6.025);
    let scatters = ToolProbe { repeatability: (0.001, 1), ..late };
    let mut signal = || touch(std::slice::from_ref(&scatters), &pieces, from, to, 300.0, &mut noise).unwrap().1;
    assert_ne!(signal(), signal());
}

struct Ball(V3, f64);

impl Convex for Ball {
    fn farthest(&self, direction: &V3) -> V3 {
        let Ball(centre, radius) = self;
        centre + direction.try_normalize(0.0).unwrap_or_else(V3::x) * *radius
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// oracle: the ball and the block of the workpiece, which are calculated in another way
    #[test]
    fn a_ball_nose_meets_a_cube_as_a_ball_does(
        from in prop::array::uniform3(-60.0..60.0_f64),
        to in prop::array::uniform3(-30.0..30.0_f64),
        tilt in prop::array::uniform3(-40.0..40.0_f64),
        radius in 0.5..12.0_f64,
    ) {
        let mut solid = cube(Plane::G17).solid;
        (solid.at, solid.errors.tilt) = (Mcs::default(), Rpy(tilt));
        let part = Workpiece { solids: vec![solid.clone()] };
        let ball = Boundary::of(&part).first(radius, Mcs(from), Mcs(to));
        let pieces = [Ball(V3::from(from), radius)];
        let length = (V3::from(to) - V3::from(from)).norm();
        let met = first(&[ToolProbe::ideal(solid)], &pieces, Mcs(from), Mcs(to));
        match (ball, met) {
            (BallContact::None, None) => {}
            (BallContact::Already(..), Some(met)) => prop_assert_eq!(met.meeting.way, 0.0),
            (BallContact::Hit(Obstacle { part: t, .. }), Some(met)) => {
                prop_assert!((t * length - met.meeting.way).abs() < 1e-9, "{} {:?}", t * length, met);
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }

    /// oracle: a rigid motion of tool, probe and way changes no length (turned about the axis of both)
    #[test]
    fn contact_does_not_depend_on_place_and_direction(
        shift in prop::array::uniform3(-500.0..500.0_f64),
        turn in 0.0..360.0_f64,
        start in prop::array::uniform3(-25.0..25.0_f64),
        round in any::<bool>(),
        corner in 0.0..4.0_f64,
        spindle in prop::option::of(0.0..360.0_f64),
    ) {
        let tool = mill(Cutter { teeth: 3, angle: Degrees(7.0), corner, chamfer: [0.5, 1.0], runout: [0.05, 0.02],
            ..Cutter::smooth(6.0) });
        let from = [40.0 + start[0], start[1], start[2]];
        let to = [-10.0, start[1] / 2.0, -6.0];
        let mut probe = if round { disc(Plane::G17) } else { cube(Plane::G17) };
        probe.solid.at = Mcs::default();
        let reach = |probe: &ToolProbe, turned: f64, from: [f64; 3], to: [f64; 3]| {
            let spindle = spindle.map_or(Spindle::Turns, |angle| Spindle::Stands(Degrees(angle + turned)));
            way(probe, &tool, Plane::G17, spindle, from, to)
        };
        let here = reach(&probe, 0.0, from, to);
        let motion = rigid::placed(shift.into(), rigid::rotation(Rpy([0.0, 0.0, turn])));
        let moved = |point: [f64; 3]| -> [f64; 3] { motion.transform_point(&V3::from(point).into()).coords.into() };
        (probe.solid.at, probe.solid.rotation) = (Mcs(moved([0.0; 3])), Rpy([0.0, 0.0, turn]));
        let there = reach(&probe, turn, moved(from), moved(to));
        prop_assert_eq!(here.is_some(), there.is_some());
        if let (Some(here), Some(there)) = (here, there) {
            prop_assert!((here - there).abs() < 1e-9, "{here} {there}");
        }
    }
}
