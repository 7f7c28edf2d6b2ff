//! The data of a tool probe in `_TP[k,i]` (machine) or `_TPW[k,i]` (workpiece), B:13354-13421.

use crate::control::Control;
use crate::entry::{Inputs, names};

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
}
