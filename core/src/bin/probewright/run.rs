//! `probewright run`.

use crate::check::print_all;
use crate::file::{self, Problem};
use probewright_core::diagnostic::Code;
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::program;
use probewright_core::run::outcome::Outcome;
use probewright_core::run::{self, Limits, Stop};
use probewright_core::words::Words;
use std::path::Path;
use std::process::ExitCode;

/// Runs a program; 1 when it did not reach its end.
pub fn run(path: &Path, setup: &Path, as_json: bool) -> Result<ExitCode, Problem> {
    let source = file::bytes(path)?;
    let setup = json::setup_from_json(&file::text(setup)?)
        .map_err(|error| format!("{}: {error}", setup.display()))?;
    let program = program::read(setup.control.dialect, &source);
    let outcome = run::run(&program, &setup, Limits::default());
    if as_json {
        println!(
            "{}",
            serde_json::to_string_pretty(&json::run_outcome(&setup, &outcome, &source)?)?
        );
    } else {
        let words = Words::english();
        print_all(path, &source, &outcome.diagnostics, &words);
        print_outcome(&outcome, &words);
    }
    Ok(if outcome.finished() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

fn print_outcome(outcome: &Outcome, words: &Words) {
    for decision in outcome.decisions() {
        println!("{}", words.text(decision));
    }
    for line in outcome.log() {
        println!("log: {line}");
    }
    for change in outcome.changes() {
        println!("{}: {} -> {}", change.name, change.before, change.after);
    }
    for alarm in outcome.alarms() {
        println!("{}", alarm_line(alarm, words));
    }
    if let Some(Stop::Fault(message)) = &outcome.stop {
        println!("{}", words.text(message));
    }
}

fn alarm_line(alarm: Code, words: &Words) -> String {
    let key = json::alarm_key(alarm);
    format!(
        "alarm {}: {}",
        json::code(alarm),
        words.text(&Message::new(key))
    )
}
