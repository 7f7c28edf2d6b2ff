//! The tables of alarms and of texts for the operator: for search, and for a card that explains one.

use crate::catalogue::alarms::{ALARMS, key, raised_by, stops};
use crate::catalogue::operator_messages::{MESSAGES, OperatorMessage, shown_by};
use crate::catalogue::{alarms, operator_messages};
use crate::manual::Cited;
use serde::Serialize;

/// An alarm, or a text for the operator.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AlarmInfo {
    /// Name of the alarm: `61303`, `PROBE FAIL`; of a text for the operator the text itself.
    pub code: String,
    /// Key of its words; `.cause` (where it says more) and `.cure` stand behind it.
    pub key: String,
    /// Whether the program stops.
    pub stops: bool,
    /// Who raises it: cycles of the catalogue, then other programs.
    pub cycles: Vec<&'static str>,
    /// Where what raises it is found.
    pub found: alarms::Found,
    /// Place in the manual.
    pub source: Cited,
}

/// All alarms, then all texts for the operator.
pub fn alarms() -> Vec<AlarmInfo> {
    ALARMS.iter().map(AlarmInfo::of).chain(MESSAGES.iter().map(AlarmInfo::of_message)).collect()
}

/// The alarm or text with this name.
pub fn alarm(name: &str) -> Option<AlarmInfo> {
    alarms::find(name).map(AlarmInfo::of).or_else(|| operator_messages::find(name).map(AlarmInfo::of_message))
}

impl AlarmInfo {
    /// An alarm of the table.
    pub fn of(alarm: &alarms::Alarm) -> AlarmInfo {
        AlarmInfo {
            code: alarm.code.to_string(),
            key: key(alarm.code),
            stops: stops(alarm.code),
            cycles: raised_by(alarm),
            found: alarm.found,
            source: Cited(alarm.source),
        }
    }

    /// A text for the operator.
    pub fn of_message(message: &OperatorMessage) -> AlarmInfo {
        AlarmInfo {
            code: message.text.to_owned(),
            key: message.key.to_owned(),
            stops: false,
            cycles: shown_by(message),
            found: message.found,
            source: Cited(message.source),
        }
    }
}
