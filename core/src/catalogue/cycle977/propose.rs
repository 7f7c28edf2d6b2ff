//! A nominal part for CYCLE977 about the origin of the WCS, its upper face at applicate 0.

use super::params::{OUTSIDE, RECTANGLE, ZONE};
use super::protection::Protected;
use crate::catalogue::prelude::*;
use crate::workpiece::Shape;

/// Measuring depth of the ball centre where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;

/// Part and start: set centre; at measuring height inside without a zone, above otherwise (B:5904-5941).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = place::ball_radius(inputs, control);
    let (start, depth) = if OUTSIDE.holds(inputs) || ZONE.holds(inputs) {
        place::above(inputs.number(names::ID).abs(), ball)
    } else {
        (-DEPTH, DEPTH)
    };
    let height = depth + 2.0 * ball + 10.0;
    let x = if inputs.number(names::MA) as i64 == 2 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
    let out = place::outward(control);
    let part = place::solid(control, shape(inputs, height), [0.0; 3], x, out);
    let protected = Protected::of(inputs, height, x);
    Proposal {
        fixture: protected.iter().flat_map(|zone| zone.obstacles(control)).collect(),
        zones: protected.iter().map(|zone| zone.walls(control)).collect(),
        tools: place::corrected_tools(inputs),
        ..place::proposal(part, place::in_plane(control, out.map(|part| part * start)))
    }
}

fn shape(inputs: &Inputs, height: f64) -> Shape {
    let length = [inputs.number(names::SETV0), inputs.number(names::SETV1)];
    match (inputs.variant % 10, RECTANGLE.holds(inputs)) {
        (kind, false) => place::element(kind, inputs.number(names::SETVAL), height),
        (5, true) => Shape::Pocket { length, depth: height },
        _ => Shape::Island { length, height },
    }
}
