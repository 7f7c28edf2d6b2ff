//! What several values of CYCLE976 say together.

use super::params::{HOLE, LENGTH, SKEW, SURFACE, UNKNOWN};
use crate::catalogue::calibration;
use crate::catalogue::prelude::*;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    calibration::band(inputs, found);
    calibration::unmirrored(control, found);
    let ball = calibration::ball_radius(inputs, control);
    first(inputs, control, ball, found);
    if HOLE.holds(inputs) {
        hole(inputs, control, ball, found);
    }
    if UNKNOWN.holds(inputs) {
        reversal(inputs, control, found);
    }
    against(inputs, control, found);
    shared_checks::lathe_length(inputs, control, found);
}

/// With `_CBIT[14]` = 1 the trigger value of the applicate is 0 itself (B:5583).
fn first(inputs: &Inputs, control: &Control, ball: f64, found: &mut Vec<Diagnostic>) {
    let applicate = inputs.number(names::MA) as i64 == 3 && !HOLE.holds(inputs);
    if !(applicate && control.bit("_CBIT[14]")) {
        calibration::first(inputs, control, ball, found);
    }
}

/// The ball has to fit and to have its way (B:5132, B:5198).
fn hole(inputs: &Inputs, control: &Control, ball: f64, found: &mut Vec<Diagnostic>) {
    let Some(size) = inputs.given(names::SETVAL) else { return };
    if size <= 0.0 {
        let finding = own::RANGE.finding().text("param", names::SETVAL);
        let finding = finding.number("value", size / factor(Unit::ActiveLength, control));
        let finding = finding.text("unit", unit_behind(Unit::ActiveLength, control));
        found.push(finding.hint(Message::new("check-positive-hint")).at(names::SETVAL));
    } else if shared_checks::fits(names::SETVAL, size, ball, found) {
        shared_checks::across(inputs, names::SETVAL, size, ball, found);
    }
}

/// Two runs, between which the spindle turns (B:5241, B:5331-5332); the skew is found in any case (B:5230).
fn reversal(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    if !control.spindle_positions {
        found.push(refused(61372, "check-reversal-spindle", names::MVAR));
    }
    if !SKEW.holds(inputs) {
        found.push(own::SKEW_LOST.finding().at(names::MVAR));
    }
}

/// In the applicate a probe in the spindle touches in minus direction only; the manual names no field for the other one
/// but `_WP[k,6]` (B:5352). One whose body lies on the minus side touches in plus direction.
fn against(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let applicate = LENGTH.holds(inputs) || SURFACE.holds(inputs);
    let axis = inputs.given(names::MA) == Some(3.0);
    let pulls = if place::side(control) > 0.0 { 0.0 } else { 1.0 };
    if applicate && axis && inputs.given(names::MD) == Some(pulls) {
        found.push(own::APPLICATE_PLUS.finding().at(names::MD));
    }
}
