//! Where the control believes the tool probe to be, and how the tool goes to it.
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate; directions are +1 and -1.

use super::params::{MEASURE, WORKPIECE};
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::sinumerik::measuring_block::{Block, Point};
use crate::catalogue::tool_probe::ProbeData;
use crate::catalogue::tool_probe::store::Trigger;
use crate::control::{Control, Edge};
use crate::entry::{Inputs, names};
use crate::machine::{Machine, Stop};

/// Edge length or diameter of the upper side in `_TP[k,i]` (B:13363).
const EDGE_LENGTH: usize = 6;
/// Axes and directions of automatic calibration (B:13365).
const DIRECTIONS: usize = 7;
/// Type (B:13366).
const TYPE: usize = 8;
/// From the upper side to the tool's end at a measurement in the plane (B:13369).
const DEPTH: usize = 9;

/// The data of the probe by the axes of the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Indices X Y Z of abscissa, ordinate, applicate.
    axes: [usize; 3],
    /// Trigger points: moving in minus direction, and in plus direction; mm.
    triggers: [[f64; 2]; 3],
    /// Names of their data.
    names: [[String; 2]; 3],
    /// Edge length or diameter of the upper side, mm.
    edge: f64,
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
        let axes = control.plane.axes();
        Place {
            axes,
            triggers: axes.map(|axis| data.triggers(axis)),
            names: axes.map(|axis| [data.name(2 * axis), data.name(2 * axis + 1)]),
            edge: data.length(EDGE_LENGTH),
            depth: data.length(DEPTH),
            directions: data.number(DIRECTIONS) as i64,
            kind: data.number(TYPE) as i64,
        }
    }

    /// Trigger point, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.triggers[axis.min(2)][usize::from(direction > 0.0)]
    }

    /// Middle of both trigger points, mm.
    pub fn centre(&self, axis: usize) -> f64 {
        let [minus, plus] = self.triggers[axis.min(2)];
        (minus + plus) / 2.0
    }

    /// Middle in abscissa and ordinate, mm.
    pub fn middle(&self) -> [f64; 2] {
        [self.centre(0), self.centre(1)]
    }

    /// Upper side, mm.
    pub fn top(&self) -> f64 {
        self.trigger(2, -1.0)
    }

    /// Height of the tool's end at a measurement in the plane, mm.
    pub fn low(&self) -> f64 {
        self.top() - self.depth
    }

    /// Edge length or diameter of the upper side, mm.
    pub fn width(&self) -> f64 {
        self.edge
    }

    /// The place with another upper side.
    pub fn with_top(&self, top: f64) -> Place {
        let mut place = self.clone();
        place.triggers[2][0] = top;
        place
    }

    /// Whether automatic calibration may touch in this direction (B:4720-4739).
    pub fn allows(&self, axis: usize, direction: f64) -> bool {
        let digit = self.directions / 10_i64.pow(self.axes[axis.min(2)] as u32) % 10;
        let bit = if direction < 0.0 { 1 } else { 2 };
        digit & bit != 0
    }

    /// A trigger point as found, with where it is stored and told: by geometry axis (B:4204-4215, B:13357-13362).
    pub fn found(&self, axis: usize, direction: f64, value: f64) -> Trigger {
        let side = usize::from(direction > 0.0);
        Trigger {
            name: self.names[axis.min(2)][side].clone(),
            result: 8 + 4 * self.axes[axis.min(2)] + 2 * side,
            value,
        }
    }

    /// Direction of probing from where the tool stands; 61332 where that is neither before nor behind the probe, or not
    /// above it (B:4589, A:15875).
    pub fn direction(&self, machine: &mut dyn Machine, axis: usize) -> Result<f64, Stop> {
        let at = machine.position()[self.axes[axis.min(2)]];
        let [minus, plus] = self.triggers[axis.min(2)];
        if at > minus {
            Ok(-1.0)
        } else if axis != 2 && at < plus {
            Ok(1.0)
        } else {
            Err(alarm(machine, 61332))
        }
    }

    /// Side of the middle on which the tool stands, +1 or -1.
    pub fn side(&self, machine: &mut dyn Machine, axis: usize) -> f64 {
        let at = machine.position()[self.axes[axis.min(2)]];
        if at >= self.centre(axis) { 1.0 } else { -1.0 }
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
        let kind = control.active_edge().map_or(0, |edge: &Edge| edge.kind);
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

    /// The measuring block towards a side of the probe: where the axis of the tool is when its radius touches.
    pub fn beside(&self, axis: usize, direction: f64) -> Point {
        self.block.point(axis, direction, self.place.trigger(axis, direction) - direction * self.radius)
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
    /// less
    /// `_ID`, to the side of the start (B:4593-4599).
    pub fn offset(&self, machine: &mut dyn Machine, axis: usize) -> [f64; 2] {
        let mut offset = [0.0; 2];
        if 2.0 * self.radius > self.place.width() && !self.drill {
            let inward = self.inputs.given(names::ID).unwrap_or(0.0);
            offset[axis] = self.place.side(machine, axis) * (self.radius - inward);
        }
        offset
    }

    /// Goes over the middle of the probe, or so far beside it.
    pub fn over(&self, machine: &mut dyn Machine, middle: [f64; 2], offset: [f64; 2]) -> Result<(), Stop> {
        let to = [0, 1].map(|axis| (axis, middle[axis] + offset[axis]));
        self.go(machine, &to)
    }
}
