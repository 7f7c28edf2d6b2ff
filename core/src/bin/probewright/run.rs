//! `probewright run`.

use crate::check::print_all;
use crate::file::Problem;
use crate::{file, scan};
use probewright_core::app::{RunAssumed, RunView};
use probewright_core::catalogue::alarms;
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::entry::{Unit, unit_behind};
use probewright_core::machine::trace::Step;
use probewright_core::message::{Message, printable};
use probewright_core::run::assumed::Assumed;
use probewright_core::run::left::CallAt;
use probewright_core::run::outcome::Outcome;
use probewright_core::run::{Limits, assumed};
use probewright_core::words::{Words, rounded};
use probewright_core::{json, run, syntax};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is run, and where what comes out goes.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, conflicts_with = "setup")]
    control: Option<file::Control>,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    print: Option<PathBuf>,
    #[command(flatten)]
    scan: scan::Files,
}

/// Runs a program; 1 when it has an error or did not reach its end.
pub fn run(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let path = &arguments.file;
    let source = file::program(path)?;
    let Assumed { setup, outcome, told } = match &arguments.setup {
        Some(setup) => {
            let mut setup = file::setup(setup, arguments.json, words, out)?;
            arguments.scan.put_surface(&mut setup)?;
            let program = syntax::read(setup.control.dialect, &source);
            Assumed { outcome: run::run(&program, &setup, Limits::default()), setup, told: Vec::new() }
        }
        None => {
            let program = syntax::read(file::dialect(arguments.control, &source), &source);
            assumed::run(&program, Limits::default())
        }
    };
    if arguments.json {
        let mut view = RunView::new(setup.clone(), outcome.clone(), &source);
        if arguments.setup.is_none() {
            view.assumed = Some(RunAssumed { messages: told, setup });
        }
        file::print_json(json::document(&view), words, out)?;
    } else {
        for assumption in &told {
            writeln!(out, "{}", words.text(assumption))?;
        }
        print_all(path, &source, &outcome.diagnostics, words, out)?;
        print_outcome(path, &outcome, words, out)?;
    }
    if let Some(print) = &arguments.print {
        let lines = outcome.printed().into_iter();
        file::write(print, lines.map(|line| format!("{line}\n")))?;
    }
    arguments.scan.write(&outcome.scans)?;
    let wrong = |found: &Diagnostic| found.severity == Severity::Error;
    Ok(if outcome.finished() && !outcome.diagnostics.iter().any(wrong) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What came out, how the run ended last; why it ended early is among the findings.
fn print_outcome(path: &Path, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for (call, step) in outcome.by_call() {
        if let Step::Decision { message: decision } = step {
            writeln!(out, "{}{}", place(path, call), words.text(decision))?;
        }
    }
    print_results(path, outcome, words, out)?;
    for line in outcome.log() {
        writeln!(out, "{}: {}", words.key("terminal-log"), printable(line))?;
    }
    for change in outcome.changes() {
        let (before, after) = (rounded(change.before), rounded(change.after));
        writeln!(out, "{}: {before} -> {after}", change.name)?;
    }
    for (alarm, call) in outcome.alarms().into_iter().zip(outcome.calls_of_alarms()) {
        let raised = words.text(&Message::new("terminal-raised").text("alarm", alarm.to_string()));
        writeln!(out, "{}{raised}: {}", place(path, call), words.key(alarms::key(alarm)))?;
    }
    writeln!(out, "{}", words.text(&outcome.ending()))?;
    Ok(())
}

/// `part.mpf:12: CYCLE977: `, what was said there behind it.
fn place(path: &Path, call: Option<CallAt>) -> String {
    call.map_or(String::new(), |CallAt { line, cycle }| format!("{}:{}: {cycle}: ", path.display(), line + 1))
}

/// What each call measured: its results that have a unit.
fn print_results(path: &Path, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for left in outcome.left() {
        let measured = left.results.iter().filter(|(field, _)| field.unit != Unit::None);
        let lines = measured.map(|(field, value)| {
            let unit = unit_behind(field.unit, &outcome.control).replace('\u{a0}', " "); // searched with plain blanks
            let meaning = words.key(field.key);
            format!("  {} = {}{unit}  {meaning}", field.name, rounded(*value))
        });
        let lines: Vec<String> = lines.collect();
        if !lines.is_empty() {
            writeln!(out, "{}:{}: {}", path.display(), left.call.line + 1, left.call.cycle)?;
            writeln!(out, "{}", lines.join("\n"))?;
        }
    }
    Ok(())
}
