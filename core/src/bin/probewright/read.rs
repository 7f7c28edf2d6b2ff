//! `probewright read`.

use crate::file;
use crate::file::{Control, Problem};
use probewright_core::message::printable;
use probewright_core::program::calls::calls;
use probewright_core::words::Words;
use probewright_core::{app, json, syntax};
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// Lists the measuring calls of a program.
pub fn read(
    path: &Path,
    as_json: bool,
    control: Option<Control>,
    words: &Words,
    out: &mut dyn Write,
) -> Result<ExitCode, Problem> {
    let source = file::program(path)?;
    let program = syntax::read(file::dialect(control, &source), &source);
    if as_json {
        file::print_json(json::document(&app::calls(&program)), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    for call in calls(&program) {
        let (first, last) = (call.first_line + 1, call.line + 1);
        let (path, name) = (path.display(), call.cycle.name);
        writeln!(out, "{path}:{first}-{last}: {name}")?;
        for (name, value) in &call.values {
            writeln!(out, "    {name}={}", printable(value))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
