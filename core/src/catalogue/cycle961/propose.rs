//! A nominal part for CYCLE961: a part or a pocket with a corner where the values say.

use super::lines::{Point, across, along, away, direction, distance, shares, unit};
use super::params::{OUTSIDE, PASSES, POINTS};
use super::touches::{TOLERANCE, Touch, edges, touches};
use crate::catalogue::prelude::*;
use crate::evaluate::spread::Touched;
use crate::geometry::Dir;
use crate::workpiece::{Shape, Solid};

/// Measuring depth of the ball centre below the face where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;
/// How far the ball stands from the edges where there is room, mm.
const CLEAR: f64 = 10.0;
/// Edge beyond the points, mm.
const BEYOND: f64 = 15.0;

/// A corner with the directions of its edges, the reference edge first.
struct Nominal {
    corner: Point,
    edges: [Point; 2],
}

/// Part and start: opposite the corner at measuring depth, or above P2 (B:7980-7988, B:8158-8166).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = place::ball_radius(inputs, control);
    let touches = touches(inputs, control, [0.0; 2]);
    let nominal = nominal(inputs, control, &touches, ball);
    let ([x, y], height, depth) = if POINTS.holds(inputs) {
        let (height, depth) = place::above(inputs.number(names::ID).abs(), ball);
        (touches[1].at, height, depth)
    } else {
        let depth = depth(inputs, control, ball);
        ([0.0; 2], -depth, depth)
    };
    let part = solid(inputs, control, &nominal, &touches, depth + 2.0 * ball + 10.0);
    place::proposal(part, place::in_plane(control, [x, y, height * place::side(control)]))
}

fn nominal(inputs: &Inputs, control: &Control, touches: &[Touch], ball: f64) -> Nominal {
    if POINTS.holds(inputs) { by_points(touches, ball) } else { by_distances(inputs, control, ball) }
}

/// Where the nominal part is touched, P1 first.
pub fn touched(inputs: &Inputs, control: &Control) -> Vec<Touched> {
    let touches = touches(inputs, control, [0.0; 2]);
    let nominal = nominal(inputs, control, &touches, place::ball_radius(inputs, control));
    let touched =
        |(index, touch): (usize, &Touch)| Some(Touched { at: met(&nominal, index, touch)?, towards: touch.towards() });
    touches.iter().enumerate().filter_map(touched).collect()
}

/// Where a touch meets its edge.
fn met(nominal: &Nominal, index: usize, touch: &Touch) -> Option<Point> {
    let edge = nominal.edges[index / 2];
    let [way, _] = shares([touch.at, nominal.corner], [touch.towards(), edge], 0.0)?;
    Some(along(touch.at, touch.towards(), way))
}

/// Below the face; so deep that the ball passes over the corner clear of it by a third of what is left of `_ID`.
fn depth(inputs: &Inputs, control: &Control, ball: f64) -> f64 {
    let lift = inputs.number(names::ID) * place::side(control);
    if PASSES.holds(inputs) && lift > 0.0 { ((lift - ball) * 2.0 / 3.0).clamp(0.5, DEPTH) } else { DEPTH }
}

/// The corner lies before the start where the edges part, outside; behind it inside.
fn by_distances(inputs: &Inputs, control: &Control, ball: f64) -> Nominal {
    let angles = edges(inputs, control);
    let half = inputs.degrees(names::INCA).radians().abs() / 2.0;
    let (sign, beside) = if OUTSIDE.holds(inputs) {
        let room = room(inputs, angles, half, ball);
        (1.0, (ball + CLEAR).min(room).max(ball + 0.5))
    } else {
        (-1.0, ball + CLEAR)
    };
    let edges = angles.map(unit);
    let middle = direction([0.0; 2], along(edges[0], edges[1], 1.0));
    Nominal { corner: along([0.0; 2], middle, sign * beside / half.sin()), edges }
}

/// How far outside the start may lie beside the edges, so that P1 and P3 are touched on them and not at the corner: the
/// ball runs along an axis, which brings it nearer to the corner.
fn room(inputs: &Inputs, angles: [f64; 2], half: f64, ball: f64) -> f64 {
    let (sine, cosine) = TOLERANCE.to_radians().sin_cos();
    let [one, other] = [(angles[0], names::SETV0), (angles[1], names::SETV1)].map(|(angle, name)| {
        let [x, y] = unit(angle).map(f64::abs);
        let lean = x.min(y) / x.max(y);
        let way = inputs.number(name) / 2.0 * (cosine - sine * lean);
        (way - 2.0 * ball) / (1.0 / half.tan() + lean)
    });
    one.min(other)
}

/// The edges lie before the points, parallel to their lines.
fn by_points(touches: &[Touch], ball: f64) -> Nominal {
    let [p1, p2, p3, p4] = [0, 1, 2, 3].map(|index| touches[index]);
    let lines = [direction(p1.at, p2.at), direction(p3.at, p4.at)];
    let cross = |one: Point, other: Point| {
        let share = shares([one, other], lines, 0.0).map_or(0.0, |[share, _]| share);
        along(one, lines[0], share)
    };
    let meeting = cross(p1.at, p3.at);
    let nearest = touches.iter().map(|touch| distance(meeting, touch.at)).fold(f64::INFINITY, f64::min);
    let gap = (ball + CLEAR).min(nearest * 0.45).max(ball + 0.5);
    let before = |touch: Touch| along(touch.at, touch.towards(), gap);
    let corner = cross(before(p1), before(p3));
    let outward = |line: Point, touch: Touch| {
        let [x, y] = away(corner, touch.at);
        let sign = (x * line[0] + y * line[1]).signum();
        line.map(|part| part * sign)
    };
    Nominal { corner, edges: [outward(lines[0], p2), outward(lines[1], p4)] }
}

/// -1 where the WCS is mirrored, or seen from its minus side: then counter-clockwise in it is clockwise for the part.
fn handed(control: &Control) -> f64 {
    let [abscissa, ordinate, _] = control.plane.axes();
    let up = control.direction_to_machine(Dir::new(place::in_plane(control, place::outward(control)))).0;
    let about = control.turn_axis(abscissa, ordinate);
    (0..3).map(|i| up[i] * about[i]).sum::<f64>().signum()
}

fn solid(inputs: &Inputs, control: &Control, nominal: &Nominal, touches: &[Touch], height: f64) -> Solid {
    let [mut one, mut other] = nominal.edges;
    if across(one, other) * handed(control) < 0.0 {
        (one, other) = (other, one);
    }
    let (sine, cosine) = (across(one, other).abs(), one[0] * other[0] + one[1] * other[1]);
    let beyond = BEYOND / sine.max(0.05);
    // the places before the touches, and where they meet their edges
    let visited = touches.iter().enumerate().flat_map(|(index, touch)| [Some(touch.at), met(nominal, index, touch)]);
    let visited: Vec<Point> = visited.flatten().collect();
    let reach = |from: Point, line: Point, across_to: Point| {
        let shares = visited.iter().map(|place| across(away(from, *place), across_to) / across(line, across_to));
        shares.fold(0.0, f64::max) + beyond
    };
    let length = [reach(nominal.corner, one, other), reach(nominal.corner, other, one)];
    let angle = Degrees::of(sine.atan2(cosine));
    let shape = match OUTSIDE.holds(inputs) {
        true => Shape::OuterCorner { angle, length, height },
        false => Shape::InnerCorner { angle, length, depth: height },
    };
    let [x, y] = nominal.corner;
    place::solid(control, shape, [x, y, 0.0], [one[0], one[1], 0.0], place::outward(control))
}
