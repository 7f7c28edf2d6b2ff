//! `probewright older`: measuring programs of the 840C with the names of today.

use crate::check::print_all;
use crate::file::{self, Problem, complain, wrong, wrong_file};
use probewright_core::app::{self, OlderCall, OlderRequest};
use probewright_core::dialect::Dialect;
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::program::change::apply;
use probewright_core::program::r_parameters::{Answers, edits, find, findings, reasons};
use probewright_core::syntax::programs::programs;
use probewright_core::syntax::{Program, read};
use probewright_core::words::Words;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Which program, and what is answered where the manual leaves it open.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long = "answer", value_name = "ANSWER")]
    answers: Vec<String>,
    #[arg(long, conflicts_with = "json")]
    explain: bool,
    #[arg(long)]
    json: bool,
}

/// Writes the program with the names of today, byte for byte what it was elsewhere; or tells what each R parameter
/// means. 1 where a question is open, or nothing is to be converted.
pub fn older(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let given = asked.answers.iter().map(|text| pair(text)).collect::<Result<Vec<_>, _>>()?;
    let answers =
        app::answers(given.iter().map(|(name, value)| (name, value))).map_err(|refused| wrong(refused.message))?;
    let text = String::from_utf8_lossy(&file::program(&asked.file)?).into_owned();
    let given: BTreeMap<String, String> = given.into_iter().collect();
    let view = app::older(OlderRequest { text: text.into(), answers: given });
    let view = view.map_err(|refused| wrong_file(&asked.file, refused.message))?;
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
    } else if asked.explain {
        explained(&view.calls, words, out)?;
    }
    if view.calls.is_empty() {
        return Err(wrong_file(&asked.file, Message::new("older-none")));
    }
    let done = !view.edits.is_empty();
    if !asked.json && !asked.explain {
        converted(asked, &answers, words, out)?;
    }
    Ok(if done { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn pair(text: &str) -> Result<(String, String), Problem> {
    let pair = text.split_once('=');
    let (name, value) = pair.ok_or_else(|| wrong(Message::new("terminal-pair").text("text", text)))?;
    Ok((name.to_owned(), value.to_owned()))
}

/// The program, in its own encoding; what is to be said of it on standard error.
fn converted(asked: &Arguments, answers: &Answers, words: &Words, out: &mut dyn Write) -> Result<(), Problem> {
    let source = file::as_it_is(&asked.file)?;
    let program: Program = read(Dialect::Sinumerik, &source);
    let programs = programs(&program);
    let older = find(&program, &programs, answers);
    let mut found = Vec::new();
    findings(&program, &programs, &older, &mut found);
    found.extend(reasons(&program, &older));
    let edits = edits(&program, &older);
    if !edits.is_empty() {
        found.retain(|one| one.span.is_none_or(|span| older.calls.iter().all(|call| call.name != span)));
        out.write_all(&apply(&source, &edits))?;
    }
    found.sort_by_key(|one| one.span.map_or(0, |span| span.start));
    let mut told = Vec::new();
    print_all(&asked.file, &source, &found, words, &mut told)?;
    for line in String::from_utf8_lossy(&told).lines() {
        complain(line);
    }
    Ok(())
}

/// Each call with its R parameters, and what each is today.
fn explained(calls: &[OlderCall], words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for call in calls {
        writeln!(out, "{}: {} → {}", call.line, call.name, call.cycle)?;
        for one in &call.parameters {
            let named = |name: &app::OlderName| format!("{}: {}", name.name, words.text(&name.label));
            let meaning = match &one.names[..] {
                [] => words.key("older-not-used"),
                names => names.iter().map(named).collect::<Vec<_>>().join(&format!(" {} ", words.key("older-or"))),
            };
            writeln!(out, "  {}  {meaning}", one.text)?;
        }
    }
    Ok(())
}
