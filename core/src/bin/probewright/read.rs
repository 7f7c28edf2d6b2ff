//! `probewright read`.

use crate::file;
use crate::file::{Control, Problem};
use probewright_core::message::printable;
use probewright_core::program::calls::calls;
use probewright_core::words::Words;
use probewright_core::{app, json, syntax};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is read.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    json: bool,
    #[arg(long)]
    control: Option<Control>,
}

/// Lists the measuring calls of a program.
pub fn read(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let source = file::program(&asked.file)?;
    let program = syntax::read(file::dialect(asked.control, &source), &source);
    if asked.json {
        file::print_json(json::document(&app::calls(&program)), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    for call in calls(&program) {
        let (first, last) = (call.first_line + 1, call.line + 1);
        writeln!(out, "{}:{first}-{last}: {}", asked.file.display(), call.cycle.name)?;
        for (name, value) in &call.values {
            writeln!(out, "    {name}={}", printable(value))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
