//! The text of questions and answers.

#[cfg(test)]
pub(crate) mod asked;
mod shape;
#[cfg(test)]
mod tests;
mod text;

pub use crate::refused::Refused as Error;
pub use text::positioned;

use crate::machine::Setup;
use crate::message::Message;
use crate::setup_file;
use serde::de::DeserializeOwned;
use serde::{Serialize, Serializer};
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
    setup_file::setup(file(text)?).map_err(|refused| positioned(refused, text))
}

/// Reads a file that a user wrote.
///
/// # Errors
/// It is no JSON, or not of its shape: why, with the place.
pub fn file<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    question(text).map_err(|refused| positioned(refused, text))
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
#[derive(Serialize)]
struct Told<'a> {
    #[serde(flatten)]
    message: &'a Message,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
}

impl Serialize for Error {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let (line, column) = self.position.unzip();
        Told { message: &self.message, line, column }.serialize(to)
    }
}

/// As whoever knows a language takes it: its message as JSON.
impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&text(self))
    }
}

impl std::error::Error for Error {}
