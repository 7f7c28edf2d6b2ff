//! `probewright alarms`.

use crate::file::{Problem, print_json, wrong};
use probewright_core::message::Message;
use probewright_core::report::alarms::{Told, all, named, of_newer};
use probewright_core::words::Words;
use probewright_core::{app, json};
use std::io::Write;
use std::process::ExitCode;

/// Explains one alarm or text for the operator, or lists all.
pub fn alarms(number: Option<&str>, as_json: bool, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let unknown = |text: &str| wrong(Message::new("terminal-alarm").text("name", text));
    match (number, as_json) {
        (None, true) => print_json(json::document(&app::alarms()), words, out)?,
        (None, false) => {
            for told in all(words) {
                writeln!(out, "{:24} {}", told.code, told.meaning)?;
            }
        }
        (Some(text), true) => {
            print_json(json::document(&app::alarm(text).ok_or_else(|| unknown(text))?), words, out)?;
        }
        (Some(text), false) => match (named(text, words), of_newer(text, words)) {
            (Some(told), _) => explain(&told, words, out)?,
            (None, Some(told)) => writeln!(out, "{text}: {told}\n  {}", words.key("newer-alarm"))?,
            (None, None) => return Err(unknown(text)),
        },
    }
    Ok(ExitCode::SUCCESS)
}

fn explain(told: &Told, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    write!(out, "{}", explained(told, words))
}

/// An alarm: its meaning, and below it what else there is to say.
pub fn explained(told: &Told, words: &Words) -> String {
    let mut text = format!("{}: {}\n", told.code, told.meaning);
    for (key, said) in [
        ("terminal-told-cause", told.cause.as_deref().unwrap_or_default()),
        ("terminal-told-cure", &told.cure),
        ("terminal-told-newer", told.newer.as_deref().unwrap_or_default()),
        ("terminal-told-effect", &told.effect),
        ("terminal-told-sources", &told.sources),
        ("terminal-told-found", &told.found),
        ("terminal-told-source", &told.source.to_string()),
    ] {
        if !said.is_empty() {
            text += &format!("  {:9}  {said}\n", words.key(key));
        }
    }
    text
}
