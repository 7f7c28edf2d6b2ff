//! What is contradictory or dangerous over several addresses of G65 P9920.

use super::{CALIBRATE, DIAMETER};
use crate::check::{Finding, Inputs, error, warning};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;

/// Beside the disk the way is reckoned with the diameter, and none is known.
const NO_DIAMETER: Code = Code::Own(116);
/// A turning tool comes down on the disk.
const TURNING_LENGTH: Code = Code::Own(117);
/// Without a clearance the tool sinks along the wall of the disk.
const NO_CLEARANCE: Code = Code::Own(118);

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    if diameter(inputs, control) == 0.0 && inputs.variant != super::LENGTH {
        findings.push(
            error(NO_DIAMETER, Message::new("p9920-no-diameter"))
                .hint(Message::new("p9920-no-diameter-hint"))
                .at("D"),
        );
    }
    if inputs.variant != CALIBRATE && matches!(inputs.integer("M"), 3 | 4) {
        findings.push(
            warning(TURNING_LENGTH, Message::new("p9920-turning-length"))
                .hint(Message::new("p9920-turning-length-hint"))
                .at("M"),
        );
    }
    let beside = matches!(inputs.variant, CALIBRATE | DIAMETER);
    if beside && inputs.given("E") == Some(0.0) {
        findings.push(
            warning(NO_CLEARANCE, Message::new("p9920-no-clearance"))
                .hint(Message::new("p9920-no-clearance-hint"))
                .at("E"),
        );
    }
}

/// Diameter with which the ways are reckoned, mm: D, or that of the register (C:1238).
pub fn diameter(inputs: &Inputs, control: &Control) -> f64 {
    let register = inputs.integer("T");
    let stored = || 2.0 * control.register(register).total_radius();
    inputs.given("D").unwrap_or_else(stored)
}
