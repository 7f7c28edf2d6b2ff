//! A nominal tool probe for CYCLE971, where the control believes it to be, and the tool before it.

use super::params::{APPLICATE, AUTOMATIC, INCREMENTAL, MEASURE, WORKPIECE};
use super::place::Place;
use crate::catalogue::place;
use crate::control::Control;
use crate::entry::{Inputs, Proposal, names};
use crate::geometry::Wcs;
use crate::workpiece::Shape;
use crate::workpiece::tool_probe::ToolProbe;

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
    let start = place::in_plane(&own, start(inputs, &own, &place));
    Proposal {
        tool_probes: cap(&own, &place).into_iter().collect(),
        start: control.to_workpiece(own.to_machine(Wcs(start))),
        ..Proposal::default()
    }
}

/// The cube or disc between the trigger points; none where they leave no room.
fn cap(control: &Control, place: &Place) -> Option<ToolProbe> {
    let size = |axis: usize| place.trigger(axis, -1.0) - place.trigger(axis, 1.0);
    let (x, y) = (size(0), size(1));
    let known = size(2) > 0.0 && place.trigger(2, 1.0) != 0.0;
    let height = if known { size(2) } else { HEIGHT };
    if x <= 0.0 || y <= 0.0 {
        return None;
    }
    let shape = if DISCS.contains(&place.kind) {
        Shape::Turned { diameter: x, length: height, bore: [0.0; 2] }
    } else {
        Shape::Block { size: [x, y, height] }
    };
    let [abscissa, ordinate] = place.middle();
    let at = [abscissa, ordinate, place.top()];
    let solid = place::solid(control, shape, at, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    Some(ToolProbe::ideal(solid))
}

/// Abscissa, ordinate, applicate: above the probe, on the plus side in what is measured or where the tool is offset.
fn start(inputs: &Inputs, control: &Control, place: &Place) -> [f64; 3] {
    let path = inputs.number(names::FA);
    let [abscissa, ordinate] = place.middle();
    let over = [abscissa, ordinate, place.top() + path.abs() + AWAY];
    if AUTOMATIC.holds(inputs) {
        return over;
    }
    let radius = control.active_radius();
    let number = inputs.integer(names::MA);
    let axis = (number % 10).clamp(1, 3) as usize - 1;
    if INCREMENTAL.holds(inputs) {
        return before(place, over, axis, path, radius);
    }
    let mut start = over;
    let mut beside = |axis: usize| start[axis] = place.trigger(axis, -1.0) + radius + path + AWAY;
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

/// In front of the side that an incremental calibration touches, or above the upper side.
fn before(place: &Place, over: [f64; 3], axis: usize, path: f64, radius: f64) -> [f64; 3] {
    let mut start = over;
    if axis == 2 {
        start[2] = place.top() + path.abs();
        return start;
    }
    let direction = path.signum();
    start[axis] = place.trigger(axis, direction) - path - direction * radius;
    start[2] = place.low();
    start
}
