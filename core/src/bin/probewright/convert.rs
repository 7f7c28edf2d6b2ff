//! `probewright convert`: the measuring calls of a program in another call style.

use crate::check::{one_line, print_all};
use crate::file::{self, Control, Problem, complain, wrong_file};
use probewright_core::control::{self, delivery};
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::entry::Style;
use probewright_core::message::Message;
use probewright_core::program::calls::calls_on;
use probewright_core::program::change::apply;
use probewright_core::program::convert::{Converted, convert, convert_all};
use probewright_core::syntax::{self, Program};
use probewright_core::words::Words;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

/// What is converted.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long, value_parser = ["direct", "indirect", "operate"])]
    style: String,
    #[arg(long)]
    line: Option<u32>,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, conflicts_with = "setup")]
    control: Option<Control>,
    #[arg(long)]
    write: bool,
}

/// Writes the program with its calls in this style, or changes the file, byte for byte what it was elsewhere; what has
/// to be said about it on standard error. 1 where nothing is changed.
pub fn convert_file(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let machine = asked.setup.as_ref().map(|path| file::setup(path, false, words, out)).transpose()?;
    let source = file::as_it_is(&asked.file)?;
    let dialect = machine.as_ref().map_or_else(|| file::dialect(asked.control, &source), |one| one.control.dialect);
    let control = machine.map_or_else(|| delivery(dialect), |setup| setup.control);
    let macros = Arc::clone(&control.definitions.macros);
    let program = syntax::read_held(dialect, &Arc::new(source.clone()), &macros, &mut |_| {});
    let style: Style = serde_json::from_value(asked.style.as_str().into())?;
    let done = done(asked, &program, style, &control)?;
    told(asked, &source, done.findings, words)?;
    if done.edits.is_empty() {
        return Ok(ExitCode::FAILURE);
    }
    let text = apply(&source, &done.edits);
    if asked.write {
        if file::bytes(&asked.file)? != source {
            return Err(wrong_file(&asked.file, Message::new("terminal-convert-encoding")));
        }
        std::fs::write(&asked.file, &text).map_err(|error| file::unwritable(&asked.file, &error))?;
        let count = Message::new("terminal-convert-done").number("count", done.calls as f64);
        writeln!(out, "{}: {}", asked.file.display(), words.text(&count))?;
    } else {
        out.write_all(&text)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The call in the line that is asked for, or all.
fn done(asked: &Arguments, program: &Program, style: Style, control: &control::Control) -> Result<Converted, Problem> {
    let Some(line) = asked.line else { return Ok(convert_all(program, style, control)) };
    let sites = calls_on(program, control.clone());
    let (index, site) = sites.iter().enumerate().find(|(_, site)| site.line + 1 == line).ok_or_else(|| {
        wrong_file(&asked.file, Message::new("terminal-convert-line").number("line", f64::from(line)))
    })?;
    let mut done = convert(program, index, style, control);
    for one in &mut done.findings {
        one.span = one.span.or(Some(site.span));
    }
    Ok(done)
}

/// What has to be said, errors that only leave a call as it is too.
fn told(asked: &Arguments, source: &[u8], mut found: Vec<Diagnostic>, words: &Words) -> Result<(), Problem> {
    found.sort_by_key(|one| (one.span.map_or(u32::MAX, |span| span.start), one.severity == Severity::Note));
    let (placed, rest): (Vec<_>, Vec<_>) = found.into_iter().partition(|one| one.span.is_some());
    let mut lines = Vec::new();
    print_all(&asked.file, source, &placed, words, &mut lines)?;
    String::from_utf8_lossy(&lines).lines().for_each(complain);
    rest.iter().for_each(|one| complain(&format!("{}: {}", asked.file.display(), one_line(one, words))));
    Ok(())
}
