//! A drill that is as long as on a milling machine: L1 along the applicate (B:10096-10126). The trigger values are
//! those of G18, as for turning tools.

use super::params::{AUTOMATIC, INCREMENTAL, REVERSAL, WITH_RADIUS, WORKPIECE};
use super::stand::found;
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::catalogue::tool_probe::ProbeData;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::control::Plane;
use crate::entry::Inputs;
use crate::geometry::TOLERANCE;
use crate::machine::{Machine, Stop};

/// Axis of the plane in which is measured.
const APPLICATE: usize = 2;

/// Measures L1; 61314 where the length lies along Y, or more is asked for (no number is named).
pub fn measure(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<Vec<Measured>, Stop> {
    let more = [AUTOMATIC, REVERSAL, WITH_RADIUS];
    // Z is the abscissa of G18, X its ordinate
    let lies = match inputs.plane {
        Plane::G17 => 0,
        Plane::G19 => 1,
        Plane::G18 => return Err(alarm(machine, 61314)),
    };
    if more.iter().any(|when| when.holds(inputs)) {
        return Err(alarm(machine, 61314));
    }
    let data = ProbeData::of(inputs, machine.control(), WORKPIECE.holds(inputs));
    let [triggers, beside] = [data.triggers(lies), data.triggers(1 - lies)];
    let start = machine.position()[block.axes[APPLICATE]];
    let direction = if INCREMENTAL.holds(inputs) {
        super::nose::told(machine, inputs)?
    } else {
        approach(machine, start, triggers)?
    };
    let trigger = triggers[usize::from(direction > 0.0)];
    let point = block.point(APPLICATE, direction, trigger);
    let latched = if INCREMENTAL.holds(inputs) {
        block.latch_from_here(machine, &point)?
    } else {
        let mut over = machine.position();
        over[Plane::G18.axes()[1 - lies]] = (beside[0] + beside[1]) / 2.0;
        block.travel(machine, over)?;
        block.latch(machine, &point)?
    };
    let actual = active(machine.control(), 0) + latched - trigger;
    Ok(vec![found(0, actual)])
}

/// Direction from the start towards the probe; 61332 where it lies beside neither side.
fn approach(machine: &mut dyn Machine, start: f64, [minus, plus]: [f64; 2]) -> Result<f64, Stop> {
    if start > minus + TOLERANCE {
        Ok(-1.0)
    } else if start < plus - TOLERANCE {
        Ok(1.0)
    } else {
        Err(alarm(machine, 61332))
    }
}
