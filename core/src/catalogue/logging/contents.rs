//! What CYCLE105 prints: the header (B:11451-11500), or a block of values (B:11371-11411).

use super::line::{Columns, Field, LONGEST, fields, is_printed, printed};
use super::names::{
    COLUMN, DIGITS, FIRST_PAGE, HEAD_LINES, HEADLINES, LINE, MARK, PROGRAM, SEPARATOR, TITLES, VALUE_LINES, VALUES,
};
use super::{NAMELESS, OWN_HEADER, refused};
use crate::control::Control;
use crate::diagnostic::Code;
use crate::machine::{Machine, Step, Stop};
use crate::name::Name;
use std::collections::BTreeSet;

/// Where time and page begin in the first line of the header.
const FIRST_LINE: usize = 24;
/// Highest number of a page with which a log can begin.
const LAST_PAGE: f64 = 1e9;
/// What the control prints there (B:11483).
const DATE_TIME_PAGE: [&str; 3] = ["Date: ", "Time: ", "Page: "];
const PROGRAM_NAME: &str = "Program: ";
/// Printed between the name of the cycle and the number of its variant (B:11523).
const VARIANT: &str = "_MVAR";

/// What a block of values is about.
#[derive(Clone, Debug, Default)]
pub struct Subject {
    /// Name of the cycle and number of its variant; none: no cycle has measured.
    pub call: Option<(String, i64)>,
    /// Results that exceed a limit, `_OVR[4]`.
    pub marked: BTreeSet<&'static str>,
}

fn text(control: &Control, name: Name) -> &str {
    control.text(name.as_str())
}

fn number(control: &Control, name: Name) -> f64 {
    control.number(name.as_str())
}

/// Number of the first page.
pub fn first_page(control: &Control) -> i64 {
    number(control, FIRST_PAGE).clamp(0.0, LAST_PAGE) as i64
}

/// Lines of the header of this page.
pub fn header(machine: &mut dyn Machine, page: i64) -> Vec<String> {
    let now = machine.now();
    header_of(machine.control(), &now.date(), &now.time(), page)
}

/// Lines of the header of this page at this time.
pub fn header_of(control: &Control, date: &str, time: &str, page: i64) -> Vec<String> {
    let count = number(control, HEAD_LINES).clamp(0.0, HEADLINES.len() as f64) as usize;
    let own = HEADLINES.into_iter().take(count).map(|name| text(control, name).to_owned());
    if control.bit(OWN_HEADER) {
        return own.collect();
    }
    let [date_is, time_is, number_of] = DATE_TIME_PAGE;
    let first = format!(
        "{:<FIRST_LINE$}{:<FIRST_LINE$}{number_of}{page}",
        date_is.to_owned() + date,
        time_is.to_owned() + time
    );
    let program = format!("{PROGRAM_NAME}{}", text(control, PROGRAM));
    let dashes = "-".repeat(number(control, LINE).clamp(1.0, LONGEST as f64) as usize);
    let titles = TITLES.map(|name| text(control, name).to_owned());
    let head = [first, String::new(), program, String::new()];
    head.into_iter().chain(own).chain([dashes.clone()]).chain(titles).chain([dashes]).collect()
}

/// Lines of a log before the first one of its header: what a transfer puts there.
const BEFORE_HEADER: usize = 4;

/// Whether a text is a log with the header that the cycles print by themselves.
pub fn is_log(text: &str) -> bool {
    let [date, time, page] = DATE_TIME_PAGE;
    let mut first = text.lines().take(BEFORE_HEADER + 1);
    first.any(|line| line.starts_with(date) && line.contains(time) && line.contains(page))
}

/// Refuses what cannot be printed, as CYCLE105 does at each call (A:15903-15948).
fn judge(machine: &mut dyn Machine) -> Result<(), Stop> {
    let control = machine.control();
    if TITLES.iter().chain(&VALUES).all(|name| text(control, *name).is_empty()) {
        return Err(refused(61370));
    }
    if number(control, VALUE_LINES) > VALUES.len() as f64 {
        return Err(refused(61363));
    }
    if number(control, LINE) > LONGEST as f64 {
        control.set(LINE.as_str(), LONGEST as f64);
        announce(machine, 62310);
    }
    Ok(())
}

/// An alarm behind which the program goes on.
fn announce(machine: &mut dyn Machine, number: u32) {
    machine.record(Step::Alarm(Code::Alarm(number)));
}

/// What [`layout`] tells of the blocks of values of a log.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The numbers that the columns of each line show, by their names; none: something else.
    pub lines: Vec<Vec<Option<String>>>,
    /// What stands behind a value out of tolerance (B:11356).
    pub mark: String,
    /// Decimals, as the control has them.
    decimals: f64,
}

/// A number of a log without the mark behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unmarked<'a> {
    /// It has none, or is no number.
    Plain,
    /// The number before the mark.
    Before(&'a str),
    /// Its last digit is the mark, or belongs to it: nobody can tell.
    Either,
}

impl Layout {
    /// What a cell has before its mark: the program says how many decimals are printed, and what the mark is, which may
    /// be a digit, a letter or a decimal point as well.
    pub fn unmarked<'a>(&self, cell: &'a str) -> Unmarked<'a> {
        let mark = self.mark.trim();
        let is_number = |text: &str| is_printed(text, self.decimals);
        let before = cell.strip_suffix(mark).filter(|_| !mark.is_empty()).map(str::trim_end);
        match before.filter(|before| is_number(before)) {
            Some(_) if is_number(cell) => Unmarked::Either,
            Some(before) => Unmarked::Before(before),
            None => Unmarked::Plain,
        }
    }
}

/// Lines of a block of values.
pub fn block(machine: &mut dyn Machine, subject: &Subject) -> Result<Vec<String>, Stop> {
    judge(machine)?;
    let time = machine.now().time();
    let control = machine.control();
    let titled = !text(control, TITLES[0]).is_empty();
    let columns = Columns::new(number(control, COLUMN), text(control, TITLES[0]));
    let variable = number(control, COLUMN) < 1.0;
    let separator = text(control, SEPARATOR).to_owned();
    let count = number(control, VALUE_LINES).max(0.0) as usize;
    let specified: Vec<String> = VALUES.into_iter().take(count).map(|name| text(control, name).to_owned()).collect();
    if variable && !titled {
        announce(machine, 62308);
    }
    let mut lines = Vec::new();
    if let Some((cycle, number)) = subject.call.as_ref().filter(|_| !machine.control().bit(NAMELESS)) {
        lines.push(columns.line(&[cycle.clone(), VARIANT.to_owned(), number.to_string()], &separator));
    }
    for line in &specified {
        lines.push(values(machine, line, &columns, &separator, subject, &time)?);
    }
    Ok(lines)
}

/// What the blocks of values show, and how.
pub fn layout(control: &Control) -> Layout {
    let count = number(control, VALUE_LINES).max(0.0) as usize;
    let specified = VALUES.into_iter().take(count).map(|name| text(control, name)).filter(|line| !line.is_empty());
    let shown = |field| if let Field::Number(name) = field { Some(name.to_ascii_uppercase()) } else { None };
    let lines = specified.map(|line| fields(line).map(shown).collect()).collect();
    Layout { lines, mark: text(control, MARK).to_owned(), decimals: number(control, DIGITS) }
}

/// A line of values in their columns.
fn values(
    machine: &mut dyn Machine,
    line: &str,
    columns: &Columns,
    separator: &str,
    subject: &Subject,
    time: &str,
) -> Result<String, Stop> {
    if line.is_empty() {
        return Ok(String::new());
    }
    let total = columns.total(line);
    if total > LONGEST {
        return Err(refused(61371));
    }
    let control = machine.control();
    let Some(texts) = texts(control, line, &subject.marked, time) else { return Err(refused(61361)) };
    if texts.iter().enumerate().any(|(column, text)| columns.narrow(column, text)) {
        announce(machine, 62309);
    }
    let whole = columns.line(&texts, separator);
    fit(machine, total, whole.chars().count())?;
    Ok(whole)
}

/// What the fields of a line print, with the mark behind results that exceed a limit; none: one cannot be printed.
pub fn texts(control: &Control, line: &str, marked: &BTreeSet<&str>, time: &str) -> Option<Vec<String>> {
    let mark = text(control, MARK);
    let shown = |field| {
        let text = printed(field, control, time)?;
        let beyond = matches!(field, Field::Number(name) if marked.contains(&*name.to_ascii_uppercase()));
        Some(if beyond { text + mark } else { text })
    };
    fields(line).map(shown).collect()
}

/// Holds a line against `_PROTFORM[1]`: columns that are too many for it are reported (A:15944); where only a value
/// that is wider than its column makes the line longer, the number is adapted (B:11437, A:15948).
fn fit(machine: &mut dyn Machine, columns: usize, length: usize) -> Result<(), Stop> {
    let most = number(machine.control(), LINE);
    if length > LONGEST {
        return Err(refused(61371));
    }
    if columns as f64 > most {
        announce(machine, 62307);
    } else if length as f64 > most {
        machine.control().set(LINE.as_str(), length as f64);
        announce(machine, 62311);
    }
    Ok(())
}
