//! Where tool and tool probe stand to each other: coordinates, ways and touches in the plane.
//!
//! Axes count 0 abscissa, 1 ordinate, directions are +1 and -1 along the axis.

use super::params::WORKPIECE;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::catalogue::tool_probe::{ProbeData, Sides};
use crate::evaluate::tool_offset::RADIUS;

/// What a touch needs.
pub struct Stand<'a> {
    /// Values of the call.
    pub inputs: &'a Inputs,
    /// How is measured and travelled.
    pub block: Block,
    /// Where the probe switches.
    pub sides: Sides,
    /// Where the cycle began, by axis of the plane, mm.
    pub start: [f64; 3],
    /// Radius of the tool in use, mm.
    pub radius: f64,
}

/// Where the probe of a call switches: its data count by the axes of the plane (B:13370-13384).
pub fn sides(inputs: &Inputs, control: &Control) -> Sides {
    ProbeData::of(inputs, control, WORKPIECE.holds(inputs)).sides([0, 1, 2])
}

impl Stand<'_> {
    /// From the data of the probe and where the tool stands.
    pub fn of<'a>(machine: &mut dyn Machine, inputs: &'a Inputs, block: Block) -> Stand<'a> {
        let position = machine.position();
        Stand {
            inputs,
            sides: sides(inputs, machine.control()),
            start: block.axes.map(|axis| position[axis]),
            radius: block.radius,
            block,
        }
    }

    /// Measuring axis; 61325 where it is none of the plane (A:15866).
    pub fn axis(&self, machine: &mut dyn Machine) -> Result<usize, Stop> {
        match self.inputs.integer(names::MA) {
            axis @ 1..=2 => Ok(axis as usize - 1),
            _ => Err(alarm(machine, 61325)),
        }
    }

    /// Direction of `_MD`; 61326 where it is none.
    pub fn told(&self, machine: &mut dyn Machine) -> Result<f64, Stop> {
        match self.inputs.integer(names::MD) {
            0 => Ok(1.0),
            1 => Ok(-1.0),
            _ => Err(alarm(machine, 61326)),
        }
    }

    /// Direction from the start towards the probe; 61332 where the start lies beside neither side (A:15875, B:9642).
    pub fn approach(&self, machine: &mut dyn Machine, axis: usize) -> Result<f64, Stop> {
        self.sides.towards(axis, self.start[axis]).ok_or_else(|| alarm(machine, 61332))
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

    /// Touches from where the tool stands, over twice the measuring path (B:9820).
    pub fn touch_from_here(&self, machine: &mut dyn Machine, axis: usize, direction: f64) -> Result<f64, Stop> {
        self.block.latch_from_here(machine, &self.block.point(axis, direction, 0.0))
    }

    /// The length in an axis that would put the tool's own point on the touched side, mm: what is known so far and by
    /// how much the position differs from it.
    pub fn apparent(&self, control: &Control, axis: usize, direction: f64, latched: f64) -> f64 {
        active(control, part(axis)) + latched - self.sides.trigger(axis, direction)
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
