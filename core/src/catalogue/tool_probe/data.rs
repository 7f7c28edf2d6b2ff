//! The data of a tool probe in `_TP[k,i]` (machine) or `_TPW[k,i]` (workpiece), B:13354-13421.

use super::params::WORKPIECE;
use super::store::Trigger;
use crate::catalogue::prelude::*;
use crate::geometry::TOLERANCE;
use crate::workpiece::ToolProbe;

/// Edge length or diameter of the upper side (B:13363).
pub const EDGE_LENGTH: usize = 6;
/// Axes and directions of automatic calibration (B:13365).
pub const DIRECTIONS: usize = 7;
/// Type: 0 a cube, 101, 201 and 301 a disc (B:13366).
pub const TYPE: usize = 8;
/// From the upper side to the tool's end at a measurement in the plane (B:13369).
pub const DEPTH: usize = 9;

/// The datum that counts the probes of the machine or of the workpiece (B:13345-13348).
pub fn count(inputs: &Inputs) -> &'static str {
    if WORKPIECE.holds(inputs) { "_CVAL[3]" } else { "_CVAL[0]" }
}

/// The tool probe of a call, where the control believes it to be.
///
/// Axes count 0 abscissa, 1 ordinate, 2 applicate; directions of the tool are +1 and -1.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeData {
    array: &'static str,
    index: i64,
    /// Directions and type as they stand there, lengths in mm.
    values: [f64; 10],
    /// Index of each axis among the trigger values: they count by geometry axis on milling machines (B:4204-4215,
    /// B:13357-13362), by axis of the plane on turning machines (B:13370-13384).
    indices: [usize; 3],
}

impl ProbeData {
    /// The probe that `_PRNUM` names.
    pub fn of(inputs: &Inputs, control: &Control) -> Self {
        let milling = inputs.cycle.purpose.machine == MachineSort::Milling;
        let mut data = Self {
            array: inputs.cycle.purpose.probe_array(inputs),
            index: inputs.integer(names::PRNUM) - 1,
            values: [0.0; 10],
            indices: if milling { control.plane.axes() } else { [0, 1, 2] },
        };
        data.values = std::array::from_fn(|i| match i {
            DIRECTIONS | TYPE => control.number(&data.name(i)),
            _ => control.basic_length(&data.name(i)),
        });
        data
    }

    /// Name of one datum: `_TP[0,6]`.
    pub fn name(&self, i: usize) -> String {
        format!("{}[{},{i}]", self.array, self.index)
    }

    /// A datum; a length in mm.
    pub fn value(&self, i: usize) -> f64 {
        self.values[i]
    }

    /// Index of the trigger value of an axis.
    pub fn datum(&self, axis: usize, direction: f64) -> usize {
        2 * self.indices[axis.min(2)] + usize::from(direction > 0.0)
    }

    /// Coordinate at which the probe switches, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.values[self.datum(axis, direction)]
    }

    /// Middle between both trigger values, mm.
    pub fn middle(&self, axis: usize) -> f64 {
        (self.trigger(axis, -1.0) + self.trigger(axis, 1.0)) / 2.0
    }

    /// Middle in abscissa and ordinate, mm.
    pub fn centre(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.middle(axis))
    }

    /// Upper side, mm.
    pub fn top(&self) -> f64 {
        self.trigger(2, -1.0)
    }

    /// This probe with another upper side, mm.
    pub fn with_top(mut self, top: f64) -> Self {
        self.values[self.datum(2, -1.0)] = top;
        self
    }

    /// Height of the tool's end at a measurement in the plane, mm.
    pub fn low(&self) -> f64 {
        self.top() - self.value(DEPTH)
    }

    /// Direction towards the probe from a coordinate, mm; none beside neither side.
    pub fn towards(&self, axis: usize, from: f64) -> Option<f64> {
        if from > self.trigger(axis, -1.0) + TOLERANCE {
            return Some(-1.0);
        }
        (from < self.trigger(axis, 1.0) - TOLERANCE).then_some(1.0)
    }

    /// Whether automatic calibration may touch in this direction (B:4720-4739).
    pub fn allows(&self, axis: usize, direction: f64) -> bool {
        let digit = self.value(DIRECTIONS) as i64 / 10_i64.pow(self.indices[axis.min(2)] as u32) % 10;
        let bit = if direction < 0.0 { 1 } else { 2 };
        digit & bit != 0
    }

    /// A trigger value as found, mm, with its datum and its field in `_OVR[]` (B:4204-4215, B:9287-9294,
    /// B:13357-13362).
    pub fn found(&self, axis: usize, direction: f64, value: f64) -> Trigger {
        let datum = self.datum(axis, direction);
        Trigger { name: self.name(datum), result: 8 + 2 * datum, value }
    }

    /// The cube or disc between the trigger values of the plane, so high and with its upper side here, mm; none where
    /// they leave no room.
    pub fn cap(&self, control: &Control, disc: bool, top: f64, height: f64) -> Option<ToolProbe> {
        let [x, y] = [0, 1].map(|axis| self.trigger(axis, -1.0) - self.trigger(axis, 1.0));
        if x <= 0.0 || y <= 0.0 {
            return None;
        }
        let shape = match disc {
            true => Shape::Turned { diameter: x, length: height, bore: [0.0; 2] },
            false => Shape::Block { size: [x, y, height] },
        };
        let [abscissa, ordinate] = self.centre();
        Some(ToolProbe::ideal(place::solid(control, shape, [abscissa, ordinate, top], place::unit(0), place::unit(2))))
    }
}
