//! A nominal tool probe for CYCLE971, where the control believes it to be, and the tool before it.

use super::params::{APPLICATE, AUTOMATIC, INCREMENTAL, MEASURE, WORKPIECE};
use super::place::Place;
use crate::catalogue::prelude::*;

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
    let place = Place::of(inputs, &own);
    let low = place.sides.trigger(2, 1.0);
    let height = if low != 0.0 && place.top() > low { place.top() - low } else { HEIGHT };
    let cap = place.sides.cap(&own, DISCS.contains(&place.kind), place.top(), height);
    let start = place::in_plane(&own, start(inputs, &own, &place));
    Proposal {
        tool_probes: cap.into_iter().collect(),
        start: control.to_workpiece(own.to_machine(Wcs(start))),
        ..Proposal::default()
    }
}

/// Abscissa, ordinate, applicate: above the probe, on the plus side in what is measured or where the tool is offset; an
/// incremental calibration begins in front of the side that it touches, or above the upper one.
fn start(inputs: &Inputs, control: &Control, place: &Place) -> [f64; 3] {
    let path = inputs.number(names::FA);
    let [abscissa, ordinate] = place.middle();
    let mut start = [abscissa, ordinate, place.top() + path.abs() + AWAY];
    if AUTOMATIC.holds(inputs) {
        return start;
    }
    let radius = control.active_radius();
    let number = inputs.integer(names::MA);
    let axis = (number % 10).clamp(1, 3) as usize - 1;
    if INCREMENTAL.holds(inputs) {
        let direction = path.signum();
        if axis == 2 {
            start[2] = place.top() + path.abs();
        } else {
            start[axis] = place.sides.trigger(axis, direction) - path - direction * radius;
            start[2] = place.low();
        }
        return start;
    }
    let mut beside = |axis: usize| start[axis] = place.sides.trigger(axis, -1.0) + radius + path + AWAY;
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
