//! The help page of a variant as JSON.

use super::{Error, alarm, dialect, key, object};
use crate::catalogue::alarms;
use crate::catalogue::help::HelpPage;
use crate::entry::ResultField;
use crate::entry::{HelpLine, SECTIONS, Section};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
struct Request {
    control: String,
    cycle: String,
    mvar: i64,
}

/// Answers a `HelpRequest` with a `HelpView`.
pub fn help(request: &str) -> Result<Value, Error> {
    let request: Request = super::request(request)?;
    let cycle = super::cycle(dialect(&request.control)?, &request.cycle)?;
    let page = HelpPage::of(cycle, request.mvar);
    let section = |section: Section| {
        let lines: Vec<Value> = page.section(section).map(line).collect();
        let heading = ("label", key(section.key(cycle)));
        object([heading, ("lines", lines.into())])
    };
    let filled = |view: &Value| view["lines"].as_array().is_some_and(|lines| !lines.is_empty());
    let sections: Vec<Value> = SECTIONS.into_iter().map(section).filter(filled).collect();
    let known = |code| alarms::ALARMS.iter().find(|alarm| alarm.code == code);
    let raised = page.alarms.iter().filter_map(|code| known(*code));
    Ok(object([
        ("sections", sections.into()),
        ("required", page.required.into()),
        ("results", page.results.into_iter().map(result).collect()),
        ("alarms", raised.map(alarm).collect()),
    ]))
}

fn result(field: &ResultField) -> Value {
    object([("name", field.name.into()), ("key", field.key.into())])
}

fn line(line: &HelpLine) -> Value {
    object([("message", key(line.key)), ("source", line.source.into())])
}
