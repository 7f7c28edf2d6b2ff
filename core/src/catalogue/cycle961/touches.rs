//! Where CYCLE961 touches: the places before the edges, and which way the probe goes there.
//!
//! Places are abscissa and ordinate of the WCS, mm; axes count 0 abscissa, 1 ordinate.

use super::lines::{Point, across, along, away, direction, unit};
use super::params::{OUTSIDE, PLACES, POINTS, RECTANGLE};
use crate::catalogue::prelude::*;
use crate::geometry::Dir;

/// How exactly the angles are known: the way leads so much away from the edges, degree (B:7996).
pub const TOLERANCE: f64 = 10.0;
/// Half of the shortest measuring path, mm (B:8154).
const SHORTEST: f64 = 20.0;
/// Two directions are equally good for measuring along an axis.
const EQUAL: f64 = 1e-9;

/// One touch along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Where the probe stands before.
    pub at: Point,
    /// Measuring axis.
    pub axis: usize,
    /// Direction of the probe, +1 or -1.
    pub direction: f64,
    /// Half of the whole measuring path, mm.
    pub path: f64,
}

impl Touch {
    /// The direction as a vector.
    pub fn towards(&self) -> Point {
        let mut vector = [0.0; 2];
        vector[self.axis] = self.direction;
        vector
    }
}

/// P1 to P4, of a rectangle P1 to P3, when the cycle is called here.
pub fn touches(inputs: &Inputs, control: &Control, start: Point) -> Vec<Touch> {
    let mut all = if POINTS.holds(inputs) { by_points(inputs) } else { by_distances(inputs, control, start) };
    if RECTANGLE.holds(inputs) {
        all.truncate(3);
    }
    all
}

/// Directions of both edges in the WCS, the reference edge first, degree from the abscissa. That of the reference edge
/// counts in the machine (B:7992); the angle between both is one of the part, so it counts in its plane, which may
/// lean, and turns against it where angles of the WCS turn against those of the machine.
pub fn edges(inputs: &Inputs, control: &Control) -> [f64; 2] {
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let mut direction = [0.0; 3];
    [direction[abscissa], direction[ordinate]] = unit(inputs.degrees(names::STA1).0);
    let seen = control.direction_to_workpiece(Dir::new(direction));
    let first = seen[ordinate].atan2(seen[abscissa]).to_degrees();
    let sense = control.turn_axis(abscissa, ordinate)[applicate].signum();
    [first, first + sense * inputs.degrees(names::INCA).0]
}

/// In the directions of the edges, turned away from them, at the distances and at half of them (B:7984-7998).
fn by_distances(inputs: &Inputs, control: &Control, start: Point) -> Vec<Touch> {
    let outside = if OUTSIDE.holds(inputs) { 1.0 } else { -1.0 };
    let angles = edges(inputs, control);
    // outside the material lies between the edges
    let apart = outside * across(unit(angles[0]), unit(angles[1])).signum();
    let sides = [(angles[0], names::SETV0, -apart), (angles[1], names::SETV1, apart)];
    let touches = sides.map(|(edge, name, away)| {
        let distance = inputs.number(name);
        let way = unit(edge + TOLERANCE * away);
        let (axis, direction) = paraxial(unit(edge - 90.0 * away));
        let inner = distance * (2.0 * TOLERANCE).to_radians().tan();
        let path = inputs.number(names::FA).max(SHORTEST).max(inner);
        [0.5, 1.0].map(|part| Touch { at: along(start, way, distance * part), axis, direction, path })
    });
    touches.concat()
}

/// From the places, across the line of a pair: outside towards the other pair, inside away from it (B:8046-8050).
fn by_points(inputs: &Inputs) -> Vec<Touch> {
    let [p1, p2, p3, p4] = PLACES.map(|place| place.map(|name| inputs.number(name)));
    let path = inputs.number(names::FA).max(SHORTEST);
    let outside = if OUTSIDE.holds(inputs) { 1.0 } else { -1.0 };
    let pair = |one: Point, two: Point, other: Point| {
        let line = direction(one, two);
        let side = across(line, away(one, other)).signum() * outside;
        let (axis, direction) = paraxial([-line[1] * side, line[0] * side]);
        [one, two].map(|at| Touch { at, axis, direction, path })
    };
    let middle = |a: Point, b: Point| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    [pair(p1, p2, middle(p3, p4)), pair(p3, p4, middle(p1, p2))].concat()
}

/// The axis that a direction is nearest to, the abscissa between both, and the sign along it.
fn paraxial(towards: Point) -> (usize, f64) {
    let axis = if towards[1].abs() > towards[0].abs() + EQUAL { 1 } else { 0 };
    (axis, towards[axis].signum())
}
