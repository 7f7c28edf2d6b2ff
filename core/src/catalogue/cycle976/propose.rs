//! What CYCLE976 calibrates against: a ring about the origin of the WCS, or a block whose face stands at the set
//! position.

use super::params::{HOLE, LENGTH};
use crate::catalogue::calibration;
use crate::catalogue::prelude::*;

/// How deep in the ring the ball centre stands, mm.
const DEPTH: f64 = 10.0;

/// Part and start: in the middle of the hole (B:5196, B:5311), or opposite the surface, further away than `_FA`
/// (B:5447); for the length in the middle of the way that the cycle searches (B:5589).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = calibration::ball_radius(inputs, control);
    let (part, start) = if HOLE.holds(inputs) {
        let ring = Shape::Hole { diameter: inputs.number(names::SETVAL), depth: DEPTH + 2.0 * ball + 10.0 };
        let out = place::outward(control);
        let part = place::solid(control, ring, [0.0; 3], [1.0, 0.0, 0.0], out);
        (part, place::in_plane(control, out.map(|part| -DEPTH * part)))
    } else {
        let axis = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
        let side = if inputs.integer(names::MD) == 1 { 1.0 } else { -1.0 };
        let beyond = if LENGTH.holds(inputs) { 0.0 } else { 5.0 };
        place::face(control, axis, inputs.number(names::SETVAL), side, inputs.number(names::FA) + ball + beyond)
    };
    place::proposal(part, start)
}
