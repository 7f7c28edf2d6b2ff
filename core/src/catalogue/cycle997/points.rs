//! Where CYCLE997 touches a sphere, seen from above.

use super::params::{ANGLE, DIAMETER, FOUR_POINTS, ONE};
use crate::catalogue::circle;
use crate::catalogue::prelude::*;

/// Direction of the point for the diameter, which is approached in plus direction (B:8371).
pub const DIAMETER_SIDE: Degrees = Degrees(180.0);

/// Directions of the points from the centre in their order; missing angles count as in the drawing. Parallel to
/// the axes the manual does not say on which side P1 lies; here on the plus side, as with a shaft (B:8437-8445).
pub fn directions(inputs: &Inputs) -> Vec<Degrees> {
    if !ANGLE.holds(inputs) {
        return [0.0, 180.0, 90.0, 270.0].map(Degrees).to_vec();
    }
    let start = inputs.degrees(names::STA1).within_turn();
    let step = Degrees(inputs.given(names::INCA).unwrap_or(90.0)).within_turn();
    circle::points(start, step, FOUR_POINTS.holds(inputs))
}

/// All directions from which the ball comes, the one for the diameter included.
pub fn sides(inputs: &Inputs) -> Vec<Degrees> {
    let mut all = directions(inputs);
    if DIAMETER.holds(inputs) && ANGLE.holds(inputs) {
        all.push(DIAMETER_SIDE);
    }
    all
}

/// Names of the set centre of each sphere: abscissa, ordinate, applicate.
pub const CENTRES: [[Name; 3]; 3] = [
    [names::SETV0, names::SETV1, names::SETV2],
    [names::SETV3, names::SETV4, names::SETV5],
    [names::SETV6, names::SETV7, names::SETV8],
];

/// Set centres of the spheres that are measured, mm.
pub fn centres(inputs: &Inputs) -> Vec<[f64; 3]> {
    let measured = if ONE.holds(inputs) { 1 } else { 3 };
    CENTRES[..measured].iter().map(|names| names.map(|name| inputs.number(name))).collect()
}
