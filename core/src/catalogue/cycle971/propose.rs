//! A nominal tool probe for CYCLE971, where the control believes it to be, and the tool before it.

use super::params::{APPLICATE, AUTOMATIC, INCREMENTAL, MEASURE, WORKPIECE};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{ProbeData, TYPE};

/// How far above and beside the probe the tool starts, mm.
const AWAY: f64 = 20.0;
/// Height of a probe whose lower side nobody knows, mm.
const HEIGHT: f64 = 15.0;
/// Types of discs in `_TP[k,8]` (B:13366).
const DISCS: [i64; 3] = [101, 201, 301];

/// Probe and start.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let mut own = control.clone();
    if !WORKPIECE.holds(inputs) {
        own.take_frames();
    }
    let probe = ProbeData::of(inputs, &own);
    let low = probe.trigger(2, 1.0);
    let height = if low != 0.0 && probe.top() > low { probe.top() - low } else { HEIGHT };
    let cap = probe.cap(&own, DISCS.contains(&(probe.value(TYPE) as i64)), probe.top(), height);
    let start = place::in_plane(&own, start(inputs, &own, &probe));
    Proposal {
        tool_probes: cap.into_iter().collect(),
        start: control.to_workpiece(own.to_machine(Wcs(start))),
        ..Proposal::default()
    }
}

/// Abscissa, ordinate, applicate: above the probe, on the plus side in what is measured or where the tool is offset; an
/// incremental calibration begins in front of the side that it touches, or above the upper one.
fn start(inputs: &Inputs, control: &Control, probe: &ProbeData) -> [f64; 3] {
    let path = inputs.number(names::FA);
    let [abscissa, ordinate] = probe.centre();
    let mut start = [abscissa, ordinate, probe.top() + path.abs() + AWAY];
    if AUTOMATIC.holds(inputs) {
        return start;
    }
    let radius = control.active_radius();
    let number = inputs.integer(names::MA);
    let axis = (number % 10).clamp(1, 3) as usize - 1;
    if INCREMENTAL.holds(inputs) {
        let direction = path.signum();
        if axis == 2 {
            start[2] = probe.top() + path.abs();
        } else {
            start[axis] = probe.trigger(axis, direction) - path - direction * radius;
            start[2] = probe.low();
        }
        return start;
    }
    let mut beside = |axis: usize| start[axis] = probe.trigger(axis, -1.0) + radius + path + AWAY;
    if APPLICATE.holds(inputs) {
        beside(usize::from(number / 100 == 2));
        return start;
    }
    beside(axis);
    if !MEASURE.holds(inputs) && number > 100 {
        beside(usize::from(axis == 0));
    }
    start
}
