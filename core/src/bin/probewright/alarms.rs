//! `probewright alarms`.

use crate::file::Problem;
use probewright_core::catalogue::alarms::{ALARMS, Alarm, find};
use probewright_core::json;
use probewright_core::report::alarms::told;
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// Explains one alarm, or lists all.
pub fn alarms(
    number: Option<&str>,
    as_json: bool,
    words: &Words,
    out: &mut dyn Write,
) -> Result<ExitCode, Problem> {
    let chosen = match number {
        Some(text) => Some(find(text).ok_or_else(|| format!("no such alarm: {text}"))?),
        None => None,
    };
    match chosen {
        _ if as_json => {
            let list = chosen.map_or_else(json::alarms, json::alarm);
            writeln!(out, "{}", serde_json::to_string_pretty(&list)?)?;
        }
        Some(alarm) => explain(alarm, words, out)?,
        None => list(words, out)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn list(words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for alarm in ALARMS {
        let told = told(alarm, words);
        writeln!(out, "{:24} {}", told.code, told.meaning)?;
    }
    Ok(())
}

fn explain(alarm: &Alarm, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let told = told(alarm, words);
    writeln!(out, "{}: {}", told.code, told.meaning)?;
    for (name, text) in [
        ("cause", told.cause.as_deref().unwrap_or_default()),
        ("cure", &told.cure),
        ("effect", &told.effect),
        ("raised by", &told.sources),
        ("found", &told.found),
        ("source", alarm.source),
    ] {
        if !text.is_empty() {
            writeln!(out, "  {name:9}  {text}")?;
        }
    }
    Ok(())
}
