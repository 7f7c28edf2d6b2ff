//! The tables of alarms and of texts for the operator as JSON: for search, and for a card that explains one.

use super::{code, object};
use crate::catalogue::alarms::{ALARMS, Alarm, Found, key, raised_by, stops};
use crate::catalogue::operator_messages::{MESSAGES, OperatorMessage, shown_by};
use serde_json::Value;

/// One object an alarm or message.
pub fn alarms() -> Value {
    let alarms = ALARMS.iter().map(alarm);
    alarms.chain(MESSAGES.iter().map(operator_message)).collect()
}

/// A text for the operator, in the shape of an alarm; its text is its name.
pub fn operator_message(message: &OperatorMessage) -> Value {
    object([
        ("code", message.text.into()),
        ("key", message.key.into()),
        ("stops", false.into()),
        ("cycles", shown_by(message).into()),
        ("found", found(Found::Nowhere).into()),
        ("source", message.source.into()),
    ])
}

/// Its name, the key of its words (`.cause` and `.cure` behind it), whether the program stops, who raises it, and
/// where Probewright finds what raises it.
pub fn alarm(alarm: &Alarm) -> Value {
    object([
        ("code", code(alarm.code).into()),
        ("key", key(alarm.code).into()),
        ("stops", stops(alarm.code).into()),
        ("cycles", raised_by(alarm).into()),
        ("found", found(alarm.found).into()),
        ("source", alarm.source.into()),
    ])
}

fn found(found: Found) -> &'static str {
    match found {
        Found::Check => "check",
        Found::Run => "run",
        Found::Both => "both",
        Found::Nowhere => "nowhere",
    }
}
