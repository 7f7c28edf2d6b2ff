//! What is contradictory or dangerous over several addresses of G65 P9920.

use super::{CALIBRATE, DIAMETER};
use crate::catalogue::tool_probe::checks::radius;
use crate::control::Control;
use crate::diagnostic::Diagnostic;
use crate::entry::{Inputs, address};
use crate::own;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    if diameter(inputs, control) == 0.0 && inputs.variant != super::LENGTH {
        // beside the disk the way is reckoned with it
        findings.push(own::P9920_NO_DIAMETER.finding().at(address::D));
    }
    if inputs.variant != CALIBRATE && matches!(inputs.integer(address::M), 3 | 4) {
        // it comes down on the disk
        findings.push(own::P9920_TURNING_LENGTH.finding().at(address::M));
    }
    radius(control, findings);
    let beside = matches!(inputs.variant, CALIBRATE | DIAMETER);
    if beside && inputs.given(address::E) == Some(0.0) {
        // the tool sinks along the wall of the disk
        findings.push(own::P9920_NO_CLEARANCE.finding().at(address::E));
    }
}

/// Diameter with which the ways are reckoned, mm: D, or that of the register (C:1238).
pub fn diameter(inputs: &Inputs, control: &Control) -> f64 {
    let register = inputs.integer(address::T);
    let stored = || 2.0 * control.register(register).total_radius();
    inputs.given(address::D).unwrap_or_else(stored)
}
