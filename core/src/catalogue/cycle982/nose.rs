//! Turning tools and the calibration tool, which is one (B:8816-9120, B:9441, B:9738).

use super::params::{AUTOMATIC, CALIBRATE, INCREMENTAL};
use super::stand::{Stand, found, part};
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::tool_probe::correct::Measured;
use crate::catalogue::tool_probe::store::Trigger;
use crate::control::tools::side;
use crate::entry::{Inputs, names};
use crate::machine::{Machine, Stop};

/// Cutting edge position of the calibration tool (B:8839).
const CALIBRATION: i64 = 3;
/// Cutting edge positions that can be measured (B:9128).
const MEASURED: std::ops::RangeInclusive<i64> = 1..=8;

/// The nose of the tool in use: from its centre to its tip, in nose radii; 61314 where it is no turning tool, 61315 for
/// a position that the task does not allow (A:15855-15856).
pub fn nose(machine: &mut dyn Machine, inputs: &Inputs) -> Result<[f64; 2], Stop> {
    let control = machine.control();
    let edge = control.active_edge();
    let (turning, tip) = edge.map_or((false, 0), |edge| (edge.is_turning(), edge.tip));
    let sides = side(tip, inputs.recodes());
    let allowed = match CALIBRATE.holds(inputs) {
        true => tip == CALIBRATION,
        false => MEASURED.contains(&tip),
    };
    match (turning, allowed) {
        (false, _) => Err(alarm(machine, 61314)),
        (true, false) => Err(alarm(machine, 61315)),
        (true, true) => Ok(sides),
    }
}

/// Measuring axis; 61325 where it is none of the plane (A:15866).
pub fn axis(machine: &mut dyn Machine, inputs: &Inputs) -> Result<usize, Stop> {
    match inputs.integer(names::MA) {
        axis @ 1..=2 => Ok(axis as usize - 1),
        _ => Err(alarm(machine, 61325)),
    }
}

/// Direction of `_MD`; 61326 where it is none.
pub fn told(machine: &mut dyn Machine, inputs: &Inputs) -> Result<f64, Stop> {
    match inputs.integer(names::MD) {
        0 => Ok(1.0),
        1 => Ok(-1.0),
        _ => Err(alarm(machine, 61326)),
    }
}

/// One side of the probe: the ball over its middle, then along the measuring axis; in plus direction the back of the
/// ball touches, twice the radius behind its tip (B:8870, B:9441).
pub fn calibrate(machine: &mut dyn Machine, inputs: &Inputs, stand: &Stand) -> Result<Trigger, Stop> {
    let sides = nose(machine, inputs)?;
    let axis = axis(machine, inputs)?;
    let incremental = INCREMENTAL.holds(inputs);
    let direction = match incremental {
        true => told(machine, inputs)?,
        false => stand.approach(machine, axis)?,
    };
    let behind = (direction - sides[axis]) * stand.radius;
    let latched = if incremental {
        stand.touch_from_here(machine, axis, direction)?
    } else {
        before(machine, stand, sides, 1 - axis)?;
        let set = stand.trigger(axis, direction) - behind;
        stand.touch(machine, axis, direction, set)?
    };
    Ok(stand.found(axis, direction, latched + behind))
}

/// The lengths that the task names.
pub fn measure(machine: &mut dyn Machine, inputs: &Inputs, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    let sides = nose(machine, inputs)?;
    if AUTOMATIC.holds(inputs) {
        return automatic(machine, stand, sides);
    }
    let axis = axis(machine, inputs)?;
    if INCREMENTAL.holds(inputs) {
        let direction = told(machine, inputs)?;
        let latched = stand.touch_from_here(machine, axis, direction)?;
        let behind = (direction - sides[axis]) * stand.radius;
        return Ok(vec![length(machine, stand, axis, direction, latched + behind)]);
    }
    Ok(vec![one(machine, stand, sides, axis)?])
}

/// The nose before the middle of the probe in an axis; a tool without radius with its tip (B:9061).
fn before(machine: &mut dyn Machine, stand: &Stand, sides: [f64; 2], axis: usize) -> Result<(), Stop> {
    let to = stand.middle(axis) + sides[axis] * stand.radius;
    stand.go(machine, axis, to)
}

/// Length in an axis, touched with the tip: 61325 where the tool has none there, 61332 where it stands on the other
/// side.
fn one(machine: &mut dyn Machine, stand: &Stand, sides: [f64; 2], axis: usize) -> Result<Measured, Stop> {
    let direction = sides[axis];
    if direction == 0.0 {
        return Err(alarm(machine, 61325));
    }
    if stand.approach(machine, axis)? != direction {
        return Err(alarm(machine, 61332));
    }
    before(machine, stand, sides, 1 - axis)?;
    let set = stand.trigger(axis, direction);
    let latched = stand.touch(machine, axis, direction, set)?;
    Ok(length(machine, stand, axis, direction, latched))
}

/// All lengths that the tool has, that of the abscissa first; around the corner of the probe at the measuring path, and
/// back to the start (B:9702, B:9738-9746).
fn automatic(machine: &mut dyn Machine, stand: &Stand, sides: [f64; 2]) -> Result<Vec<Measured>, Stop> {
    let mut lengths = Vec::new();
    for axis in [0, 1] {
        let direction = sides[axis];
        if direction == 0.0 {
            continue;
        }
        if axis == 1 && !lengths.is_empty() {
            let out = stand.trigger(1, direction) - direction * stand.block.path;
            stand.go(machine, 1, out)?;
        }
        lengths.push(one(machine, stand, sides, axis)?);
    }
    stand.back_to_start(machine)?;
    Ok(lengths)
}

fn length(machine: &mut dyn Machine, stand: &Stand, axis: usize, direction: f64, latched: f64) -> Measured {
    let actual = stand.apparent(machine.control(), axis, direction, latched);
    found(part(axis), actual)
}
