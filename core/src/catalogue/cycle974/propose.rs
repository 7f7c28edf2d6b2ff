//! A nominal part for CYCLE974: a turned part about the zero point, whose end face or outside is measured.

use crate::catalogue::lathe::{measure, place};
use crate::catalogue::place as plane;
use crate::control::Control;
use crate::entry::{Inputs, Proposal, names};

/// How much further from the surface than the first block the probe starts, mm.
const AWAY: f64 = 5.0;

/// Part and start: opposite the point, outside of the part, on the side of the setpoint (B:10513-10523).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let index = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let axis = control.plane.axes()[index];
    let set = inputs.number(names::SETVAL) / measure::per(control, inputs);
    let away = plane::ball_radius(inputs, control) + inputs.number(names::FA) + AWAY;
    let side = if axis != 2 && set < 0.0 { -1.0 } else { 1.0 };
    let (part, start) = place::touched(control, axis, set, side, away);
    Proposal { tools: place::corrected_tools(inputs), ..place::proposal(part, start) }
}
