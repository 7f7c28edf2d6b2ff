//! Every motion of every variant of CYCLE979: order, side, height, feed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::VARIANTS;
use super::simulation::{CENTRE, HEIGHT, inputs, part, ready, round};
use crate::catalogue::sinumerik::motion_testing::{DEPTH_FEED, MEASURING_FEED, PLANE_FEED};
use crate::catalogue::sinumerik::testing::{Motion, at, motions, run, same, solid, stopped};
use crate::control::Plane;
use crate::geometry::Degrees;
use crate::machine::trace::MotionKind::{Measuring, Positioning, Retract};
use crate::machine::{Sim, Step, Stop};
use crate::message::Message;
use crate::workpiece::Shape;

/// `_RF`.
const CIRCLE_FEED: f64 = 900.0;
/// Starting angle.
const ANGLE: f64 = 20.0;

/// Where the ball stands, from the centre at measuring height: distance, direction, height.
fn polar(distance: f64, angle: f64, height: f64) -> [f64; 3] {
    let (sine, cosine) = Degrees(angle).sin_cos();
    [distance * cosine, distance * sine, height]
}

/// To a point: straight where `way` says how, then the touch and back. Ball of radius 3, `_FA` 5, size 60: inside the
/// ball touches at 27 and starts at 22, outside 33 and 38.
fn point(inside: bool, angle: f64, expected: &mut Vec<Motion>) {
    let [start, contact] = if inside { [22.0, 27.0] } else { [38.0, 33.0] };
    expected.push((Measuring, polar(contact, angle, 0.0), MEASURING_FEED));
    expected.push((Retract, polar(start, angle, 0.0), PLANE_FEED));
}

/// The motions as the manual tells them.
fn expected(variant: i64, step: f64, points: usize) -> Vec<Motion> {
    let inside = variant % 2 == 1;
    let start = if inside { 22.0 } else { 38.0 };
    let mut all = vec![(Positioning, polar(start, ANGLE, 0.0), PLANE_FEED)];
    point(inside, ANGLE, &mut all);
    match variant % 10 {
        1 | 2 => {
            for index in 1..points {
                let angle = ANGLE + index as f64 * step;
                all.push((Positioning, polar(start, angle, 0.0), CIRCLE_FEED));
                point(inside, angle, &mut all);
            }
        }
        3 => {
            all.push((Positioning, polar(start, ANGLE + 180.0, 0.0), PLANE_FEED));
            point(inside, ANGLE + 180.0, &mut all);
        }
        _ => {
            all.push((Positioning, polar(start, ANGLE, 20.0), DEPTH_FEED));
            all.push((Positioning, polar(start, ANGLE + 180.0, 20.0), PLANE_FEED));
            all.push((Positioning, polar(start, ANGLE + 180.0, 0.0), DEPTH_FEED));
            point(inside, ANGLE + 180.0, &mut all);
        }
    }
    all
}

/// Degrees of the ways round the centre, which keep their distance from it.
fn around(sim: &Sim, plane: Plane, origin: [f64; 3]) -> Vec<f64> {
    let mut degrees = Vec::new();
    for entry in &sim.trace.entries {
        let Step::Motion { from, to, around: Some(around), .. } = entry.step else { continue };
        let away = |part: f64| {
            let at = around.at(from, to, part);
            let [x, y, _] = plane.axes().map(|i| at[i] - origin[i]);
            x.hypot(y)
        };
        assert!([0.3, 0.7].iter().all(|part| (away(*part) - away(0.0)).abs() < 1e-9));
        degrees.push(around.degrees.0);
    }
    degrees
}

// oracle: manual B:6835-6858, B:6898-6939 (order, circular ways with the sign of _INCA, lifting over a web, end before
// the last point), hand (figures)
#[test]
fn every_variant_moves_as_the_manual_says() {
    for plane in [Plane::G17, Plane::G18, Plane::G19] {
        for variant in VARIANTS.iter().map(|variant| variant.number) {
            for (step, points) in [(80.0, 3), (-80.0, 3), (85.0, 4), (-25.0, 4)] {
                let mut setup = ready(plane, variant, ANGLE);
                setup.workpiece.solids.push(part(plane, variant, ANGLE));
                setup.control.set("_SPEED[1]", PLANE_FEED);
                setup.control.set("_SPEED[2]", DEPTH_FEED);
                let mut sim = Sim::new(&setup);
                let inputs = inputs(variant, ANGLE, step, points == 4);
                let what = format!("{variant} {step} {points} {plane:?}");
                assert_eq!(run(&mut sim, &inputs), Ok(()), "{what}");
                let origin = at(plane, [CENTRE[0], CENTRE[1], HEIGHT]);
                same(&motions(&sim, plane, origin), &expected(variant, step, points), &what);
                let ways = if round(variant) { points - 1 } else { 0 };
                assert_eq!(around(&sim, plane, origin), vec![step; ways], "{what}");
            }
        }
    }
}

/// A post of 6 mm on the way from P1 to P2, 40 degree behind P1.
fn obstructed(monitored: bool) -> (Sim, Result<(), Stop>) {
    let plane = Plane::G17;
    let mut setup = ready(plane, 1, ANGLE);
    setup.control.set("_CHBIT[2]", f64::from(u8::from(monitored)));
    let [x, y, _] = polar(22.0, ANGLE + 40.0, 0.0);
    let post = Shape::Shaft { diameter: 6.0, height: 20.0 };
    let place = [CENTRE[0] + x, CENTRE[1] + y, HEIGHT + 5.0];
    setup.workpiece.solids = vec![part(plane, 1, ANGLE), solid(plane, post, place, false)];
    let mut sim = Sim::new(&setup);
    let outcome = run(&mut sim, &inputs(1, ANGLE, 80.0, false));
    (sim, outcome)
}

// oracle: manual B:13743-13766 (61302, or nothing that watches), hand: ball and post are 6 mm apart 2·asin(6/44) before
// it
#[test]
fn what_stands_on_the_circular_way_is_met_there() {
    for monitored in [true, false] {
        let (sim, outcome) = obstructed(monitored);
        if monitored {
            assert_eq!(stopped(outcome), 61302);
        } else {
            let crash = Message::new("run-crash");
            assert_eq!(outcome, Err(Stop::Fault(crash)));
        }
        let origin = at(Plane::G17, [CENTRE[0], CENTRE[1], HEIGHT]);
        let gone = around(&sim, Plane::G17, origin);
        let free = 40.0 - 2.0 * (6.0_f64 / 44.0).asin().to_degrees();
        assert!(gone.len() == 1 && (gone[0] - free).abs() < 1e-6, "{gone:?} {free}");
    }
}
