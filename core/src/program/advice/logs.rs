//! Logs that delete each other: the log is switched on twice with the same file name, and the control makes the file
//! anew (B:11229).

use super::Seen;
use crate::catalogue::{log, log_switches};
use crate::diagnostic::Diagnostic;
use crate::machine::files::named;
use crate::message::Message;
use crate::own;
use crate::program::change::change;
use crate::syntax::links::Links;
use std::collections::BTreeMap;

/// Names that are tried for another file.
const MOST: u32 = 1000;

/// Logs so far: by the file the line, from 0, of the call that switched it on last.
pub type Logs = BTreeMap<String, u32>;

/// Looks whether a call begins a log whose file was begun before, without a branch or a loop between them.
pub fn look(seen: &Seen, links: &Links, logs: &mut Logs) -> Option<Diagnostic> {
    let site = seen.site;
    if site.cycle.name != log_switches()[0] {
        return None;
    }
    let file = log::FILE.as_str();
    let written = seen.values.get(file)?.trim_matches('"');
    let name = named(written).ok()?;
    let first = logs.insert(name, site.line).filter(|first| *first < site.line)?;
    let same = seen.programs.of_line(first) == seen.programs.of_line(site.line);
    if !same || links.range(first as usize..site.line as usize).next().is_some() {
        return None;
    }
    let finding = own::ADVICE_LOG_AGAIN.finding().text("file", written).number("line", f64::from(first + 1));
    let finding = finding.hint_text("name", file).at(log::FILE).on(site.span);
    let stem = written.trim_end_matches(|one: char| one.is_ascii_digit());
    let stem = if stem.len() == written.len() { format!("{written}_") } else { stem.to_owned() };
    let free = |name: &String| named(name).is_ok_and(|name| !logs.contains_key(&name));
    let Some(other) = (2..MOST).map(|number| format!("{stem}{number}")).find(free) else { return Some(finding) };
    let edits = change(seen.program, site, file, &other);
    let label = Message::new("advice-write").text("name", file).text("value", format!("\"{other}\""));
    Some(finding.cured(label, edits))
}
