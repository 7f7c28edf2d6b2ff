//! A nominal part for CYCLE979 about its set centre, its upper face at applicate 0.

use super::params::{OUTSIDE, ROUND};
use crate::catalogue::prelude::*;

/// Measuring depth of the ball centre below the face where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;
/// How much further from an outer element than the first block the probe starts, mm.
const AWAY: f64 = 5.0;

/// Part and start: at measuring height, in the middle of an inner element, beside P1 of an outer one (B:6898-6905). A
/// web is crossed clear of its face by a third of what the ball leaves of `_ID`, at most 10 mm.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let (ball, side) = (place::ball_radius(inputs, control), place::side(control));
    let [size, x, y] = [names::SETVAL, names::CPA, names::CPO].map(|name| inputs.number(name));
    let (sine, cosine) = inputs.degrees(names::STA1).sin_cos();
    let depth = inputs.given(names::ID).map_or(DEPTH, |lift| place::above(lift * side, ball).1);
    let out = if OUTSIDE.holds(inputs) { size / 2.0 + ball + inputs.number(names::FA) + AWAY } else { 0.0 };
    let start = place::in_plane(control, [x + out * cosine, y + out * sine, -depth * side]);
    let shape = place::element(inputs.variant % 10, [size; 2], depth + 2.0 * ball + 10.0);
    let across = if ROUND.holds(inputs) { [1.0, 0.0, 0.0] } else { [cosine, sine, 0.0] };
    let part = place::solid(control, shape, [x, y, 0.0], across, place::outward(control));
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, start) }
}
