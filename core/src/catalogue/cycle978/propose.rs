//! A nominal part for CYCLE978: a block whose face stands at the set position.

use crate::catalogue::place;
use crate::control::Control;
use crate::entry::{Inputs, Proposal, names};

/// Part and start: opposite the surface, further away than `_FA` (B:6376-6384); from the minus side in the plane,
/// from above along the applicate.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let set = inputs.number(names::SETVAL);
    let axis = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let away = inputs.number(names::FA) + place::ball_radius(inputs, control) + 5.0;
    let side = if axis == 2 { place::side(control) } else { -1.0 };
    let (part, start) = place::face(control, axis, set, side, away);
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, start) }
}
