//! `probewright older`: measuring programs of the 840C with the names of today.

use crate::check::print_all;
use crate::file::{self, Control, Problem, complain, wrong, wrong_file};
use crate::joined::Joined;
use probewright_core::app::{self, OlderCall, OlderRequest};
use probewright_core::diagnostic::{Edit, Span};
use probewright_core::dialect::Dialect;
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::program::change::apply;
use probewright_core::program::r_parameters::{Answers, edits, find, findings, is_of_call, reasons};
use probewright_core::syntax::programs::programs;
use probewright_core::syntax::{Program, read_held};
use probewright_core::words::Words;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// An 840C is a SINUMERIK, whatever its program looks like.
const CONTROL: Option<Control> = Some(Control::Sinumerik);

/// Which program, and what is answered where the manual leaves it open.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long = "answer", value_name = "ANSWER")]
    answers: Vec<String>,
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with = "json")]
    with: Vec<PathBuf>,
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["json", "explain"])]
    into: Option<PathBuf>,
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
    let joined = Joined::around(&asked.file, file::program(&asked.file)?, &asked.with, CONTROL, &file::program)?;
    let text = String::from_utf8_lossy(&joined.text).into_owned();
    let given: BTreeMap<String, String> = given.into_iter().collect();
    let view = app::older(OlderRequest { text: text.into(), answers: given });
    let view = view.map_err(|refused| wrong_file(&asked.file, refused.message))?;
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
    } else if asked.explain {
        explained(&view.calls, &joined, words, out)?;
    }
    if view.calls.is_empty() {
        return Err(wrong_file(&asked.file, Message::new("older-none")));
    }
    let mut done = !view.edits.is_empty();
    if !asked.json && !asked.explain {
        done &= converted(asked, &answers, words, out)?;
    }
    Ok(if done { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn pair(text: &str) -> Result<(String, String), Problem> {
    let pair = text.split_once('=');
    let (name, value) = pair.ok_or_else(|| wrong(Message::new("terminal-pair").text("text", text)))?;
    Ok((name.to_owned(), value.to_owned()))
}

/// The program, in its own encoding, and what is to be said of it on standard error; false: files beside it change too,
/// and no folder is named for them.
fn converted(asked: &Arguments, answers: &Answers, words: &Words, out: &mut dyn Write) -> Result<bool, Problem> {
    let joined = Joined::around(&asked.file, file::as_it_is(&asked.file)?, &asked.with, CONTROL, &file::as_it_is)?;
    let program: Program = read_held(Dialect::Sinumerik, &joined.text, &Arc::default(), &mut |_| {});
    let programs = programs(&program);
    let older = find(&program, &programs, answers);
    let mut found = Vec::new();
    findings(&program, &programs, &older, &mut found);
    found.extend(reasons(&program, &programs, &older));
    let edits = edits(&program, &older);
    if !edits.is_empty() {
        found.retain(|one| !is_of_call(one));
    }
    found.sort_by_key(|one| one.span.map_or(0, |span| span.start));
    let mut told = Vec::new();
    for (path, source, found) in joined.files(&found) {
        print_all(path, source, &found, words, &mut told)?;
    }
    for line in String::from_utf8_lossy(&told).lines() {
        complain(line);
    }
    if edits.is_empty() {
        return Ok(true);
    }
    let mut files = changed(&joined, edits);
    match (&asked.into, &files[..]) {
        (Some(folder), _) => written(&asked.file, folder, &files, words, out)?,
        (None, [_]) => out.write_all(&files.remove(0).1)?,
        (None, [_, beside, ..]) => {
            let path = beside.0.display().to_string();
            complain(&words.text(&Message::new("older-into").text("path", path)));
            return Ok(false);
        }
        (None, []) => {}
    }
    Ok(true)
}

/// The program, and the files beside it that change, with what they are then.
fn changed(joined: &Joined, edits: Vec<Edit>) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files: Vec<(&Path, &[u8], Vec<Edit>)> = Vec::new();
    files.extend(joined.place(Span::default()).map(|(path, source, _)| (path, source, Vec::new())));
    for edit in edits {
        let Some((path, source, mut span)) = joined.place(edit.span) else { continue };
        span.end = span.end.min(source.len() as u32); // the end of the last line is not of the file
        let edit = Edit { span, ..edit };
        match files.iter_mut().find(|(known, ..)| *known == path) {
            Some((.., all)) => all.push(edit),
            None => files.push((path, source, vec![edit])),
        }
    }
    files.into_iter().map(|(path, source, edits)| (path.to_owned(), apply(source, &edits))).collect()
}

/// Writes files into a folder, and names them; never over what they were made from.
fn written(
    program: &Path,
    folder: &Path,
    files: &[(PathBuf, Vec<u8>)],
    words: &Words,
    out: &mut dyn Write,
) -> Result<(), Problem> {
    file::make_folder(folder)?;
    let of = |path: &Path| folder.join(path.file_name().unwrap_or_default());
    let is_same = |path: &Path| of(path).canonicalize().ok().zip(path.canonicalize().ok()).is_some_and(|(a, b)| a == b);
    if files.iter().any(|(path, _)| is_same(path)) {
        return Err(wrong_file(program, Message::new("older-into-same")));
    }
    for (path, text) in files {
        let path = of(path);
        std::fs::write(&path, text).map_err(|error| file::unwritable(&path, &error))?;
        let told = Message::new("older-written").text("path", path.display().to_string());
        writeln!(out, "{}", words.text(&told))?;
    }
    Ok(())
}

/// Each call with its R parameters, and what each is today.
fn explained(calls: &[OlderCall], joined: &Joined, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let named = |name: &app::OlderName| format!("{}: {}", name.name, words.text(&name.label));
    for call in calls {
        let (file, line) = joined.within(call.line);
        let file = file.map_or_else(String::new, |file| format!("{file}:"));
        writeln!(out, "{file}{line}: {} → {}", call.name, call.cycle)?;
        for one in &call.parameters {
            let meaning = match (&one.names[..], &one.instead) {
                ([], Some(other)) => words.text(&Message::new("older-instead").text("other", other)),
                ([], None) => words.key("older-not-used"),
                (names, _) => names.iter().map(named).collect::<Vec<_>>().join(&format!(" {} ", words.key("older-or"))),
            };
            writeln!(out, "  {}  {meaning}", one.text)?;
        }
        for one in &call.left_open {
            let open = Message::new("older-left-open").text("value", one.delivered.to_string());
            writeln!(out, "  {}  {} ({})", one.parameter, named(&one.name), words.text(&open))?;
        }
    }
    Ok(())
}
