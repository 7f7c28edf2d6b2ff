//! Checks over several addresses that macros share.

use super::{FORMAT_ERROR, NO_MOVEMENT};
use crate::catalogue::prelude::*;

/// S with T (C:1089), limits that make no sense together, M and T the same register.
pub fn corrections(inputs: &Inputs, findings: &mut Vec<Diagnostic>) {
    if inputs.given(address::S).is_some() && inputs.given(address::T).is_some() {
        let message = Message::new("nct-offset-and-tool");
        findings.push(error(FORMAT_ERROR, message).hint(Message::new("nct-offset-and-tool-hint")).at(address::T));
    }
    if inputs.given(address::H).zip(inputs.given(address::U)).is_some_and(|(tolerance, limit)| limit <= tolerance) {
        // the message about the tolerance would never come alone
        findings.push(own::NCT_LIMITS.finding().at(address::U));
    }
    if inputs.given(address::M).is_some() && inputs.given(address::M) == inputs.given(address::T) {
        findings.push(own::NCT_SAME_REGISTER.finding().at(address::M));
    }
}

/// A ball that has no way to the walls between which it stands (C:1133). `param` gives their distance.
pub fn room(inputs: &Inputs, param: Name, control: &Control, findings: &mut Vec<Diagnostic>) {
    let balls = ["#500", "#501", "#502", "#503"].map(|name| control.basic_length(name));
    let ball = 2.0 * balls.into_iter().fold(0.0, f64::max);
    let Some(size) = inputs.given(param).filter(|size| *size <= ball) else { return };
    let per = control.active_factor();
    let message = Message::new("nct-no-room").number("diameter", size / per).number("ball", ball / per);
    findings.push(error(NO_MOVEMENT, message).hint(Message::new("nct-no-room-hint")).at(param));
}
