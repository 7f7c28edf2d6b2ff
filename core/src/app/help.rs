//! The help page of a variant.

use super::whereabouts::whereabouts;
use super::{AlarmInfo, Error, cycle};
use crate::catalogue::alarms::ALARMS;
use crate::catalogue::help::HelpPage;
use crate::check::newer;
use crate::dialect::Dialect;
use crate::entry::{HelpLine, ResultField, SECTIONS, Section, Style};
use crate::manual::Cited;
use crate::message::Message;
use crate::name::Name;
use serde::{Deserialize, Serialize};

/// Which page.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct HelpRequest {
    /// Control.
    pub control: Dialect,
    /// Cycle.
    pub cycle: String,
    /// Number of the variant.
    pub mvar: i64,
    /// Call style of the call that the page is about; absent: that of the cycle.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Style>"))]
    pub style: Option<Style>,
}

/// The help page of a variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct HelpView {
    /// What of the page does not count for a call in the list of a newer control.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional, as = "Option<Message>"))]
    pub note: Option<Message>,
    /// Sections of the page, in order; none is empty.
    pub sections: Vec<HelpSection>,
    /// Parameters that every call of the variant gives.
    pub required: Vec<Name>,
    /// Results that a call can leave.
    pub results: Vec<HelpResult>,
    /// Alarms that can come.
    pub alarms: Vec<AlarmInfo>,
    /// Where it is on the control, or why it is not.
    pub places: Vec<HelpText>,
}

/// A section of a help page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct HelpSection {
    /// Heading of the section.
    pub label: Message,
    /// What it says.
    pub lines: Vec<HelpText>,
}

/// A line of a help page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct HelpText {
    /// What it says.
    pub message: Message,
    /// Place in the manual.
    pub source: Cited,
}

/// A result by its name and the key of its meaning.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct HelpResult {
    /// `_OVR[4]`.
    pub name: &'static str,
    /// Key of its meaning.
    pub key: &'static str,
}

/// The help page of a variant.
///
/// # Errors
/// There is no such cycle.
pub fn help(asked: HelpRequest) -> Result<HelpView, Error> {
    let cycle = cycle(asked.control, &asked.cycle)?;
    let mut page = HelpPage::of(cycle, asked.mvar);
    let list = cycle.lists.iter().find(|list| asked.style == Some(Style::Operate) && list.style == Style::Operate);
    if let Some(list) = list {
        page.required.retain(|name| list.position(*name).is_some() && newer::is_needed(*name));
    }
    let section = |section: Section| {
        let line = |line: &HelpLine| HelpText { message: Message::new(line.key), source: Cited(line.source) };
        let lines: Vec<HelpText> = page.section(section).map(line).collect();
        (!lines.is_empty()).then(|| HelpSection { label: Message::new(section.key(cycle.purpose.probe)), lines })
    };
    let result = |field: &ResultField| HelpResult { name: field.name, key: field.key };
    let known = |code| ALARMS.iter().find(|alarm| alarm.code == code);
    let raised = page.alarms.iter().filter_map(|code| known(*code));
    Ok(HelpView {
        note: list.map(|_| Message::new("argument-help-older")),
        sections: SECTIONS.into_iter().filter_map(section).collect(),
        alarms: raised.map(AlarmInfo::of).collect(),
        results: page.results.into_iter().map(result).collect(),
        required: page.required,
        places: whereabouts(cycle, asked.mvar),
    })
}
