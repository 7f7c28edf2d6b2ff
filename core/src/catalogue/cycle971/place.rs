//! Where the control believes the tool probe to be, and how the tool goes to it.
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate; directions are +1 and -1.

use super::params::{MEASURE, WORKPIECE};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::{Block, Point};
use crate::catalogue::tool_probe::{ProbeData, Sides};

/// Edge length or diameter of the upper side in `_TP[k,i]` (B:13363).
pub const EDGE_LENGTH: usize = 6;
/// Axes and directions of automatic calibration (B:13365).
pub const DIRECTIONS: usize = 7;
/// Type (B:13366).
pub const TYPE: usize = 8;
/// From the upper side to the tool's end at a measurement in the plane (B:13369).
pub const DEPTH: usize = 9;

/// The data of the probe by the axes of the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Trigger points; they are stored and told by geometry axis (B:4204-4215, B:13357-13362).
    pub sides: Sides,
    /// Edge length or diameter of the upper side, mm.
    width: f64,
    /// Depth of a measurement in the plane, mm.
    depth: f64,
    directions: i64,
    /// Type: 0 a cube, 101, 201 and 301 a disc.
    pub kind: i64,
}

impl Place {
    /// Reads it.
    pub fn of(inputs: &Inputs, control: &Control) -> Place {
        let data = ProbeData::of(inputs, control, WORKPIECE.holds(inputs));
        Place {
            sides: data.sides(control.plane.axes()),
            width: data.length(EDGE_LENGTH),
            depth: data.length(DEPTH),
            directions: data.number(DIRECTIONS) as i64,
            kind: data.number(TYPE) as i64,
        }
    }

    /// Middle in abscissa and ordinate, mm.
    pub fn middle(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.sides.middle(axis))
    }

    /// Upper side, mm.
    pub fn top(&self) -> f64 {
        self.sides.trigger(2, -1.0)
    }

    /// Height of the tool's end at a measurement in the plane, mm.
    pub fn low(&self) -> f64 {
        self.top() - self.depth
    }

    /// Whether automatic calibration may touch in this direction (B:4720-4739).
    pub fn allows(&self, axis: usize, direction: f64) -> bool {
        let digit = self.directions / 10_i64.pow(self.sides.indices[axis.min(2)] as u32) % 10;
        let bit = if direction < 0.0 { 1 } else { 2 };
        digit & bit != 0
    }
}

/// A tool before the probe.
#[derive(Clone)]
pub struct Task<'a> {
    /// Values of the call.
    pub inputs: &'a Inputs,
    /// Measuring block.
    pub block: Block,
    /// The probe.
    pub place: Place,
    /// Radius of the tool, mm.
    pub radius: f64,
    /// Whether it is a drill, which is always measured over the centre.
    pub drill: bool,
}

impl Task<'_> {
    /// Reads tool and probe; checks what must be true before the first motion.
    pub fn prepare<'a>(machine: &mut dyn Machine, inputs: &'a Inputs) -> Result<Task<'a>, Stop> {
        let block = Block::for_tool(machine, inputs)?;
        let control = machine.control();
        let kind = control.active_edge().map_or(0, |edge| edge.kind);
        if matches!(kind, 400..=599 | 710) {
            return Err(alarm(machine, 61314)); // B:4157-4175, A:15855
        }
        Ok(Task {
            inputs,
            radius: block.radius,
            place: Place::of(inputs, control),
            drill: (200..300).contains(&kind) && MEASURE.holds(inputs),
            block,
        })
    }

    /// Goes to coordinates of some axes at once; the others stay.
    pub fn go(&self, machine: &mut dyn Machine, coordinates: &[(usize, f64)]) -> Result<(), Stop> {
        let mut to = machine.position();
        for (axis, value) in coordinates {
            to[self.block.axes[(*axis).min(2)]] = *value;
        }
        self.block.travel(machine, to)
    }

    /// Coordinate of an axis, WCS, mm.
    pub fn at(&self, machine: &mut dyn Machine, axis: usize) -> f64 {
        machine.position()[self.block.axes[axis.min(2)]]
    }

    /// Direction of probing in the plane from where the tool stands; 61332 where that is neither before nor behind the
    /// probe (B:4589, A:15875).
    pub fn direction(&self, machine: &mut dyn Machine, axis: usize) -> Result<f64, Stop> {
        let at = self.at(machine, axis);
        self.place.sides.towards(axis, at).ok_or_else(|| alarm(machine, 61332))
    }

    /// Side of the middle on which the tool stands, +1 or -1.
    pub fn side(&self, machine: &mut dyn Machine, axis: usize) -> f64 {
        if self.at(machine, axis) >= self.place.sides.middle(axis) { 1.0 } else { -1.0 }
    }

    /// The measuring block towards a side of the probe: where the axis of the tool is when its radius touches.
    pub fn beside(&self, axis: usize, direction: f64) -> Point {
        self.block.point(axis, direction, self.place.sides.trigger(axis, direction) - direction * self.radius)
    }

    /// The measuring block towards the upper side.
    pub fn above(&self) -> Point {
        self.block.point(2, -1.0, self.place.top())
    }

    /// Goes beside the probe and down: the other axis first, then the measuring axis, then the applicate (B:4573).
    pub fn enter(&self, machine: &mut dyn Machine, point: &Point, other: f64, low: f64) -> Result<(), Stop> {
        self.go(machine, &[(1 - point.axis, other)])?;
        self.go(machine, &[(point.axis, self.block.start(point))])?;
        self.go(machine, &[(2, low)])
    }

    /// How far from the middle of the probe the tool stands over its upper side: a tool that is wider by its radius
    /// less `_ID`, to the side of the start (B:4593-4599).
    pub fn offset(&self, machine: &mut dyn Machine, axis: usize) -> [f64; 2] {
        let mut offset = [0.0; 2];
        if 2.0 * self.radius > self.place.width && !self.drill {
            let inward = self.inputs.given(names::ID).unwrap_or(0.0);
            offset[axis] = self.side(machine, axis) * (self.radius - inward);
        }
        offset
    }

    /// Touches the upper side over a middle, or so far beside it; the position of the tool's end, mm.
    pub fn touch_above(&self, machine: &mut dyn Machine, middle: [f64; 2], offset: [f64; 2]) -> Result<f64, Stop> {
        self.over(machine, middle, offset)?;
        self.block.latch(machine, &self.above())
    }

    /// Goes over the middle of the probe, or so far beside it.
    pub fn over(&self, machine: &mut dyn Machine, middle: [f64; 2], offset: [f64; 2]) -> Result<(), Stop> {
        let to = [0, 1].map(|axis| (axis, middle[axis] + offset[axis]));
        self.go(machine, &to)
    }
}
