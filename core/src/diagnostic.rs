//! What is wrong, where, and how to fix it.

use crate::message::Message;
use crate::name::Name;
use serde::{Serialize, Serializer};
use std::fmt;
use std::ops::Deref;

/// Half-open byte range of a program's source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// Whether another place begins in it.
    pub fn holds(self, place: Span) -> bool {
        self.start <= place.start && place.start < self.end
    }
}

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Severity {
    /// The control would stop, or the result would be wrong.
    Error,
    /// A colleague would ask.
    Warning,
    /// Good to know.
    Note,
}

/// Where a problem is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "String"))]
pub enum Code {
    /// Alarm of the SINUMERIK measuring cycles, 61000..62999 (61xxx stops, 62xxx informs).
    Alarm(u32),
    /// Error or operator message of the NCT macros, in the manual's words, for example `FORMAT ERROR`.
    Nct(&'static str),
    /// Our own code, shown as `PW012`.
    Own(u16),
}

/// `61307`, `FORMAT ERROR`, `PW012`.
impl fmt::Display for Code {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Code::Alarm(number) => write!(to, "{number}"),
            Code::Nct(text) => to.write_str(text),
            Code::Own(number) => write!(to, "PW{number:03}"),
        }
    }
}

impl Serialize for Code {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

/// One finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How bad.
    pub severity: Severity,
    /// Name of the finding.
    pub code: Code,
    /// Cause.
    pub message: Message,
    /// Cure.
    pub hint: Option<Message>,
    /// Parameter it belongs to, as the manual writes it (`_SETV[0]`).
    pub param: Option<Name>,
    /// Place in the program.
    pub span: Option<Span>,
    /// Edits of the program that fix it, with what they do in words.
    pub cure: Option<Cure>,
}

impl Diagnostic {
    /// A finding without hint and place.
    pub fn new(severity: Severity, code: Code, message: Message) -> Self {
        Self { severity, code, message, hint: None, param: None, span: None, cure: None }
    }

    /// With what helps.
    pub fn hint(self, hint: Message) -> Self {
        Self { hint: Some(hint), ..self }
    }

    /// At this place of the program.
    pub fn on(self, span: Span) -> Self {
        Self { span: Some(span), ..self }
    }

    /// With one click that fixes it, where there is anything to edit.
    pub fn cured(self, label: Message, edits: Vec<Edit>) -> Self {
        Self { cure: (!edits.is_empty()).then_some(Cure { label, edits }), ..self }
    }

    /// At this parameter.
    pub fn at(self, param: Name) -> Self {
        Self { param: Some(param), ..self }
    }

    /// Under this number instead, where the control has one of its own.
    pub fn under(self, code: Code) -> Self {
        Self { code, ..self }
    }

    /// The cause with a number.
    pub fn number(self, name: &'static str, value: f64) -> Self {
        Self { message: self.message.number(name, value), ..self }
    }

    /// The cause with a text.
    pub fn text(self, name: &'static str, value: impl Into<String>) -> Self {
        Self { message: self.message.text(name, value), ..self }
    }

    /// The cause with several texts, of which none is left out.
    pub fn texts(self, name: &'static str, all: &[impl Deref<Target = str>]) -> Self {
        Self { message: self.message.texts(name, all), ..self }
    }

    /// The hint with a number.
    pub fn hint_number(self, name: &'static str, value: f64) -> Self {
        Self { hint: self.hint.map(|hint| hint.number(name, value)), ..self }
    }

    /// The hint with a text.
    pub fn hint_text(self, name: &'static str, value: impl Into<String>) -> Self {
        Self { hint: self.hint.map(|hint| hint.text(name, value)), ..self }
    }
}

/// Edits that fix a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Cure {
    /// What they do.
    pub label: Message,
    /// Only these places change.
    pub edits: Vec<Edit>,
}

/// Replace a place by a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What goes; empty to insert only.
    pub span: Span,
    /// What comes.
    pub insert: String,
}

impl Edit {
    /// This text instead of what stands at a place.
    pub fn replace(span: Span, text: impl Into<String>) -> Edit {
        Edit { span, insert: text.into() }
    }

    /// A text before this byte.
    pub fn insert(at: u32, text: impl Into<String>) -> Edit {
        Edit::replace(Span { start: at, end: at }, text)
    }

    /// Nothing from one byte to another one.
    pub fn remove(start: u32, end: u32) -> Edit {
        Edit::replace(Span { start, end }, "")
    }
}
