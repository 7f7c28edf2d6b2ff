//! What a measuring call of a turning machine means: its axis, and whether its dimensions are diameters.

use super::params::TRANSVERSE;
use crate::catalogue::common::APPLICATE;
use crate::catalogue::prelude::*;

/// Results that every call of these cycles begins with (B:16014-16022).
pub fn begin(machine: &mut dyn Machine, inputs: &Inputs, cycle: i64) {
    results::begin(machine, inputs, cycle);
    results::integer(machine, 3, inputs.variant);
    results::integer(machine, 12, 0);
}

/// Axis in which tool and zero offset are corrected where this one is measured: itself, or with `_CHBIT[19]` = 1 in G18
/// X, the ordinate, for Y (B:14023-14027).
pub fn corrected(inputs: &Inputs, axis: usize) -> usize {
    if axis == 2 && like_x(inputs) { 1 } else { axis }
}

/// Whether Y, the applicate of G18, is measured and counts like X (B:11001, B:14023-14027).
fn like_x(inputs: &Inputs) -> bool {
    inputs.plane == Plane::G18 && APPLICATE.holds(inputs) && TRANSVERSE.holds(inputs)
}

/// Dimension per length in the measuring axis: 2 where dimensions are diameters (B:10623, B:10975), else 1.
pub fn per(control: &Control, inputs: &Inputs) -> f64 {
    if TRANSVERSE.holds(inputs) { control.transverse.shown() } else { 1.0 }
}

/// Dimension per length of an axis, measured or not: of X, and of Y where it counts like X.
pub fn per_axis(control: &Control, inputs: &Inputs, axis: usize) -> f64 {
    if control.plane.axes()[axis.min(2)] == 0 || axis == 2 && like_x(inputs) { control.transverse.shown() } else { 1.0 }
}
