//! A nominal part for CYCLE977 about the origin of the WCS, its upper face at applicate 0.

use super::element::Element;
use super::protection::Protected;
use crate::catalogue::prelude::*;

/// Measuring depth of the ball centre where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;

/// Part and start: set centre; at measuring height inside without a zone, above otherwise (B:5904-5941).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = place::ball_radius(inputs, control);
    let element = Element::of(inputs);
    let (start, depth) = match element.inside && element.zone.is_none() {
        true => (-DEPTH, DEPTH),
        false => place::above(element.infeed.abs(), ball),
    };
    let height = depth + 2.0 * ball + 10.0;
    let out = place::outward(control);
    let shape = place::element(inputs.variant % 10, element.size, height);
    let part = place::solid(control, shape, [0.0; 3], place::unit(element.axes[0]), out);
    let protected = Protected::of(element, height);
    Proposal {
        fixture: protected.iter().flat_map(|zone| zone.obstacles(control)).collect(),
        zones: protected.iter().map(|zone| zone.walls(control)).collect(),
        tools: place::corrected_tools(inputs),
        ..place::proposal(part, place::in_plane(control, out.map(|part| part * start)))
    }
}
