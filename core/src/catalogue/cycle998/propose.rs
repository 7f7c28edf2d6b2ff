//! A nominal part for CYCLE998: a block with a face at the set angles.

use super::angles::Surface;
use super::params::AT_ANGLE;
use crate::catalogue::prelude::*;
use crate::geometry::V3;
use crate::workpiece::Shape;

/// Face beyond the points, mm.
const BEYOND: f64 = 25.0;
/// Thickness behind the face, mm.
const THICKNESS: f64 = 40.0;
/// Width of the face across a single way, mm.
const WIDTH: f64 = 60.0;
/// How far below the upper edge a side face is touched, mm.
const DEPTH: f64 = 10.0;
/// How much further than `_FA` the probe starts from the face, mm.
const AWAY: f64 = 5.0;

/// Part and start: opposite the first point, further away than `_FA` (B:7530-7540); with paraxial positioning so that
/// both points lie in the middle of the measuring path (B:7550-7556).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let Some(surface) = Surface::of(inputs) else { return Proposal::default() };
    let axis = surface.measuring;
    let side = place::side(control);
    let towards = towards(inputs, axis, side);
    let (mut at, mut from) = (V3::zeros(), [0.0; 3]);
    (at[axis], from[axis]) = heights(inputs, control, &surface, towards);
    let outward = surface.normal(&[0.0; 2]).normalize() * -towards;
    let middle = at + to_middle(&surface, &outward, side);
    let shape = Shape::Block { size: size(&surface, &outward) };
    let along = surface.along(0.0).normalize();
    let part = place::solid(control, shape, middle.into(), along.into(), outward.into());
    place::proposal(part, place::in_plane(control, from))
}

/// Direction of the probe: as `_MD` says, else along the applicate from its side, and in the plane from the minus side,
/// unless the call measures in the minus direction (CamHelper cd6e996: `CYCLE998(100105,…,103,2,…)`).
fn towards(inputs: &Inputs, axis: usize, side: f64) -> f64 {
    let minus = match axis {
        _ if !AT_ANGLE.holds(inputs) => inputs.integer(names::MD) == 1,
        2 => side > 0.0,
        _ => inputs.minus,
    };
    if minus { -1.0 } else { 1.0 }
}

/// Measuring axis at the first point of the face, and at the start.
fn heights(inputs: &Inputs, control: &Control, surface: &Surface, towards: f64) -> (f64, f64) {
    let (ball, path) = (place::ball_radius(inputs, control), inputs.number(names::FA));
    if AT_ANGLE.holds(inputs) {
        let set = inputs.number(names::SETVAL);
        return (set, set - towards * (path + ball + AWAY));
    }
    let rises = surface.legs.iter().map(|leg| leg.rise(leg.set) * towards);
    let (low, high) = rises.fold((0.0_f64, 0.0_f64), |(low, high), rise| (low.min(rise), high.max(rise)));
    (towards * (ball + path - (low + high) / 2.0), 0.0)
}

/// From the first point to the middle of the face.
fn to_middle(surface: &Surface, outward: &V3, side: f64) -> V3 {
    let mut way = V3::zeros();
    for leg in &surface.legs {
        way[leg.axis] += leg.distance / 2.0;
    }
    // along the measuring axis back into the face
    way[surface.measuring] = -way.dot(outward) / outward[surface.measuring];
    if surface.legs.len() == 1 && surface.third() == 2 {
        way[2] += side * (DEPTH - WIDTH / 2.0);
    }
    way
}

/// Lengths of the face along its first way and across, and the thickness.
fn size(surface: &Surface, outward: &V3) -> [f64; 3] {
    let length = |index: usize| {
        let leg = surface.legs.get(index)?;
        Some(leg.distance.hypot(leg.rise(leg.set)) + 2.0 * BEYOND)
    };
    let slant = 1.0 / outward[surface.measuring].abs();
    [length(0).unwrap_or(WIDTH), length(1).map_or(WIDTH, |length| length * slant), THICKNESS]
}
