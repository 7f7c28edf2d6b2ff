//! A nominal surface or reference groove for CYCLE973.

use super::groove::Groove;
use super::params::GROOVE;
use crate::catalogue::lathe::{measure, place};
use crate::catalogue::place as plane;
use crate::catalogue::prelude::*;
use crate::geometry::Mcs;

/// How much further from the surface than the first block the probe starts, mm.
const AWAY: f64 = 5.0;
/// Depth of a groove whose data do not tell it, mm.
const DEPTH: f64 = 20.0;
/// Axis across both grooves of a pair, mm.
const LENGTH: f64 = 40.0;

/// Part and start.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let away = plane::ball_radius(inputs, control) + inputs.number(names::FA) + AWAY;
    if GROOVE.holds(inputs) {
        groove(inputs, control, away).unwrap_or_default()
    } else {
        surface(inputs, control, away)
    }
}

/// Opposite a surface that is touched against `_MD` (B:10331-10405).
fn surface(inputs: &Inputs, control: &Control, away: f64) -> Proposal {
    let index = (inputs.integer(names::MA).clamp(1, 3) - 1) as usize;
    let set = inputs.number(names::SETVAL) / measure::per(control, inputs);
    let side = if inputs.integer(names::MD) == 0 { -1.0 } else { 1.0 };
    let (part, start) = place::touched(control, control.plane.axes()[index], set, side, away);
    place::proposal(part, start)
}

/// Above the groove of the probe in use, nominally where `_KB` says that it is: its errors are those of the data. None
/// where there is none.
fn groove(inputs: &Inputs, control: &Control, away: f64) -> Option<Proposal> {
    let groove = Groove::of(control.active_edge()?.tip)?;
    let found = groove.place(control, inputs.integer(names::CALNUM) - 1);
    if found.width() <= 0.0 {
        return None;
    }
    let depth = if found.depth > 0.0 { found.depth } else { DEPTH };
    let mut machine = control.clone();
    machine.take_frames();
    let axes = control.plane.axes();
    let [walls, base] = found.axes.map(|axis| axes[axis]);
    let mut at = [0.0; 3];
    (at[walls], at[base]) = (found.centre(), found.base + depth);
    let mut start = at;
    start[base] += away;
    let shape = Shape::Groove { width: found.width(), depth, length: LENGTH };
    let groove = place::standing(&machine, shape, at, plane::unit(walls), plane::unit(base));
    Some(plane::proposal(groove, control.to_workpiece(Mcs(start)).0))
}
