//! The table of alarms as JSON: for search, and for a card that explains one.

use super::{alarm_key, code, object};
use crate::catalogue::alarms::{ALARMS, Alarm, Found, raised_by, stops};
use serde_json::Value;

/// One object an alarm or message.
pub fn alarms() -> Value {
    ALARMS.iter().map(alarm).collect()
}

/// Its name, the key of its words (`.cause` and `.cure` behind it), whether the program stops, who raises it, and
/// where Probewright finds what raises it.
pub fn alarm(alarm: &Alarm) -> Value {
    object([
        ("code", code(alarm.code).into()),
        ("key", alarm_key(alarm.code).into()),
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
