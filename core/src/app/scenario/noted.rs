//! A scenario made of a run: what came of it is what must come of it from now on.

use super::file::{Expected, ExpectedCall, Scenario, ScenarioCase, ScenarioText};
use super::held::cause;
use crate::app::Error;
use crate::app::run::RunRequest;
use crate::app::start::start;
use crate::control::Value;
use crate::run::Outcome;
use crate::run::left::Left;
use crate::setup_file::SetupFile;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A run of which a scenario is made.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct NoteRequest {
    /// What is run.
    pub run: RunRequest,
    /// Name of the file with the program.
    pub name: String,
    /// What the case is called.
    pub case: String,
}

/// Runs a program and notes what comes of it.
///
/// # Errors
/// The machine has no such G function of units.
pub fn noted(asked: NoteRequest) -> Result<Scenario, Error> {
    let NoteRequest { run, name, case } = asked;
    let RunRequest { control, text, setup, program, arguments, strict, mode, target, with, .. } = run;
    let setup = start(control, setup)?.setup;
    let with = with.unwrap_or_default();
    let mut scenario = Scenario {
        source: String::new(),
        program: ScenarioText { name, text: Some(String::from_utf8_lossy(&text.0).into_owned()) },
        with: with.iter().map(|one| ScenarioText { name: one.name.clone(), text: Some(one.text.clone()) }).collect(),
        main: program.unwrap_or_default(),
        arguments: arguments.unwrap_or_default(),
        strict: strict.unwrap_or_default(),
        mode: mode.unwrap_or_default(),
        target,
        setup: SetupFile::from(&setup),
        cases: Vec::new(),
    };
    let outcome = super::carried_out(&scenario, &setup, text, with);
    scenario.cases.push(ScenarioCase { id: case, expect: expected(&outcome), ..ScenarioCase::default() });
    Ok(scenario)
}

/// What came of a run, as far as a user sees it.
fn expected(outcome: &Outcome) -> Expected {
    let log = outcome.log().into_iter().map(str::to_owned).collect::<Vec<_>>();
    let files = outcome.files.iter().map(|(name, lines)| (name.to_owned(), lines.to_vec())).collect::<BTreeMap<_, _>>();
    Expected {
        stop: outcome.stop.as_ref().map(|stop| value(cause(stop))),
        alarms: Some(outcome.alarms().iter().map(|code| value(code.to_string())).collect()),
        calls: Some(outcome.left().into_iter().map(call).collect()),
        changes: Some(outcome.changes().into_iter().map(|change| (change.name, rounded(change.after))).collect()),
        log: Some(log).filter(|log| !log.is_empty()),
        files: Some(files).filter(|files| !files.is_empty()),
        ..Expected::default()
    }
}

fn call(left: Left) -> ExpectedCall {
    let results = left.results.into_iter().map(|(field, value)| (field.name.to_owned(), rounded(value))).collect();
    ExpectedCall { line: left.call.line + 1, cycle: left.call.cycle.to_owned(), results }
}

/// An alarm is a number, all else its text.
fn value(code: String) -> Value {
    code.parse().map_or(Value::Text(code), Value::Number)
}

/// To what is well below every tolerance: a file without endless decimals.
fn rounded(value: f64) -> f64 {
    (value * 1e9).round() / 1e9 + 0.0
}
