//! `probewright write`.

use crate::check::one_line;
use crate::file::{Problem, complain, wrong};
use probewright_core::control::Plane;
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Typed};
use probewright_core::machine::setup::Setup;
use probewright_core::message::Message;
use probewright_core::program::write::snippet;
use probewright_core::words::Words;
use probewright_core::{catalogue, check};
use std::io::Write;
use std::process::ExitCode;

/// What is written.
#[derive(clap::Args)]
pub struct Arguments {
    cycle: String,
    values: Vec<String>,
    #[arg(long)]
    comments: bool,
    #[arg(long, default_value = "direct", hide_default_value = true, value_parser = ["direct", "indirect", "operate"])]
    style: String,
}

/// Writes the snippet, or every problem to standard error.
pub fn write(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let cycle = find(&asked.cycle)?;
    let typed = typed(cycle, &asked.values)?;
    let plane = cycle.purpose.machine.plane().unwrap_or(Plane::G17);
    let control = Setup::for_cycle(cycle, plane).control;
    let checked = check::check(cycle, &typed, &control);
    let label = |_: &str, key: &str| words.key(key.to_owned());
    let comments = asked.comments.then_some(&label as &dyn Fn(&str, &str) -> String);
    let style = serde_json::from_value(asked.style.as_str().into())?;
    let written = snippet(cycle, &typed, &control, style, comments);
    let mut findings = checked.diagnostics.iter().chain(&written.findings);
    for finding in findings.clone() {
        complain(&one_line(finding, words));
    }
    if findings.any(|finding| finding.severity == Severity::Error) {
        return Ok(ExitCode::FAILURE);
    }
    write!(out, "{}", written.text)?;
    Ok(ExitCode::SUCCESS)
}

fn find(name: &str) -> Result<&'static Cycle, Problem> {
    [Dialect::Sinumerik, Dialect::Nct]
        .into_iter()
        .find_map(|dialect| catalogue::find(dialect, name))
        .ok_or_else(|| wrong(Message::new("terminal-cycle").text("name", name)))
}

fn typed(cycle: &Cycle, values: &[String]) -> Result<Typed, Problem> {
    let mut typed = Typed::new();
    for pair in values {
        let (name, value) =
            pair.split_once('=').ok_or_else(|| wrong(Message::new("terminal-pair").text("text", pair)))?;
        let param =
            cycle.params.iter().find(|param| param.name.eq_ignore_ascii_case(name)).ok_or_else(|| {
                wrong(Message::new("terminal-parameter").text("cycle", cycle.name).text("name", name))
            })?;
        if typed.insert(param.name.to_string(), value.to_owned()).is_some() {
            return Err(wrong(Message::new("terminal-twice").text("name", param.name)));
        }
    }
    Ok(typed)
}
