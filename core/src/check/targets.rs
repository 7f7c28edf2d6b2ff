//! `_KNUM` against the variant and the control: what it means, and which alarm a wrong one raises (B:1894-2029).

use super::error;
use crate::control::{Control, Store};
use crate::diagnostic::{Code, Diagnostic};
use crate::entry::{Inputs, Param, When};
use crate::evaluate::{knum, knum::ZeroCode, tool_offset, zero_offset};
use crate::message::Message;

/// Sort of target that a variant asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Tool offset.
    Tool,
    /// Zero offset.
    Zero,
}

/// The sort of target: every cycle labels its `_KNUM` `knum-tool` or `knum-zero` by variant.
pub fn target(param: &Param, inputs: &Inputs) -> Target {
    let zero = |(when, key): &(When, &str)| *key == "knum-zero" && when.holds(inputs);
    if param.labels.iter().any(zero) { Target::Zero } else { Target::Tool }
}

/// What is wrong with the code.
pub fn findings(param: &Param, inputs: &Inputs, control: &Control) -> Option<Diagnostic> {
    let code = inputs.given(param.name)? as i64;
    match target(param, inputs) {
        Target::Zero => zero(param, code, control),
        Target::Tool => tool(param, code, control),
    }
}

fn zero(param: &Param, code: i64, control: &Control) -> Option<Diagnostic> {
    let alarm = match knum::zero(code) {
        Err(alarm) => alarm,
        Ok(Some(ZeroCode::Stored(Store::System))) if !zero_offset::system_frame(control) => {
            let message = Message::new("check-knum-no-system").number("code", code as f64);
            let finding = error(Code::Alarm(61321), message).hint(Message::new("check-knum-no-system-hint"));
            return Some(finding.at(param.name));
        }
        Ok(_) => return None,
    };
    let is_tool = matches!(knum::tool(code, knum::five_digit_edges(control)), Ok(Some(_)));
    let hint = if is_tool { "check-knum-is-tool-hint" } else { "check-knum-zero-hint" };
    let message = Message::new("check-knum-zero").number("code", code as f64);
    Some(error(Code::Alarm(alarm), message).hint(Message::new(hint)).at(param.name))
}

fn tool(param: &Param, code: i64, control: &Control) -> Option<Diagnostic> {
    let five = knum::five_digit_edges(control);
    let (alarm, key) = match knum::tool(code, five) {
        Ok(None) => return None,
        Ok(Some(target)) if target.edge <= largest_edge(control) => {
            return target.location.then(|| memory(param, control))?;
        }
        Ok(Some(_)) => (61345, "check-knum-edge-large"),
        Err(61322) => (61322, "check-knum-digit-4"),
        Err(61323) => (61323, "check-knum-digit-5"),
        Err(61324) => (61324, "check-knum-digit-6"),
        Err(61328) => (61328, "check-knum-edge-none"),
        Err(alarm) => (alarm, "check-knum-digit-7"),
    };
    let hint = if matches!(knum::zero(code), Ok(Some(_))) {
        "check-knum-is-zero-hint"
    } else if five {
        "check-knum-nine-digits-hint"
    } else {
        "check-knum-seven-digits-hint"
    };
    let message = Message::new(key).number("code", code as f64).number("largest", largest_edge(control) as f64);
    Some(error(Code::Alarm(alarm), message).hint(Message::new(hint)).at(param.name))
}

/// Setup or additive offsets that this machine does not have.
fn memory(param: &Param, control: &Control) -> Option<Diagnostic> {
    let alarm = tool_offset::missing_memory(control)?;
    let (key, hint) = match alarm {
        61408 => ("check-knum-no-additive", "check-knum-no-additive-hint"),
        _ => ("check-knum-no-setup", "check-knum-no-setup-hint"),
    };
    Some(error(Code::Alarm(alarm), Message::new(key)).hint(Message::new(hint)).at(param.name))
}

/// Largest D number (MD18105); 9 where it is not set, 32000 with flat D numbers (MD18102=1, B:2009).
fn largest_edge(control: &Control) -> i64 {
    match (control.number("MD18102"), control.number("MD18105")) {
        (1.0, _) => 32_000,
        (_, 0.0) => 9,
        (_, largest) => largest as i64,
    }
}
