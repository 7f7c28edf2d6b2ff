//! `probewright read`.

use crate::file::{self, Control, Problem};
use probewright_core::json;
use probewright_core::program;
use probewright_core::program::calls::calls;
use std::path::Path;
use std::process::ExitCode;

/// Lists the measuring calls of a program.
pub fn read(path: &Path, as_json: bool, control: Option<Control>) -> Result<ExitCode, Problem> {
    let source = file::bytes(path)?;
    let program = program::read(file::dialect(control, &source), &source);
    if as_json {
        println!("{}", serde_json::to_string_pretty(&json::calls(&program))?);
        return Ok(ExitCode::SUCCESS);
    }
    for call in calls(&program) {
        println!(
            "{}:{}-{}: {}",
            path.display(),
            call.first_line + 1,
            call.line + 1,
            call.cycle.name
        );
        for (name, value) in &call.values {
            println!("    {name}={value}");
        }
    }
    Ok(ExitCode::SUCCESS)
}
