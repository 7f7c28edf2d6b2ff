//! Turning tools and the calibration tool, which is one (B:8816-9120, B:9441, B:9738).

use super::params::{AUTOMATIC, CALIBRATE, INCREMENTAL};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::correct::Measured;
use crate::catalogue::tool_probe::store::Trigger;
use crate::catalogue::tool_probe::{Stand, turning};
use crate::control::tools::side;

/// The nose of the tool in use: from its centre to its tip, in nose radii; 61314 where it is no turning tool, 61315 for
/// a position that the task does not allow (A:15855-15856).
pub fn nose(machine: &mut dyn Machine, inputs: &Inputs) -> Result<[f64; 2], Stop> {
    let edge = machine.control().active_edge();
    let (is_turning, tip) = edge.map_or((false, 0), |edge| (edge.is_turning(), edge.tip));
    match (is_turning, turning::allowed(tip, CALIBRATE.holds(inputs))) {
        (false, _) => Err(alarm(machine, 61314)),
        (true, false) => Err(alarm(machine, 61315)),
        (true, true) => Ok(side(tip, inputs.recodes())),
    }
}

/// One side of the probe: the ball over its middle, then along the measuring axis; in plus direction the back of the
/// ball touches, twice the radius behind its tip (B:8870, B:9441).
pub fn calibrate(machine: &mut dyn Machine, stand: &Stand) -> Result<Trigger, Stop> {
    let nose = nose(machine, stand.inputs)?;
    let axis = axis(machine, stand.inputs, 1..=2)?;
    let (direction, touched) = if INCREMENTAL.holds(stand.inputs) {
        from_here(machine, stand, nose, axis)?
    } else {
        let direction = stand.approach(machine, axis)?;
        before(machine, stand, nose, 1 - axis)?;
        let behind = (direction - nose[axis]) * stand.block.radius;
        let set = stand.probe.trigger(axis, direction) - behind;
        (direction, stand.touch(machine, axis, direction, set)? + behind)
    };
    Ok(stand.probe.found(axis, direction, touched))
}

/// The lengths that the task names.
pub fn measure(machine: &mut dyn Machine, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    let nose = nose(machine, stand.inputs)?;
    if AUTOMATIC.holds(stand.inputs) {
        return automatic(machine, stand, nose);
    }
    let axis = axis(machine, stand.inputs, 1..=2)?;
    if INCREMENTAL.holds(stand.inputs) {
        let (direction, touched) = from_here(machine, stand, nose, axis)?;
        return Ok(vec![stand.length(machine, axis, direction, touched)]);
    }
    Ok(vec![one(machine, stand, nose, axis)?])
}

/// Touches from where the tool stands: the direction, and where its tip would have touched, mm.
fn from_here(machine: &mut dyn Machine, stand: &Stand, nose: [f64; 2], axis: usize) -> Result<(f64, f64), Stop> {
    let direction = direction(machine, stand.inputs)?;
    let latched = stand.touch_from_here(machine, axis, direction)?;
    Ok((direction, latched + (direction - nose[axis]) * stand.block.radius))
}

/// The nose before the middle of the probe in an axis; a tool without radius with its tip (B:9061).
fn before(machine: &mut dyn Machine, stand: &Stand, nose: [f64; 2], axis: usize) -> Result<(), Stop> {
    stand.go(machine, axis, stand.probe.middle(axis) + nose[axis] * stand.block.radius)
}

/// Length in an axis, touched with the tip: 61325 where the tool has none there, 61332 where it stands on the other
/// side.
fn one(machine: &mut dyn Machine, stand: &Stand, nose: [f64; 2], axis: usize) -> Result<Measured, Stop> {
    let direction = nose[axis];
    if direction == 0.0 {
        return Err(alarm(machine, 61325));
    }
    if stand.approach(machine, axis)? != direction {
        return Err(alarm(machine, 61332));
    }
    before(machine, stand, nose, 1 - axis)?;
    let latched = stand.touch(machine, axis, direction, stand.probe.trigger(axis, direction))?;
    Ok(stand.length(machine, axis, direction, latched))
}

/// All lengths that the tool has, that of the abscissa first; around the corner of the probe at the measuring path, and
/// back to the start (B:9702, B:9738-9746).
fn automatic(machine: &mut dyn Machine, stand: &Stand, nose: [f64; 2]) -> Result<Vec<Measured>, Stop> {
    let mut lengths = Vec::new();
    for axis in [0, 1].into_iter().filter(|axis| nose[*axis] != 0.0) {
        if !lengths.is_empty() {
            let out = stand.probe.trigger(axis, nose[axis]) - nose[axis] * stand.block.path;
            stand.go(machine, axis, out)?;
        }
        lengths.push(one(machine, stand, nose, axis)?);
    }
    stand.back_to_start(machine)?;
    Ok(lengths)
}
