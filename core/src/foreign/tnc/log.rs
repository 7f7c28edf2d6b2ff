//! The log of a measuring cycle: set values, limits, actual values and deviations, each a group of lines
//! (TNC7, 81762x-19, recording the results of measurement: log of cycle 421).

use super::super::{Log, LogRow, figure, line_end};

/// How a log begins.
const BEGIN: &str = "measuring log for touch probe cycle";
/// Lines of a text among which the first of a log is looked for.
const HEAD: usize = 20;
/// Rows of a log at most; more is another file.
const MOST: usize = 1000;

/// A group of lines.
#[derive(Clone, Copy, PartialEq)]
enum Group {
    Head,
    Nominal,
    Limits,
    Actual,
    Deviations,
}

const GROUPS: [(&str, Group); 4] = [
    ("nominal values", Group::Nominal),
    ("given limit values", Group::Limits),
    ("actual values", Group::Actual),
    ("deviations", Group::Deviations),
];

/// Whether a text begins as a log.
pub fn is_log(text: &str) -> bool {
    lines(text).take(HEAD).any(|line| begun(line.trim_start_matches('\u{feff}').trim()).is_some())
}

fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split(char::from(line_end(text.as_bytes())))
}

/// The logs of a text, in their order.
pub fn logs(text: &str) -> Vec<Log> {
    let mut found: Vec<Log> = Vec::new();
    let mut group = Group::Head;
    let mut waiting: Option<String> = None;
    for (line, number) in lines(text).zip(1..) {
        let line = line.trim_start_matches('\u{feff}').trim();
        if let Some(cycle) = begun(line) {
            found.push(cycle);
            (group, waiting) = (Group::Head, None);
            continue;
        }
        let Some(log) = found.last_mut().filter(|_| !line.is_empty()) else { continue };
        // a value that stands alone belongs to the label above it
        if let Some(label) = waiting.take().filter(|_| is_figure(line) || group == Group::Head) {
            put(log, group, &label, line, number);
            continue;
        }
        let Some((label, value)) = line.split_once(": ").or_else(|| Some((line.strip_suffix(':')?, ""))) else {
            continue;
        };
        let (label, value) = (label.trim(), value.trim());
        match GROUPS.iter().find(|(name, _)| label.eq_ignore_ascii_case(name)) {
            Some((_, next)) if value.is_empty() => group = *next,
            _ if value.is_empty() => waiting = Some(label.to_owned()),
            _ => put(log, group, label, value, number),
        }
    }
    found.retain(|log| !log.rows.is_empty());
    found
}

/// The first line of a log, with the number of the cycle.
fn begun(line: &str) -> Option<Log> {
    let head = line.get(..BEGIN.len()).filter(|head| head.eq_ignore_ascii_case(BEGIN))?;
    let number = line.get(head.len()..)?.split_whitespace().next()?;
    let cycle = format!("TCH PROBE {number}");
    let none = String::new;
    Some(Log {
        cycle,
        date: none(),
        time: none(),
        program: none(),
        is_inch: false,
        rows: Vec::new(),
        unread: Vec::new(),
    })
}

fn is_figure(text: &str) -> bool {
    figure(text).is_some()
}

/// What a line says.
fn put(log: &mut Log, group: Group, label: &str, value: &str, line: u32) {
    if group == Group::Head {
        match label.to_ascii_lowercase().as_str() {
            "date" => log.date = value.to_owned(),
            "time" => log.time = value.to_owned(),
            "measuring program" => log.program = value.to_owned(),
            name if name.starts_with("type of dimension") => log.is_inch = value == "1",
            _ => {}
        }
        return;
    }
    if !is_figure(value) {
        return log.unread.push(line);
    }
    if log.rows.len() >= MOST {
        return;
    }
    if group == Group::Limits {
        limit(log, &label.to_ascii_lowercase(), value);
        return;
    }
    let known = log.rows.iter().position(|row| row.label.eq_ignore_ascii_case(label));
    let at = known.unwrap_or_else(|| {
        log.rows.push(LogRow { label: label.to_owned(), ..LogRow::default() });
        log.rows.len() - 1
    });
    let Some(row) = log.rows.get_mut(at) else { return };
    match group {
        Group::Nominal => row.nominal = value.to_owned(),
        Group::Actual => (row.actual, row.line) = (value.to_owned(), line),
        _ => row.deviation = value.to_owned(),
    }
}

/// “Maximum limit for” a quantity, or “Maximum dimension for” what is measured: its size, the last quantity.
fn limit(log: &mut Log, label: &str, value: &str) {
    let of = |row: &LogRow| label.ends_with(&row.label.to_ascii_lowercase());
    let at = match log.rows.iter().position(of) {
        Some(at) => at,
        None if label.contains(" dimension ") => log.rows.len().saturating_sub(1),
        None => return,
    };
    let Some(row) = log.rows.get_mut(at) else { return };
    if label.starts_with("max") {
        row.maximum = value.to_owned();
    } else {
        row.minimum = value.to_owned();
    }
}
