//! Checks over several addresses that macros share.

use super::{FORMAT_ERROR, NO_MOVEMENT};
use crate::check::{Finding, Inputs, error, warning};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;

/// H not below U: the message about the tolerance never comes alone.
const LIMITS: Code = Code::Own(112);
/// The result goes into the register that T corrects.
const SAME_REGISTER: Code = Code::Own(113);

/// S with T (C:1089), limits that make no sense together, M and T the same register.
pub fn corrections(inputs: &Inputs, findings: &mut Vec<Diagnostic>) {
    if inputs.given("S").is_some() && inputs.given("T").is_some() {
        let message = Message::new("nct-offset-and-tool");
        findings.push(
            error(FORMAT_ERROR, message)
                .hint(Message::new("nct-offset-and-tool-hint"))
                .at("T"),
        );
    }
    if let (Some(tolerance), Some(limit)) = (inputs.given("H"), inputs.given("U"))
        && limit <= tolerance
    {
        let message = Message::new("nct-limits");
        findings.push(
            warning(LIMITS, message)
                .hint(Message::new("nct-limits-hint"))
                .at("U"),
        );
    }
    if inputs.given("M").is_some() && inputs.given("M") == inputs.given("T") {
        let message = Message::new("nct-same-register");
        findings.push(
            warning(SAME_REGISTER, message)
                .hint(Message::new("nct-same-register-hint"))
                .at("M"),
        );
    }
}

/// A ball that has no way to the walls between which it stands (C:1133). `param` gives their distance.
pub fn room(
    inputs: &Inputs,
    param: &'static str,
    control: &Control,
    findings: &mut Vec<Diagnostic>,
) {
    let balls = ["#500", "#501", "#502", "#503"].map(|name| control.basic_length(name));
    let ball = 2.0 * balls.into_iter().fold(0.0, f64::max);
    let Some(size) = inputs.given(param).filter(|size| *size <= ball) else {
        return;
    };
    let per = control.active_factor();
    let message = Message::new("nct-no-room")
        .number("diameter", size / per)
        .number("ball", ball / per);
    findings.push(
        error(NO_MOVEMENT, message)
            .hint(Message::new("nct-no-room-hint"))
            .at(param),
    );
}
