//! `probewright alarms`.

use crate::file::{Problem, print_json};
use probewright_core::app::AlarmInfo;
use probewright_core::catalogue::alarms::ALARMS;
use probewright_core::catalogue::operator_messages::MESSAGES;
use probewright_core::catalogue::{alarms, operator_messages};
use probewright_core::report::alarms::{Told, told, told_message};
use probewright_core::words::Words;
use probewright_core::{app, json};
use std::io::Write;
use std::process::ExitCode;

/// Explains one alarm or text for the operator, or lists all.
pub fn alarms(number: Option<&str>, as_json: bool, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    match number {
        Some(text) => one(text, as_json, words, out)?,
        None if as_json => print_json(json::document(&app::alarms()), words, out)?,
        None => list(words, out)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn list(words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let alarms = ALARMS.iter().map(|alarm| told(alarm, words));
    let messages = MESSAGES.iter().map(|message| told_message(message, words));
    for told in alarms.chain(messages) {
        writeln!(out, "{:24} {}", told.code, told.meaning)?;
    }
    Ok(())
}

fn one(text: &str, as_json: bool, words: &Words, out: &mut dyn Write) -> Result<(), Problem> {
    let (view, told, source) = match (alarms::find(text), operator_messages::find(text)) {
        (Some(alarm), _) => (AlarmInfo::of(alarm), told(alarm, words), alarm.source),
        (None, Some(message)) => {
            let told = told_message(message, words);
            (AlarmInfo::of_message(message), told, message.source)
        }
        (None, None) => return Err(format!("no such alarm: {text}").into()),
    };
    if as_json {
        print_json(json::document(&view), words, out)?;
    } else {
        explain(&told, source, out)?;
    }
    Ok(())
}

fn explain(told: &Told, source: &str, out: &mut dyn Write) -> std::io::Result<()> {
    writeln!(out, "{}: {}", told.code, told.meaning)?;
    for (name, text) in [
        ("cause", told.cause.as_deref().unwrap_or_default()),
        ("cure", &told.cure),
        ("effect", &told.effect),
        ("raised by", &told.sources),
        ("found", &told.found),
        ("source", source),
    ] {
        if !text.is_empty() {
            writeln!(out, "  {name:9}  {text}")?;
        }
    }
    Ok(())
}
