//! Where tool and tool probe stand to each other: coordinates, ways and touches in the plane.
//!
//! Axes count 0 abscissa, 1 ordinate, directions are +1 and -1 along the axis.

use super::params::WORKPIECE;
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::catalogue::tool_probe::ProbeData;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::catalogue::tool_probe::store::Trigger;
use crate::control::Control;
use crate::entry::Inputs;
use crate::evaluate::tool_offset::RADIUS;
use crate::geometry::TOLERANCE;
use crate::machine::{Machine, Stop};

/// What a touch needs.
pub struct Stand {
    /// How is measured and travelled.
    pub block: Block,
    /// Names of the data of the probe by axis, of the trigger values touched in minus and in plus direction.
    data: [[String; 2]; 2],
    /// Trigger values by axis, touched in minus and in plus direction, mm.
    triggers: [[f64; 2]; 2],
    /// Where the cycle began, abscissa and ordinate, mm.
    pub start: [f64; 2],
    /// Radius of the tool in use, mm.
    pub radius: f64,
}

impl Stand {
    /// From the data of the probe and where the tool stands.
    pub fn of(machine: &mut dyn Machine, inputs: &Inputs, block: Block) -> Stand {
        let position = machine.position();
        let [abscissa, ordinate, _] = block.axes;
        let control = machine.control();
        let data = ProbeData::of(inputs, control, WORKPIECE.holds(inputs));
        Stand {
            data: [0, 1].map(|axis| [0, 1].map(|side| data.name(2 * axis + side))),
            triggers: [0, 1].map(|axis| data.triggers(axis)),
            start: [position[abscissa], position[ordinate]],
            radius: control.active_radius(),
            block,
        }
    }

    /// A trigger value that was found, with its datum and its field in `_OVR[]` (B:9287-9294).
    pub fn found(&self, axis: usize, direction: f64, value: f64) -> Trigger {
        let side = usize::from(direction > 0.0);
        Trigger { name: self.data[axis][side].clone(), result: 8 + 2 * (2 * axis + side), value }
    }

    /// Coordinate at which the probe switches, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.triggers[axis][usize::from(direction > 0.0)]
    }

    /// Middle of the probe, mm.
    pub fn middle(&self, axis: usize) -> f64 {
        let [minus, plus] = self.triggers[axis];
        (minus + plus) / 2.0
    }

    /// Direction from the start towards the probe; 61332 where the start lies beside neither side (A:15875, B:9642).
    pub fn approach(&self, machine: &mut dyn Machine, axis: usize) -> Result<f64, Stop> {
        let start = self.start[axis];
        if start > self.trigger(axis, -1.0) + TOLERANCE {
            Ok(-1.0)
        } else if start < self.trigger(axis, 1.0) - TOLERANCE {
            Ok(1.0)
        } else {
            Err(alarm(machine, 61332))
        }
    }

    /// Moves one axis.
    pub fn go(&self, machine: &mut dyn Machine, axis: usize, to: f64) -> Result<(), Stop> {
        let mut target = machine.position();
        target[self.block.axes[axis]] = to;
        self.block.travel(machine, target)
    }

    /// Back to where the cycle began, abscissa before ordinate (B:9758).
    pub fn back_to_start(&self, machine: &mut dyn Machine) -> Result<(), Stop> {
        self.go(machine, 0, self.start[0])?;
        self.go(machine, 1, self.start[1])
    }

    /// Touches where the position of the tool should be `set`; its position at switching, mm.
    pub fn touch(&self, machine: &mut dyn Machine, axis: usize, direction: f64, set: f64) -> Result<f64, Stop> {
        self.block.latch(machine, &self.block.point(axis, direction, set))
    }

    /// The same from where the tool stands, over twice the measuring path (B:9820).
    pub fn touch_from_here(&self, machine: &mut dyn Machine, axis: usize, direction: f64) -> Result<f64, Stop> {
        let point = self.block.point(axis, direction, 0.0);
        self.block.latch_from_here(machine, &point)
    }

    /// The length in an axis that would put the tool's own point on the touched side, mm: what is known so far and by
    /// how much the position differs from it.
    pub fn apparent(&self, control: &Control, axis: usize, direction: f64, latched: f64) -> f64 {
        active(control, part(axis)) + latched - self.trigger(axis, direction)
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
