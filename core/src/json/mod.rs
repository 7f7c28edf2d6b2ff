//! The one place that knows JSON: what the terminal prints and the page asks. The shapes are those of `www/src/wire.ts`.
//! Every function takes and gives whole documents; a wrong document is an [`Error`], never a panic.

mod catalogue;
mod changes;
mod form;
mod program;
mod setup;
#[cfg(test)]
mod tests;
mod trace;

pub use catalogue::cycles;
pub use form::form;
pub use program::{calls, change, read, run, run_outcome};
#[cfg(feature = "cli")]
pub use setup::schema as setup_schema;
pub use setup::{from_json as setup_from_json, to_json as setup_to_json};
pub use trace::{alarm_key, outcome};

use crate::catalogue::{Dialect, Style};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::message::{Arg, Message};
use serde_json::{Map, Value, json};

/// Why a document is refused.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No JSON, or not of the shape that is asked for.
    #[error("not the expected JSON: {0}")]
    Shape(#[from] serde_json::Error),
    /// A name that the catalogue does not have.
    #[error("unknown {what}: {name}")]
    Unknown {
        /// Kind of thing.
        what: &'static str,
        /// As given.
        name: String,
    },
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
        _ => Err(Error::Unknown {
            what: "control",
            name: name.to_owned(),
        }),
    }
}

/// Ways of writing by their name on the wire.
const STYLES: [(&str, Style); 3] = [
    ("direct", Style::Direct),
    ("indirect", Style::Indirect),
    ("operate", Style::Operate),
];

/// The way of writing with this name.
pub fn style(name: &str) -> Result<Style, Error> {
    let known = STYLES.iter().find(|(known, _)| *known == name);
    known
        .map(|(_, style)| *style)
        .ok_or_else(|| Error::Unknown {
            what: "style",
            name: name.to_owned(),
        })
}

/// Name of a way of writing.
pub fn style_name(style: Style) -> &'static str {
    let known = STYLES.iter().find(|(_, known)| *known == style);
    known.map_or("direct", |(name, _)| name)
}

/// A number; JSON has no NaN and no infinity, they become null.
fn number(value: f64) -> Value {
    json!(value)
}

fn message(message: &Message) -> Value {
    let args: Map<String, Value> = message
        .args
        .iter()
        .map(|(name, arg)| {
            let value = match arg {
                Arg::Number(value) => number(*value),
                Arg::Text(text) => json!(text),
            };
            ((*name).to_owned(), value)
        })
        .collect();
    json!({ "key": message.key.as_ref(), "args": args })
}

fn key(key: &'static str) -> Value {
    json!({ "key": key, "args": {} })
}

/// `61307`, `FORMAT ERROR`, `PW012`.
pub fn code(code: Code) -> String {
    match code {
        Code::Alarm(number) => number.to_string(),
        Code::Nct(text) => text.to_owned(),
        Code::Own(number) => format!("PW{number:03}"),
    }
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

fn diagnostic(found: &Diagnostic) -> Value {
    let mut object = Map::new();
    object.insert("severity".into(), json!(severity(found.severity)));
    object.insert("code".into(), json!(code(found.code)));
    object.insert("message".into(), message(&found.message));
    if let Some(hint) = &found.hint {
        object.insert("hint".into(), message(hint));
    }
    if let Some(param) = found.param {
        object.insert("param".into(), json!(param));
    }
    Value::Object(object)
}
