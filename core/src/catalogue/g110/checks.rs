//! Checks over several addresses of G110.

use super::BORE;
use crate::catalogue::nct::{FORMAT_ERROR, NO_MOVEMENT};
use crate::check::{Finding, Inputs, error, warning};
use crate::control::Control;
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;

/// H not below U: the message about the tolerance never comes alone.
const LIMITS: Code = Code::Own(112);
/// The result goes into the register that T corrects.
const SAME_REGISTER: Code = Code::Own(113);

/// S with T (C:1089), a ball without a way to the wall (C:1133), limits that make no sense together, M and T the same register.
pub fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    let given = |name: &str| inputs.numbers.get(name).copied();
    if given("S").is_some() && given("T").is_some() {
        let message = Message::new("g110-offset-and-tool");
        findings.push(
            error(FORMAT_ERROR, message)
                .hint(Message::new("g110-offset-and-tool-hint"))
                .at("T"),
        );
    }
    let ball = ["#500", "#501", "#502", "#503"]
        .map(|name| control.basic_length(name))
        .into_iter();
    let ball = 2.0 * ball.fold(0.0, f64::max);
    if let Some(diameter) = given("D")
        && inputs.variant == BORE
        && diameter <= ball
    {
        let per = control.active_factor();
        let message = Message::new("g110-no-room")
            .number("diameter", diameter / per)
            .number("ball", ball / per);
        findings.push(
            error(NO_MOVEMENT, message)
                .hint(Message::new("g110-no-room-hint"))
                .at("D"),
        );
    }
    if let (Some(tolerance), Some(limit)) = (given("H"), given("U"))
        && limit <= tolerance
    {
        let message = Message::new("g110-limits");
        findings.push(
            warning(LIMITS, message)
                .hint(Message::new("g110-limits-hint"))
                .at("U"),
        );
    }
    if given("M").is_some() && given("M") == given("T") {
        let message = Message::new("g110-same-register");
        findings.push(
            warning(SAME_REGISTER, message)
                .hint(Message::new("g110-same-register-hint"))
                .at("M"),
        );
    }
}
