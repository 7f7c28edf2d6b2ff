//! Questions and answers as documents, for tests.
#![allow(clippy::unwrap_used)]

use super::{Error, answer, question};
use crate::app;
use serde_json::Value;

fn parsed(answer: Result<String, Error>) -> Result<Value, Error> {
    answer.map(|text| serde_json::from_str(&text).unwrap())
}

pub(crate) fn form(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::form))
}

pub(crate) fn read(request: &str) -> Result<Value, Error> {
    parsed(answer(request, |asked| app::read(asked, &mut |_| {})))
}

pub(crate) fn change(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::change))
}

pub(crate) fn convert(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::convert))
}

pub(crate) fn help(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::help))
}

pub(crate) fn machine(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::machine))
}

pub(crate) fn equip(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::equip))
}

pub(crate) fn story(request: &str) -> Result<Value, Error> {
    parsed(answer(request, app::story))
}

pub(crate) fn catalogue() -> Value {
    super::document(&app::catalogue())
}

/// What a whole run of a program does.
pub(crate) fn run(request: &str) -> Result<Value, Error> {
    let mut run = app::Run::new(question(request)?)?;
    while !run.advance(100) {}
    Ok(super::document(&run.view()))
}
