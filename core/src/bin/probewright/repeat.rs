//! `probewright repeat`: the test programs of a probe, and what repeated touches come to.

use crate::check::severity;
use crate::file;
use crate::file::Problem;
use probewright_core::app::{RepeatRequest, RepeatView, repeat_on, repeat_texts};
use probewright_core::control::Plane;
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::json;
use probewright_core::machine::Setup;
use probewright_core::program::probe_test::SAYS;
use probewright_core::words::Words;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is tested, and where the values come from.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(long, value_name = "FILE")]
    setup: Option<PathBuf>,
    #[arg(long, value_name = "AXIS")]
    axis: Option<String>,
    #[arg(long, value_name = "POSITION")]
    from: Option<f64>,
    #[arg(long, value_name = "POSITION")]
    to: Option<f64>,
    #[arg(long, value_name = "FEED")]
    feed: Option<f64>,
    #[arg(long, value_name = "INPUT")]
    input: Option<u8>,
    #[arg(long, value_name = "COUNT")]
    count: Option<f64>,
    #[arg(long)]
    mcs: bool,
    #[arg(long, value_name = "R")]
    parameters: Option<f64>,
    #[arg(long)]
    m6: bool,
    #[arg(long, value_name = "FILE")]
    values: Option<PathBuf>,
    #[arg(long, conflicts_with = "function")]
    program: bool,
    #[arg(long)]
    function: bool,
    #[arg(long)]
    json: bool,
}

/// Width of the longest bar of a histogram, characters.
const WIDTH: usize = 40;

/// Tells one of the programs, or what the touches come to.
pub fn repeat(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let setup = match &asked.setup {
        Some(path) => file::setup(path, asked.json, words, out)?,
        None => Setup::calibrated(Dialect::Sinumerik, Plane::G17),
    };
    let request = RepeatRequest {
        axis: asked.axis.clone(),
        from: asked.from,
        to: asked.to,
        feed: asked.feed,
        input: asked.input,
        count: asked.count,
        machine: Some(asked.mcs),
        parameters: asked.parameters,
        changes: Some(asked.m6),
        values: asked.values.as_ref().map(|path| file::text(path)).transpose()?,
        words: Some(SAYS.iter().map(|key| ((*key).to_owned(), words.key(*key))).collect()),
        setup: None,
    };
    if !asked.json && (asked.function || asked.program) {
        return text(asked, &request, setup, words, out);
    }
    let view = repeat_on(&request, setup).map_err(|refused| file::wrong(refused.message))?;
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
    } else {
        print(&view, words, out)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Prints the program that is asked for; why its touches come to nothing on this machine is a note.
fn text(
    asked: &Arguments,
    request: &RepeatRequest,
    setup: Setup,
    words: &Words,
    out: &mut dyn Write,
) -> Result<ExitCode, Problem> {
    let [function, program] = repeat_texts(request, &setup).map_err(|refused| file::wrong(refused.message))?;
    write!(out, "{}", if asked.function { function } else { program })?;
    if let Err(refused) = repeat_on(request, setup) {
        out.flush()?;
        file::complain(&format!("{}: {}", severity(Severity::Note), words.text(&refused.message)));
    }
    Ok(ExitCode::SUCCESS)
}

fn print(view: &RepeatView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let found = &view.found;
    for line in &view.told {
        writeln!(out, "{}", words.text(line))?;
    }
    let most = found.intervals.iter().copied().max().unwrap_or(0).max(1);
    for (at, count) in found.intervals.iter().enumerate() {
        let from = found.smallest + found.range * at as f64 / found.intervals.len() as f64;
        writeln!(out, "{from:>12.5} {count:>5} {}", "#".repeat(count * WIDTH / most))?;
    }
    for note in &view.notes {
        writeln!(out, "{}", words.text(note))?;
    }
    Ok(())
}
