//! `probewright cycles`.

use crate::file::{Problem, print_json};
use probewright_core::catalogue::CYCLES;
use probewright_core::foreign::CONTROLS;
use probewright_core::words::Words;
use probewright_core::{app, json};
use std::io::Write;
use std::process::ExitCode;

/// Lists the catalogue.
pub fn cycles(as_json: bool, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    if as_json {
        print_json(json::document(&app::catalogue().cycles), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    for cycle in CYCLES {
        writeln!(out, "{:10} {}", cycle.name, words.key(format!("{}-title", cycle.key)))?;
        for variant in cycle.variants {
            writeln!(out, "{:>10} {}", variant.number, words.key(variant.key))?;
        }
    }
    for cycle in CONTROLS.iter().flat_map(|control| control.cycles) {
        writeln!(out, "{} {}", cycle.name, words.key(cycle.title()))?;
    }
    Ok(ExitCode::SUCCESS)
}
