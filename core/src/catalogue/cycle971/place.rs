//! Ways of the tool to the probe on a milling machine: above it, down beside it.

use super::params::MEASURE;
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{EDGE_LENGTH, Stand};

/// Whether a tool is measured over the middle of the probe however wide it is: a drill (B:4844-4846).
pub fn over_the_middle(inputs: &Inputs, tool: &Edge) -> bool {
    (200..300).contains(&tool.kind) && MEASURE.holds(inputs)
}

impl Stand<'_> {
    /// Side of the middle on which the tool stands at the call, +1 or -1.
    pub fn side(&self, axis: usize) -> f64 {
        if self.start[axis] >= self.probe.middle(axis) { 1.0 } else { -1.0 }
    }

    /// The measuring block towards a side of the probe: where the axis of the tool is when its radius touches.
    pub fn beside(&self, axis: usize, direction: f64) -> Point {
        self.block.point(axis, direction, self.probe.trigger(axis, direction) - direction * self.block.radius)
    }

    /// The measuring block towards the upper side.
    pub fn above(&self) -> Point {
        self.block.point(2, -1.0, self.probe.top())
    }

    /// Goes beside the probe and down: the other axis first, then the measuring axis, then the applicate (B:4573).
    pub fn enter(&self, machine: &mut dyn Machine, point: &Point, other: f64, low: f64) -> Result<(), Stop> {
        self.go(machine, 1 - point.axis, other)?;
        self.go(machine, point.axis, self.block.start(point))?;
        self.go(machine, 2, low)
    }

    /// Goes over this middle of the probe: a tool that is wider beside it in this axis, by its radius less `_ID`, to
    /// the side of the start (B:4593-4599).
    pub fn over(&self, machine: &mut dyn Machine, middle: [f64; 2], axis: usize) -> Result<(), Stop> {
        let middle_only = machine.control().active_edge().is_some_and(|tool| over_the_middle(self.inputs, tool));
        let mut over = middle;
        if 2.0 * self.block.radius > self.probe.value(EDGE_LENGTH) && !middle_only {
            over[axis] += self.side(axis) * (self.block.radius - self.inputs.number(names::ID));
        }
        let over = self.block.placed(machine.position().0, over);
        self.block.travel(machine, Wcs(over))
    }

    /// Touches the upper side there; the position of the tool's end, mm.
    pub fn touch_above(&self, machine: &mut dyn Machine, middle: [f64; 2], axis: usize) -> Result<f64, Stop> {
        self.over(machine, middle, axis)?;
        self.block.latch(machine, &self.above())
    }
}
