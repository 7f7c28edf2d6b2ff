//! Questions and answers as JSON, the setup file, and a trace as it is drawn.

#[cfg(test)]
pub(crate) mod asked;
mod setup;
mod setup_active;
mod setup_frame;
mod setup_solid;
mod setup_surface;
mod setup_tool;
mod setup_write;
mod shape;
#[cfg(test)]
mod tests;
mod text;
mod trace;
mod trace_tool;
mod trace_turned;

pub use crate::refused::Refused as Error;
#[cfg(feature = "cli")]
pub use setup::schema as setup_schema;
pub use setup::{SetupFile, from_json as setup_from_json, setup};
pub(crate) use setup_surface::example as example_surface;
pub use setup_write::to_json as setup_to_json;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// Answers a question.
///
/// # Errors
/// It is no JSON, or not of its shape, or has no answer.
pub fn answer<Q: DeserializeOwned, A: Serialize>(
    question: &str,
    ask: impl FnOnce(Q) -> Result<A, Error>,
) -> Result<String, Error> {
    Ok(text(&ask(self::question(question)?)?))
}

/// A question. Its shape is read from the parsed document: one reading code for all of them keeps the page's module
/// small.
///
/// # Errors
/// It is no JSON, or not of its shape.
pub fn question<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    shape::read(text::parse(text)?)
}

/// An answer. A number that is not finite becomes null, as JSON has none.
pub fn text<T: Serialize>(answer: &T) -> String {
    serde_json::to_string(answer).unwrap_or_default() // only maps with keys that are no texts fail
}

/// An answer as a document.
pub fn document<T: Serialize>(answer: &T) -> Value {
    serde_json::to_value(answer).unwrap_or_default()
}

/// Why a document is refused, with its line and column where its text is known.
pub fn refused(error: &Error) -> Value {
    let mut view = document(&error.message);
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
