//! Programs and logs of controls that are read and not run.

use crate::file::{Problem, wrong};
use probewright_core::app::{ForeignFigure, ForeignView};
use probewright_core::entry::Typed;
use probewright_core::foreign::{self, Unwritten};
use probewright_core::message::{Message, printable};
use probewright_core::words::{Words, rounded};
use std::io::Write;
use std::path::Path;

/// Lists its probe cycles with what they mean, or what its logs say.
pub fn list(path: &Path, view: &ForeignView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let path = path.display();
    for call in &view.calls {
        let title = call.title.as_ref().map(|title| words.text(title)).unwrap_or_default();
        writeln!(out, "{path}:{}: {} {title}", call.line, printable(&call.cycle))?;
        for one in &call.values {
            let meaning = one.meaning.as_ref().map(|meaning| words.text(meaning)).unwrap_or_default();
            writeln!(out, "    {}={} {meaning}", printable(&one.name), printable(&one.value))?;
        }
    }
    for log in &view.logs {
        let head = Message::new("foreign-log").text("cycle", log.cycle.as_str()).text("program", log.program.as_str());
        let head = head.text("date", log.date.as_str()).text("time", log.time.as_str()).text("unit", log.unit);
        writeln!(out, "{path}: {}", words.text(&head))?;
        for figure in &log.figures {
            writeln!(out, "    {}", told(figure))?;
        }
        for line in &log.unread {
            writeln!(out, "{path}:{line}: {}", words.key("terminal-log-unread"))?;
        }
    }
    Ok(())
}

/// `Diameter 12.0259 (12, +0.0259) [12 … 12.045]`.
fn told(figure: &ForeignFigure) -> String {
    let one = |value: Option<f64>| value.map(rounded).map(|value| value.to_string());
    let mut text = format!("{} {}", printable(&figure.name), one(figure.actual).unwrap_or_default());
    if let (Some(set), Some(by)) = (one(figure.set), figure.deviation.map(rounded)) {
        text.push_str(&format!(" ({set}, {by:+})"));
    }
    if let (Some(lower), Some(upper)) = (one(figure.lower), one(figure.upper)) {
        text.push_str(&format!(" [{lower} … {upper}]"));
    }
    text
}

/// The text of a call of such a control with these values; none: it has no cycle of this name.
pub fn write(name: &str, values: &[String]) -> Result<Option<String>, Problem> {
    let Some((control, cycle)) = foreign::find(name) else { return Ok(None) };
    if !cycle.name.eq_ignore_ascii_case(name.trim()) {
        let refused = Message::new("foreign-form").text("call", name.trim()).text("cycle", cycle.name);
        return Err(wrong(refused.text("control", control.name)));
    }
    let mut typed = Typed::new();
    for pair in values {
        let split = pair.split_once('=');
        let (name, value) = split.ok_or_else(|| wrong(Message::new("terminal-pair").text("text", pair)))?;
        if typed.insert(name.to_ascii_uppercase(), value.to_owned()).is_some() {
            return Err(wrong(Message::new("terminal-twice").text("name", name)));
        }
    }
    let refused = |why: Unwritten| match why {
        Unwritten::Unpublished(why) => why,
        Unwritten::Unknown(name) => Message::new("terminal-parameter").text("cycle", cycle.name).text("name", name),
        Unwritten::NoNumber(name) | Unwritten::Outside(name) => Message::new("foreign-outside").text("name", name),
        Unwritten::Limits(most, least) => Message::new("foreign-limits").text("maximum", most).text("minimum", least),
        Unwritten::Missing(names) => {
            Message::new("foreign-needs").text("cycle", cycle.name).text("names", names.join(", "))
        }
    };
    foreign::written(control, cycle, &typed).map(Some).map_err(|why| wrong(refused(why)))
}
