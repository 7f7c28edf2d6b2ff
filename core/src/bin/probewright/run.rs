//! `probewright run`.

use crate::check::print_all;
use crate::file::Problem;
use crate::joined::Joined;
use crate::progress::Progress;
use crate::{file, log, scan};
use probewright_core::app::{RunAssumed, RunView};
use probewright_core::catalogue::alarms;
use probewright_core::control::Value;
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::entry::{Unit, unit_behind};
use probewright_core::machine::trace::Step;
use probewright_core::message::{Message, printable};
use probewright_core::run::assumed::Assumed;
use probewright_core::run::left::CallAt;
use probewright_core::run::of_machine;
use probewright_core::run::outcome::Outcome;
use probewright_core::run::{Limits, Session, assumed};
use probewright_core::words::{Words, rounded};
use probewright_core::{json, syntax};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::rc::Rc;

/// What is run, and where what comes out goes.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, conflicts_with = "setup")]
    control: Option<file::Control>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
    #[arg(long, value_name = "VALUES")]
    arg: Vec<String>,
    #[arg(long)]
    strict: bool,
    #[arg(long, value_name = "NUMBER")]
    max_blocks: Option<u64>,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    print: Option<PathBuf>,
    #[arg(long, value_name = "FOLDER")]
    log: Option<PathBuf>,
    #[command(flatten)]
    scan: scan::Files,
}

/// Runs a program; 1 when it has an error or did not reach its end.
pub fn run(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let joined = Joined::read(&arguments.file, &arguments.with, arguments.control)?;
    let values = values(&arguments.arg)?;
    let recorded = if arguments.json { Limits::default().own } else { 0 };
    let steps = arguments.max_blocks;
    let limits = Limits { steps, own: recorded, strict: arguments.strict, ..Limits::default() };
    let mut progress = Progress::new(words);
    let mut told = |session: &Session| progress.tell(session);
    let (joined, Assumed { setup, outcome, told }) = match &arguments.setup {
        Some(setup) => {
            let mut setup = file::setup(setup, arguments.json, words, out)?;
            arguments.scan.put_surface(&mut setup)?;
            let joined = joined.of(setup.control.dialect);
            let program = syntax::read_on(joined.dialect, &joined.text, &setup.control.definitions.macros);
            let outcome = Session::new(program, &setup, limits).with_arguments(values).complete_told(&mut told);
            (joined, Assumed { outcome, setup, told: Vec::new() })
        }
        None => {
            let program = Rc::new(syntax::read(joined.dialect, &joined.text));
            let assumed = assumed::run_with(&program, limits, values, &mut told);
            (joined, assumed)
        }
    };
    progress.end();
    if arguments.json {
        let mut view = RunView::new(setup.clone(), outcome.clone(), &joined.text);
        if arguments.setup.is_none() {
            view.assumed = Some(RunAssumed { messages: told, setup });
        }
        file::print_json(json::document(&view), words, out)?;
    } else {
        for assumption in &told {
            writeln!(out, "{}", words.text(assumption))?;
        }
        for (path, source, found) in joined.files(&outcome.diagnostics) {
            print_all(path, source, &found, words, out)?;
        }
        print_outcome(&joined, &outcome, words, out)?;
    }
    if let Some(print) = &arguments.print {
        let lines = outcome.printed().into_iter();
        file::write(print, lines.map(|line| format!("{line}\n")))?;
    }
    arguments.scan.write(&outcome.scans)?;
    let written = match (&arguments.log, arguments.json) {
        (None, true) => true, // they are in the document
        (Some(folder), true) => log::write(&outcome.files, Some(folder), words, &mut std::io::sink())?,
        (folder, false) => log::write(&outcome.files, folder.as_deref(), words, out)?,
    };
    let wrong = |found: &Diagnostic| found.severity == Severity::Error;
    Ok(if written && outcome.finished() && !outcome.diagnostics.iter().any(wrong) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// `DEPTH=5`, `NAME="A"`: values of parameters by their names in upper case.
fn values(asked: &[String]) -> Result<BTreeMap<String, Value>, Problem> {
    let one = |text: &String| {
        let (name, value) = text.split_once('=').filter(|(name, _)| !name.trim().is_empty())?;
        let value = value.trim();
        let value = match value.parse::<f64>().ok().filter(|number| number.is_finite()) {
            Some(number) => Value::Number(number),
            None => Value::Text(value.trim_matches('"').to_owned()),
        };
        Some((name.trim().to_ascii_uppercase(), value))
    };
    let refused = |text: &String| file::wrong(Message::new("terminal-pair").text("text", printable(text)));
    asked.iter().map(|text| one(text).ok_or_else(|| refused(text))).collect()
}

/// What came out, how the run ended last; why it ended early is among the findings.
fn print_outcome(joined: &Joined, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for (call, step) in outcome.by_call() {
        if let Step::Decision { message: decision } = step {
            writeln!(out, "{}{}", place(joined, call), words.text(decision))?;
        }
    }
    print_results(joined, outcome, words, out)?;
    for line in outcome.log() {
        writeln!(out, "{}: {}", words.key("terminal-log"), printable(line))?;
    }
    for change in outcome.changes() {
        let (before, after) = (rounded(change.before), rounded(change.after));
        writeln!(out, "{}: {before} -> {after}", change.name)?;
    }
    for (alarm, call) in outcome.alarms().into_iter().zip(outcome.calls_of_alarms()) {
        let raised = words.text(&Message::new("terminal-raised").text("alarm", alarm.to_string()));
        writeln!(out, "{}{raised}: {}", place(joined, call), words.key(alarms::key(alarm)))?;
    }
    let assumed = outcome.machine_values.iter().map(|one| {
        let at = match joined.within(one.line) {
            (Some(file), line) => format!("{file}:{line}"),
            (None, line) => line.to_string(),
        };
        format!("{} = {} ({at})", one.name, of_machine::shown(&one.value))
    });
    let assumed: Vec<String> = assumed.collect();
    if !assumed.is_empty() {
        let told = Message::new("terminal-assumed-values").text("values", assumed.join(", "));
        writeln!(out, "{}", words.text(&told))?;
    }
    writeln!(out, "{}", words.text(&outcome.ending(|line| joined.within(line))))?;
    Ok(())
}

/// `part.mpf:12: CYCLE977: `, what was said there behind it.
fn place(joined: &Joined, call: Option<CallAt>) -> String {
    call.map_or(String::new(), |CallAt { line, cycle }| {
        let (path, line) = joined.line(line);
        format!("{}:{}: {cycle}: ", path.display(), line + 1)
    })
}

/// What each call measured: its results that have a unit.
fn print_results(joined: &Joined, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for left in outcome.left() {
        let measured = left.results.iter().filter(|(field, _)| field.unit != Unit::None);
        let lines = measured.map(|(field, value)| {
            let unit = unit_behind(field.unit, &outcome.control).replace('\u{a0}', " "); // searched with plain blanks
            let meaning = words.key(field.key);
            format!("  {} = {}{unit}  {meaning}", field.name, rounded(*value))
        });
        let lines: Vec<String> = lines.collect();
        if !lines.is_empty() {
            let (path, line) = joined.line(left.call.line);
            writeln!(out, "{}:{}: {}", path.display(), line + 1, left.call.cycle)?;
            writeln!(out, "{}", lines.join("\n"))?;
        }
    }
    Ok(())
}
