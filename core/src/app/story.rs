//! A measurement that corrects, and the same measurement once more: what a newcomer is shown.

use super::Error;
use super::form::{FormRequest, form};
use crate::check::expression::shown;
use serde::Serialize;

/// The program of a story.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Story {
    /// Its text; empty where the call corrects no zero offset.
    pub text: String,
}

/// A call that corrects a zero offset, twice: between them the program activates the corrected offset and goes straight
/// back to where the call starts, which is free in a hole.
///
/// # Errors
/// An unknown cycle, or a machine that cannot be.
pub fn story(asked: FormRequest) -> Result<Story, Error> {
    let view = form(FormRequest { predict: true, ..asked })?;
    let answer = view.outcome.as_ref().and_then(|outcome| outcome.answer.as_ref());
    let mut frames = answer.iter().flat_map(|answer| &answer.corrected).filter_map(|one| one.target.word("frame"));
    let frame = frames.find(|name| name.starts_with('G'));
    let (Some(frame), Some(setup)) = (frame, &view.setup) else { return Ok(Story { text: String::new() }) };
    let [x, y, z] = setup.control.to_workpiece(setup.position).0.map(shown);
    let call = view.snippet.trim_end();
    Ok(Story { text: format!("{frame}\n{call}\n{frame}\nG0 X{x} Y{y} Z{z}\n{call}\nM30\n") })
}
