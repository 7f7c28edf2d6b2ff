//! A nominal part for CYCLE974: a turned part about the zero point, whose end face or outside is measured.

use crate::catalogue::lathe::{measure, place};
use crate::catalogue::{Proposal, names, place as plane};
use crate::check::Inputs;
use crate::control::Control;
use crate::workpiece::Workpiece;

/// How much further from the surface than the first block the probe starts, mm.
const AWAY: f64 = 5.0;
/// How far the front face stands before the measured place, mm.
const BEHIND: f64 = 20.0;
/// Least diameter of the part, mm.
const LEAST: f64 = 20.0;

/// Part and start: opposite the point, outside of the part, on the side of the setpoint (B:10513-10523).
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let index = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let axis = control.plane.axes()[index];
    let set = inputs.number(names::SETVAL) / measure::per(control, inputs);
    let away = plane::ball_radius(inputs, control) + inputs.number(names::FA) + AWAY;
    let mut start = [0.0; 3];
    let part = if axis == 2 {
        start[0] = LEAST / 2.0;
        start[2] = set + away;
        place::part(control, set, [2.0 * LEAST, place::LENGTH], [0.0; 2])
    } else {
        start[axis] = set + if set < 0.0 { -away } else { away };
        let diameter = (2.0 * set.abs()).max(LEAST);
        place::part(control, BEHIND, [diameter, place::LENGTH], [0.0; 2])
    };
    Proposal {
        workpiece: Workpiece { solids: vec![part] },
        start,
        tools: place::corrected_tools(inputs),
        ..Proposal::default()
    }
}
