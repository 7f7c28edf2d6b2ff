//! A drill that is as long as on a milling machine: L1 along the applicate (B:10096-10126). The trigger values are
//! those of G18, as for turning tools.

use super::params::{AUTOMATIC, INCREMENTAL, REVERSAL, WITH_RADIUS};
use super::stand::found;
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::catalogue::tool_probe::correct::{Measured, active};

/// Axis of the plane in which is measured.
const APPLICATE: usize = 2;
/// What such a drill cannot do: anything but one length without reversal (B:10112-10120).
pub const NOT_ONE_LENGTH: When = When::Any(&[AUTOMATIC, REVERSAL, WITH_RADIUS]);

/// Measures L1; 61314 where the length lies along Y, or more is asked for (no number is named).
pub fn measure(machine: &mut dyn Machine, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    // Z is the abscissa of G18, X its ordinate
    let lies = match stand.inputs.plane {
        Plane::G17 if !NOT_ONE_LENGTH.holds(stand.inputs) => 0,
        Plane::G19 if !NOT_ONE_LENGTH.holds(stand.inputs) => 1,
        _ => return Err(alarm(machine, 61314)),
    };
    let (latched, direction) = if INCREMENTAL.holds(stand.inputs) {
        let direction = direction(machine, stand.inputs)?;
        (stand.touch_from_here(machine, APPLICATE, direction)?, direction)
    } else {
        let towards = stand.probe.towards(lies, stand.start[APPLICATE]);
        let direction = towards.ok_or_else(|| alarm(machine, 61332))?;
        let mut over = machine.position();
        over[Plane::G18.axes()[1 - lies]] = stand.probe.middle(1 - lies);
        stand.block.travel(machine, over)?;
        (stand.touch(machine, APPLICATE, direction, stand.probe.trigger(lies, direction))?, direction)
    };
    let actual = active(machine.control(), 0) + latched - stand.probe.trigger(lies, direction);
    Ok(vec![found(0, actual)])
}
