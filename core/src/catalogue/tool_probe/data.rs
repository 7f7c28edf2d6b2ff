//! The data of a tool probe in `_TP[k,i]` (machine) or `_TPW[k,i]` (workpiece), B:13354-13421.

use super::store::Trigger;
use crate::catalogue::place;
use crate::catalogue::prelude::*;
use crate::geometry::TOLERANCE;
use crate::workpiece::{Shape, ToolProbe};

/// One tool probe of a control.
pub struct ProbeData<'a> {
    control: &'a Control,
    array: &'static str,
    index: i64,
}

impl<'a> ProbeData<'a> {
    /// The probe that `_PRNUM` names, in `_TP` or, for a measurement in the workpiece system, in `_TPW`.
    pub fn of(inputs: &Inputs, control: &'a Control, workpiece: bool) -> Self {
        Self { control, array: if workpiece { "_TPW" } else { "_TP" }, index: inputs.integer(names::PRNUM) - 1 }
    }

    /// Name of one datum: `_TP[0,6]`.
    pub fn name(&self, i: usize) -> String {
        format!("{}[{},{i}]", self.array, self.index)
    }

    /// A datum without a unit.
    pub fn number(&self, i: usize) -> f64 {
        self.control.number(&self.name(i))
    }

    /// A datum that is a length, mm.
    pub fn length(&self, i: usize) -> f64 {
        self.control.basic_length(&self.name(i))
    }

    /// Trigger values of the axis with this index, mm: touched while moving in minus direction, and in plus direction.
    pub fn triggers(&self, axis: usize) -> [f64; 2] {
        [self.length(2 * axis), self.length(2 * axis + 1)]
    }

    /// The trigger values by the axes of the plane, whose data have these indices.
    pub fn sides(&self, indices: [usize; 3]) -> Sides {
        Sides {
            names: indices.map(|axis| [self.name(2 * axis), self.name(2 * axis + 1)]),
            values: indices.map(|axis| self.triggers(axis)),
            indices,
        }
    }
}

/// The trigger values of a tool probe. Axes count 0 abscissa, 1 ordinate, 2 applicate; directions are +1 and -1.
#[derive(Clone, Debug, PartialEq)]
pub struct Sides {
    /// Index of each axis among the data.
    pub indices: [usize; 3],
    names: [[String; 2]; 3],
    values: [[f64; 2]; 3],
}

impl Sides {
    /// Coordinate at which the probe switches, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.values[axis.min(2)][usize::from(direction > 0.0)]
    }

    /// Middle between both trigger values, mm.
    pub fn middle(&self, axis: usize) -> f64 {
        let [minus, plus] = self.values[axis.min(2)];
        (minus + plus) / 2.0
    }

    /// Direction towards the probe from a coordinate, mm; none beside neither side.
    pub fn towards(&self, axis: usize, from: f64) -> Option<f64> {
        let [minus, plus] = self.values[axis.min(2)];
        if from > minus + TOLERANCE { Some(-1.0) } else { (from < plus - TOLERANCE).then_some(1.0) }
    }

    /// A trigger value as found, mm, with its datum and its field in `_OVR[]` (B:4204-4215, B:9287-9294,
    /// B:13357-13362).
    pub fn found(&self, axis: usize, direction: f64, value: f64) -> Trigger {
        let (axis, side) = (axis.min(2), usize::from(direction > 0.0));
        Trigger { name: self.names[axis][side].clone(), result: 8 + 4 * self.indices[axis] + 2 * side, value }
    }

    /// These sides with another upper one, mm.
    pub fn with_top(mut self, top: f64) -> Sides {
        self.values[2][0] = top;
        self
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
        let at = [self.middle(0), self.middle(1), top];
        Some(ToolProbe::ideal(place::solid(control, shape, at, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])))
    }
}
