//! `probewright cycles`.

use crate::file::Problem;
use probewright_core::catalogue::CYCLES;
use probewright_core::json;
use probewright_core::words::Words;
use std::process::ExitCode;

/// Lists the catalogue.
pub fn cycles(as_json: bool) -> Result<ExitCode, Problem> {
    if as_json {
        println!("{}", serde_json::to_string_pretty(&json::cycles())?);
        return Ok(ExitCode::SUCCESS);
    }
    let words = Words::english();
    for cycle in CYCLES {
        println!(
            "{:10} {}",
            cycle.name,
            words.key(format!("{}-title", cycle.key))
        );
        for variant in cycle.variants {
            println!("{:>10} {}", variant.number, words.key(variant.key));
        }
    }
    Ok(ExitCode::SUCCESS)
}
