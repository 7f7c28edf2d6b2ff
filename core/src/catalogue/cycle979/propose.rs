//! A nominal part for CYCLE979 about its set centre, its upper face at applicate 0.

use super::params::{OUTSIDE, ROUND};
use crate::catalogue::prelude::*;
use crate::geometry::Degrees;

/// Measuring depth of the ball centre below the face where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;
/// How much further from an outer element than the first block the probe starts, mm.
const AWAY: f64 = 5.0;

/// Part and start: at measuring height, in the middle of an inner element, beside P1 of an outer one (B:6898-6905).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = place::ball_radius(inputs, control);
    let size = inputs.number(names::SETVAL);
    let centre = [inputs.number(names::CPA), inputs.number(names::CPO)];
    let (sine, cosine) = Degrees(inputs.number(names::STA1)).sin_cos();
    let depth = depth(inputs, control, ball);
    let out = if OUTSIDE.holds(inputs) { size / 2.0 + ball + inputs.number(names::FA) + AWAY } else { 0.0 };
    let below = -depth * place::side(control);
    let start = [centre[0] + out * cosine, centre[1] + out * sine, below];
    let shape = place::element(inputs.variant % 10, size, depth + 2.0 * ball + 10.0);
    let x = if ROUND.holds(inputs) { [1.0, 0.0, 0.0] } else { [cosine, sine, 0.0] };
    let at = [centre[0], centre[1], 0.0];
    let part = place::solid(control, shape, at, x, place::outward(control));
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, place::in_plane(control, start)) }
}

/// Below the face; a web is crossed clear of it by a third of what the ball leaves of `_ID`, at most 10 mm.
fn depth(inputs: &Inputs, control: &Control, ball: f64) -> f64 {
    inputs.given(names::ID).map_or(DEPTH, |lift| place::above(lift * place::side(control), ball).1)
}
