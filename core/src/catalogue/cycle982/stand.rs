//! Where tool and tool probe of a turning machine stand to each other: ways and touches in the plane.

use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::evaluate::tool_offset::RADIUS;

impl Stand<'_> {
    /// Back to where the cycle began, abscissa before ordinate (B:9758).
    pub fn back_to_start(&self, machine: &mut dyn Machine) -> Result<(), Stop> {
        self.go(machine, 0, self.start[0])?;
        self.go(machine, 1, self.start[1])
    }

    /// Touches where the position of the tool should be `set`; its position at switching, mm.
    pub fn touch(&self, machine: &mut dyn Machine, axis: usize, direction: f64, set: f64) -> Result<f64, Stop> {
        self.block.latch(machine, &self.block.point(axis, direction, set))
    }

    /// Touches from where the tool stands, over twice the measuring path (B:9820).
    pub fn touch_from_here(&self, machine: &mut dyn Machine, axis: usize, direction: f64) -> Result<f64, Stop> {
        self.block.latch_from_here(machine, &self.block.point(axis, direction, 0.0))
    }

    /// The length in an axis that would put the tool's own point on the touched side, mm: what is known so far and by
    /// how much the position differs from it.
    pub fn apparent(&self, control: &Control, axis: usize, direction: f64, latched: f64) -> f64 {
        active(control, part(axis)) + latched - self.probe.trigger(axis, direction)
    }

    /// Length in an axis as measured.
    pub fn length(&self, machine: &mut dyn Machine, axis: usize, direction: f64, latched: f64) -> Measured {
        found(part(axis), self.apparent(machine.control(), axis, direction, latched))
    }
}

/// Which length counts in an axis: L2 in the abscissa, L1 in the ordinate (B:9192).
pub fn part(axis: usize) -> usize {
    1 - axis.min(1)
}

/// A length or the radius with its field in `_OVR[]` (B:9306-9311).
pub fn found(part: usize, value: f64) -> Measured {
    let result = match part {
        RADIUS => 12,
        length => 8 + 2 * length,
    };
    Measured { part, result, value }
}
