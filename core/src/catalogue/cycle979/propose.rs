//! A nominal part for CYCLE979 about its set centre, its upper face at applicate 0.

use super::params::{OUTSIDE, ROUND};
use crate::catalogue::place;
use crate::control::Control;
use crate::entry::{Inputs, Proposal, names};
use crate::geometry::Wcs;
use crate::geometry::rigid::sin_cos;
use crate::workpiece::Workpiece;

/// Measuring depth of the ball centre below the face where `_ID` does not decide it, mm.
const DEPTH: f64 = 10.0;
/// How much further from an outer element than the first block the probe starts, mm.
const AWAY: f64 = 5.0;

/// Part and start: at measuring height, in the middle of an inner element, beside P1 of an outer one (B:6898-6905).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let ball = place::ball_radius(inputs, control);
    let size = inputs.number(names::SETVAL);
    let centre = [inputs.number(names::CPA), inputs.number(names::CPO)];
    let (sine, cosine) = sin_cos(inputs.number(names::STA1));
    let depth = depth(inputs, control, ball);
    let out = match OUTSIDE.holds(inputs) {
        true => size / 2.0 + ball + inputs.number(names::FA) + AWAY,
        false => 0.0,
    };
    let below = -depth * place::side(control);
    let start = [centre[0] + out * cosine, centre[1] + out * sine, below];
    let shape = place::element(inputs.variant % 10, size, depth + 2.0 * ball + 10.0);
    let x = match ROUND.holds(inputs) {
        true => [1.0, 0.0, 0.0],
        false => [cosine, sine, 0.0],
    };
    let at = [centre[0], centre[1], 0.0];
    let part = place::solid(control, shape, at, x, place::outward(control));
    Proposal {
        workpiece: Workpiece { solids: vec![part] },
        start: Wcs(place::in_plane(control, start)),
        tools: place::corrected_tools(inputs),
        ..Proposal::default()
    }
}

/// Below the face: so deep that a web is crossed clear of it by a third of what the ball leaves of `_ID`, at most 10
/// mm.
fn depth(inputs: &Inputs, control: &Control, ball: f64) -> f64 {
    match inputs.given(names::ID) {
        Some(lift) => {
            let lift = lift * place::side(control);
            let clear = ((lift - ball) / 3.0).clamp(0.5, 10.0);
            (lift - ball - clear).max(0.0)
        }
        None => DEPTH,
    }
}
