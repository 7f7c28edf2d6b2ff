//! Controls of other makers whose probe cycles are read, explained and written: a table a control, a folder each. No
//! program of theirs is run here, so that they are no [`crate::dialect::Dialect`].

pub mod findings;
mod log;
mod of_task;
pub mod tnc;
mod write;

pub use log::{Log, LogRow, figure};
pub use of_task::{OfTask, of_task};
pub use write::{Unwritten, written};

use crate::diagnostic::Span;
use crate::entry::Task;
use crate::message::Message;
use crate::range::Range;
use std::borrow::Cow;

/// A control of another maker.
pub struct Foreign {
    /// Its name, the same in every language.
    pub name: &'static str,
    /// Its probe cycles.
    pub cycles: &'static [ForeignCycle],
    /// Where its results are, whatever the cycle; key of a message.
    pub results: &'static str,
    /// What of it is not published; key of a message.
    pub unpublished: &'static str,
    /// A cycle by a name that a program calls it.
    pub named: fn(&str) -> Option<&'static ForeignCycle>,
    /// Whether a text is a program of it.
    pub is_program: fn(&[u8]) -> bool,
    /// The probe cycles in such a text, in their order.
    pub calls: fn(&[u8]) -> Vec<ForeignCall>,
    /// The values that a line of a call gives.
    pub values: fn(&[u8]) -> Vec<ForeignValue>,
    /// Whether a text begins as a log of it.
    pub is_log: fn(&str) -> bool,
    /// Its logs in a text.
    pub logs: fn(&str) -> Vec<Log>,
    /// A call with these values, in the order of the table.
    pub call: fn(&ForeignCycle, &[(&Parameter, f64)]) -> String,
}

/// The controls.
pub static CONTROLS: [&Foreign; 1] = [&tnc::CONTROL];

/// A probe cycle of such a control.
pub struct ForeignCycle {
    /// Name of the call.
    pub name: &'static str,
    /// What the control writes behind it.
    pub text: &'static str,
    /// Stem of its messages.
    pub key: &'static str,
    /// Where its parameters are published; empty: nowhere.
    pub source: &'static str,
    /// What is published of it.
    pub page: Page,
    /// What it does.
    pub tasks: &'static [(Task, Aim)],
    /// Its parameters, in their order.
    pub parameters: &'static [Parameter],
}

/// What is published of a cycle. Only one with a whole page is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// A page has every value.
    Whole,
    /// A page has every value but these.
    Without(&'static [&'static str]),
    /// No page: a post processor tells the order.
    Order,
    /// Its name and what it does alone.
    Nothing,
}

/// What comes of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// A deviation, also as a correction of a tool.
    Measure,
    /// A datum.
    Datum,
}

/// A parameter of such a cycle.
#[derive(Clone, Copy)]
pub struct Parameter {
    /// Its name in a program.
    pub name: &'static str,
    /// What the control writes behind its value.
    pub text: &'static str,
    /// Key of what it means.
    pub key: &'static str,
    /// Its values, as published.
    pub range: Range,
    /// What it says.
    pub value: Value,
    /// Whether some versions of the control do not have it.
    pub optional: bool,
}

impl Parameter {
    /// Whether the control takes this number: within the limits, and a whole one where it is an axis, a direction or a
    /// selection. The direction is 1 or -1, and 0 is none.
    pub fn takes(&self, number: f64) -> bool {
        let selects = self.range.max - self.range.min < FEW;
        let whole = number.fract() == 0.0 || !(selects || matches!(self.value, Value::Axis | Value::Direction));
        self.range.contains(number) && whole && (self.value != Value::Direction || number != 0.0)
    }
}

/// Between limits that are nearer to each other a parameter selects.
const FEW: f64 = 4.0;

/// What a parameter says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Centre of what is measured, along the first (0) or second (1) axis of the plane.
    Centre(usize),
    /// Touching point along an axis of the plane.
    Point(usize),
    /// Set value: the size, of a rectangle the length along the first (0) or second (1) axis of the plane.
    Nominal(usize),
    /// Largest permissible value of that; 0: no limit.
    Maximum(usize),
    /// Smallest permissible value of that; 0: no limit.
    Minimum(usize),
    /// Axis along which is measured: 1, 2, or 3 for that of the probe.
    Axis,
    /// Direction of measuring: 1 or -1.
    Direction,
    /// Height of the ball's centre while measuring.
    Height,
    /// Height at which nothing is in the way.
    Clearance,
    /// Tool that is corrected; 0: none.
    Tool,
    /// What has no counterpart, and what is usual.
    Usual(f64),
    /// What has neither.
    Own,
}

/// A call in a program of such a control.
#[derive(Clone)]
pub struct ForeignCall {
    /// Its cycle; none: no table has it.
    pub cycle: Option<&'static ForeignCycle>,
    /// As the program calls it.
    pub name: String,
    /// Line of the call, from 0.
    pub line: u32,
    /// Place of its name.
    pub span: Span,
    /// Its values, in the order of the text.
    pub values: Vec<ForeignValue>,
}

/// A value of such a call.
#[derive(Clone)]
pub struct ForeignValue {
    /// Name of the parameter.
    pub name: String,
    /// Place of the name.
    pub name_span: Span,
    /// As written.
    pub text: String,
    /// Place of name and value.
    pub span: Span,
}

impl Value {
    /// Whether it is a length of the measurement.
    pub fn is_length(self) -> bool {
        !matches!(self, Value::Axis | Value::Direction | Value::Tool | Value::Usual(_) | Value::Own)
    }
}

impl ForeignCycle {
    /// A parameter by its name.
    pub fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.parameters.iter().find(|one| one.name.eq_ignore_ascii_case(name))
    }

    /// Largest and smallest permissible value of each size that has both.
    fn limits(&self) -> impl Iterator<Item = (&'static Parameter, &'static Parameter)> {
        self.parameters.windows(2).filter_map(|pair| match pair {
            [most, least] => {
                let both = matches!((most.value, least.value), (Value::Maximum(_), Value::Minimum(_)));
                both.then_some((most, least))
            }
            _ => None,
        })
    }

    /// Whether calls are written.
    pub fn is_written(&self) -> bool {
        self.page == Page::Whole
    }

    /// Whether a published page of the cycle has this parameter.
    fn has_on_page(&self, name: &str) -> bool {
        match self.page {
            Page::Whole => self.parameter(name).is_some(),
            Page::Without(lacking) => self.parameter(name).is_some() && !lacking.contains(&name),
            Page::Order | Page::Nothing => false,
        }
    }

    /// Why calls are not written. A parameter has one meaning in all cycles, so that any page tells its values.
    pub fn unwritten(&self, control: &Foreign) -> Option<Message> {
        let on_no_page = |one: &&Parameter| !control.cycles.iter().any(|cycle| cycle.has_on_page(one.name));
        let unknown: Vec<&str> = self.parameters.iter().filter(on_no_page).map(|one| one.name).collect();
        let (key, names) = match self.page {
            Page::Whole => return None,
            Page::Without(lacking) => ("foreign-unwritten-lacks", lacking),
            Page::Order if unknown.is_empty() => ("foreign-unwritten-order", &[][..]),
            Page::Order => ("foreign-unwritten-values", &unknown[..]),
            Page::Nothing => ("foreign-unwritten-nothing", &[][..]),
        };
        let why = Message::new(key).text("cycle", self.name);
        Some(if names.is_empty() { why } else { why.text("names", names.join(", ")) })
    }

    /// Key of what it does.
    pub fn title(&self) -> String {
        format!("{}-title", self.key)
    }
}

impl ForeignValue {
    /// The value, where it is a number.
    pub fn number(&self) -> Option<f64> {
        self.text.trim().parse().ok().filter(|value: &f64| value.is_finite())
    }

    /// Whether it is neither a number nor what the control has in its place: another parameter (`Q1`, `-QL5`), a word
    /// of its own (`PREDEF`, `MAX`, `AUTO`).
    pub fn is_nothing(&self) -> bool {
        let text = self.text.trim().trim_start_matches(['+', '-']).to_ascii_uppercase();
        let parameter = text.strip_prefix('Q').is_some_and(|rest| {
            let digits = rest.strip_prefix(['L', 'R', 'S']).unwrap_or(rest);
            !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
        });
        self.number().is_none() && !parameter && !["PREDEF", "MAX", "AUTO", "FMAX", "FAUTO"].contains(&&*text)
    }
}

/// What ends the lines of a text: a carriage return where nothing else does.
pub fn line_end(source: &[u8]) -> u8 {
    if source.contains(&b'\n') { b'\n' } else { b'\r' }
}

/// The control of a program, where it is none of those that are run.
pub fn control_of(source: &[u8]) -> Option<&'static Foreign> {
    CONTROLS.into_iter().find(|control| (control.is_program)(source))
}

/// Bytes at the beginning of a text by which a log is told.
const HEAD: usize = 4096;

/// The control of which a text is a log, by its beginning.
pub fn log_of(source: &[u8]) -> Option<&'static Foreign> {
    let head = beginning(source);
    CONTROLS.into_iter().find(|control| (control.is_log)(&head))
}

/// The beginning of a text.
pub fn beginning(source: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(source.get(..HEAD).unwrap_or(source))
}

/// Place of the first line of a program.
pub fn first_line(source: &[u8]) -> Span {
    let line_end = line_end(source);
    let end = source.iter().position(|byte| *byte == line_end).unwrap_or(source.len());
    Span { start: 0, end: u32::try_from(end).unwrap_or(u32::MAX) }
}

/// The logs of such a control in a text.
pub fn logs(text: &str) -> Option<(&'static Foreign, Vec<Log>)> {
    CONTROLS.into_iter().map(|control| (control, (control.logs)(text))).find(|(_, logs)| !logs.is_empty())
}

/// The parameter whose value a line gives at a byte.
pub fn parameter_at(line: &[u8], at: u32) -> Option<(&'static Foreign, &'static Parameter, Span)> {
    CONTROLS.into_iter().find_map(|control| {
        let one = (control.values)(line).into_iter().find(|one| one.span.start <= at && at <= one.span.end)?;
        let parameter = control.cycles.iter().find_map(|cycle| cycle.parameter(&one.name))?;
        Some((control, parameter, one.span))
    })
}

/// A cycle by a name that a program calls it.
pub fn find(name: &str) -> Option<(&'static Foreign, &'static ForeignCycle)> {
    CONTROLS.into_iter().find_map(|control| Some((control, (control.named)(name.trim())?)))
}

#[cfg(test)]
mod tests;
