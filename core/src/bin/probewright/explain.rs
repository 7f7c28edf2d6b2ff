//! `probewright explain`.

use crate::alarms;
use crate::file::Problem;
use probewright_core::catalogue::CYCLES;
use probewright_core::entry::Cycle;
use probewright_core::report::explain::{cycle, datum, variant};
use probewright_core::report::findings::finding;
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// The help page of a variant of a cycle; else what a finding, an alarm, a parameter, a result or a datum of the
/// machine means.
pub fn explain(name: &str, number: Option<i64>, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let found = CYCLES.iter().find(|one| one.name.eq_ignore_ascii_case(name));
    let text = match found {
        Some(found) => page(found, number, words)?,
        None => datum(name, words) + &finding(name, words),
    };
    if text.is_empty() {
        return alarms::alarms(Some(name), false, words, out)
            .map_err(|_| format!("no cycle, datum, finding or alarm has this name: {name}").into());
    }
    write!(out, "{text}")?;
    Ok(ExitCode::SUCCESS)
}

fn page(found: &'static Cycle, number: Option<i64>, words: &Words) -> Result<String, Problem> {
    let Some(number) = number else { return Ok(cycle(found, words)) };
    let chosen = found.variants.iter().find(|one| one.number == number);
    let chosen = chosen.ok_or_else(|| format!("{} has no variant {number}", found.name))?;
    Ok(variant(found, chosen, words))
}
