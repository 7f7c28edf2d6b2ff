//! The one place that knows JSON: what the terminal prints and the page asks. The shapes are those of
//! `www/src/wire.ts`.
//! Every function takes and gives whole documents; a wrong document is an [`Error`], never a panic.

mod alarms;
mod catalogue;
mod changes;
mod encoding;
mod form;
mod help;
mod machine;
mod predict;
mod program;
mod scan;
mod setup;
mod setup_active;
mod setup_frame;
mod setup_solid;
mod setup_surface;
mod setup_tool;
mod setup_write;
mod shape;
mod start;
#[cfg(test)]
mod tests;
mod text;
mod trace;
mod trace_tool;
mod trace_turned;
mod twin;

pub use crate::refused::Refused as Error;
pub use alarms::{alarm, alarms, operator_message};
pub use catalogue::{catalogue, cycles};
pub use encoding::recognised;
pub use form::{form, form_seen};
pub use help::help;
pub use machine::machine;
pub use program::{Run, assumed, calls, change, convert, diagnostics, read, read_told, run_outcome};
pub use scan::{Scan, SurfaceName, put_surface};
pub use setup::from_json as setup_from_json;
#[cfg(feature = "cli")]
pub use setup::schema as setup_schema;
pub use setup_write::to_json as setup_to_json;
pub use trace::outcome;

use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::entry::{Cycle, Style};
use crate::message::{Arg, Message};
use crate::name::Name;
use crate::refused::Path;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// A document as text. (Its `to_string` gives the same by way of a formatter, for a third of the time of a keystroke.)
pub fn text(document: &Value) -> String {
    serde_json::to_string(document).unwrap_or_default() // only maps with keys that are no texts fail
}

/// Name of a dialect on the wire.
pub fn dialect_name(dialect: Dialect) -> &'static str {
    match dialect {
        Dialect::Sinumerik => "sinumerik",
        Dialect::Nct => "nct",
    }
}

/// The dialect with this name.
pub fn dialect(name: &str) -> Result<Dialect, Error> {
    match name {
        "sinumerik" => Ok(Dialect::Sinumerik),
        "nct" => Ok(Dialect::Nct),
        _ => Err(unknown("document-control", name)),
    }
}

/// The cycle of a control with this name.
fn cycle(dialect: Dialect, name: &str) -> Result<&'static Cycle, Error> {
    crate::catalogue::find(dialect, name).ok_or_else(|| unknown("document-cycle", name))
}

/// Ways of writing by their name on the wire.
const STYLES: [(&str, Style); 3] =
    [("direct", Style::Direct), ("indirect", Style::Indirect), ("operate", Style::Operate)];

/// The way of writing with this name.
pub fn style(name: &str) -> Result<Style, Error> {
    let known = STYLES.iter().find(|(known, _)| *known == name);
    known.map(|(_, style)| *style).ok_or_else(|| unknown("document-style", name))
}

/// Name of a way of writing.
pub fn style_name(style: Style) -> &'static str {
    let known = STYLES.iter().find(|(_, known)| *known == style);
    known.map_or("direct", |(name, _)| name)
}

/// A name that nothing has.
fn unknown(key: &'static str, name: &str) -> Error {
    Error::new(key, Path::default()).text("name", name)
}

/// Why a document is refused, with its line and column where its text is known.
pub fn refused(error: &Error) -> Value {
    let mut view = message(&error.message);
    if let Some((line, column)) = error.position {
        put(&mut view, "line", line);
        put(&mut view, "column", column);
    }
    view
}

/// As whoever knows a language takes it: its message as JSON.
impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&text(&refused(self)))
    }
}

impl std::error::Error for Error {}

/// Reads a document that the page sent. The shape is read from the parsed document, as the machine in it is: one
/// reading code for both keeps the page's module small.
fn request<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    shape::read(text::parse(text)?)
}

/// An object of these members. A number that is not finite becomes null, as JSON has none.
fn object<'a>(members: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    let mut object = Map::new();
    for (name, value) in members {
        object.insert(name.to_owned(), value);
    }
    Value::Object(object)
}

/// Adds a member to an object.
fn put(object: &mut Value, name: &str, value: impl Into<Value>) {
    object[name] = value.into();
}

/// Values as typed.
fn typed(values: &Typed) -> Value {
    object(values.iter().map(|(name, value)| (name.as_str(), value.as_str().into())))
}

fn message(message: &Message) -> Value {
    let value = |arg: &Arg| match arg {
        Arg::Number(value) => Value::from(*value),
        Arg::Text(text) => Value::from(text.as_str()),
    };
    let args = message.args.iter().map(|(name, arg)| (*name, value(arg)));
    object([("key", message.key.as_ref().into()), ("args", object(args))])
}

fn key(key: &'static str) -> Value {
    object([("key", key.into()), ("args", object([]))])
}

/// `61307`, `FORMAT ERROR`, `PW012`.
pub fn code(code: Code) -> String {
    code.to_string()
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

fn diagnostic(found: &Diagnostic) -> Value {
    let mut view = object([
        ("severity", severity(found.severity).into()),
        ("code", code(found.code).into()),
        ("message", message(&found.message)),
    ]);
    if let Some(hint) = &found.hint {
        put(&mut view, "hint", message(hint));
    }
    if let Some(param) = found.param {
        put(&mut view, "param", param);
    }
    view
}

impl From<Name> for Value {
    fn from(name: Name) -> Value {
        name.as_str().into()
    }
}
