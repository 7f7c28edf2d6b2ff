//! The text of questions and answers.

#[cfg(test)]
pub(crate) mod asked;
mod shape;
#[cfg(test)]
mod tests;
mod text;

pub use crate::refused::Refused as Error;

use crate::machine::Setup;
use crate::setup_file;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

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

/// Reads a setup file.
///
/// # Errors
/// The text is no setup: why, with the place.
pub fn setup_from_json(text: &str) -> Result<Setup, Error> {
    let document = text::parse(text)?;
    shape::read(document).and_then(setup_file::setup).map_err(|refused| text::positioned(refused, text))
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
        view["line"] = line.into();
        view["column"] = column.into();
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
