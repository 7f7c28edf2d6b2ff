//! A tool before the tool probe: what a touch needs, and the ways there.

use super::ProbeData;
use crate::catalogue::prelude::*;

/// Tool and tool probe. Axes count 0 abscissa, 1 ordinate, 2 applicate; directions are +1 and -1.
#[derive(Clone)]
pub struct Stand<'a> {
    /// Values of the call.
    pub inputs: &'a Inputs,
    /// How is measured and travelled.
    pub block: &'a Block,
    /// Where the probe is.
    pub probe: ProbeData,
    /// Where the cycle began, by axis of the plane, mm.
    pub start: [f64; 3],
}

impl Stand<'_> {
    /// From the data of the probe and where the tool stands.
    pub fn of<'a>(machine: &mut dyn Machine, inputs: &'a Inputs, block: &'a Block) -> Stand<'a> {
        let position = machine.position();
        let start = block.axes.map(|axis| position[axis]);
        Stand { inputs, block, probe: ProbeData::of(inputs, machine.control()), start }
    }

    /// Direction from the start towards the probe; 61332 where the start lies beside neither side (A:15875, B:4589,
    /// B:9642).
    pub fn approach(&self, machine: &mut dyn Machine, axis: usize) -> Result<f64, Stop> {
        self.probe.towards(axis, self.start[axis]).ok_or_else(|| alarm(machine, 61332))
    }

    /// Moves one axis.
    pub fn go(&self, machine: &mut dyn Machine, axis: usize, to: f64) -> Result<(), Stop> {
        let mut target = machine.position();
        target[self.block.axes[axis]] = to;
        self.block.travel(machine, target)
    }
}
