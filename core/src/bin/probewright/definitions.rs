//! `probewright definitions`: what a machine changes in its definition files, and values read back from them.

use crate::file::{self, Problem};
use probewright_core::app::{self, DefinitionsRequest, DefinitionsView, ExportedFile, ReadBackRequest};
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::json;
use probewright_core::machine::Setup;
use probewright_core::message::Message;
use probewright_core::words::Words;
use serde_json::{Value, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Which machine, and what it gets from files.
#[derive(clap::Args)]
pub struct Arguments {
    files: Vec<PathBuf>,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, value_name = "COUNT")]
    channels: Option<u32>,
    #[arg(long)]
    no_jog: bool,
    #[arg(long, value_name = "FOLDER")]
    into: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,
    #[arg(long)]
    json: bool,
}

/// Gives the machine the values of the files, then writes what it changes in its definition files.
pub fn definitions(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let mut setup = match &asked.setup {
        Some(path) => {
            file::setup(path, asked.json, words, out)?;
            serde_json::from_str(&file::text(path)?)?
        }
        None => serde_json::to_value(Setup::calibrated(Dialect::Sinumerik, Plane::G17))?,
    };
    let mut problems = false;
    if !asked.files.is_empty() {
        problems = read(asked, &mut setup, words)?;
    }
    if let Some(path) = &asked.save {
        file::write(path, [serde_json::to_string_pretty(&setup)? + "\n"].into_iter())?;
    }
    let request = DefinitionsRequest {
        setup: Some(serde_json::from_value(setup)?),
        channels: asked.channels,
        jog: Some(!asked.no_jog),
    };
    let view = app::definitions(request).map_err(|refused| file::wrong(refused.message))?;
    if let Some(folder) = &asked.into {
        file::make_folder(folder)?;
        for one in &view.files {
            file::write(&folder.join(one.saved), [one.text.clone()].into_iter())?;
        }
    }
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
    } else {
        print(&view, words, out)?;
    }
    Ok(if problems { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Reads the files into the machine; tells whether a value was refused or cannot be read.
fn read(asked: &Arguments, setup: &mut Value, words: &Words) -> Result<bool, Problem> {
    let mut files = Vec::new();
    for path in &asked.files {
        files.push(ExportedFile { name: path.display().to_string(), text: file::exported(path)? });
    }
    let request = ReadBackRequest { setup: Some(serde_json::from_value(setup.clone())?), files };
    let back = app::read_back(request).map_err(|refused| file::wrong_files(&asked.files, refused.message))?;
    if let Value::Object(members) = setup {
        members.insert("units".to_owned(), json!(back.machine.basic));
        members.insert("data".to_owned(), json!(back.machine.data));
        members.insert("definitions".to_owned(), json!(back.definitions));
    }
    file::complain(&words.text(&back.ending));
    if let Some(sizes) = &back.sizes {
        file::complain(&words.text(sizes));
    }
    for fault in &back.unread {
        file::complain(&super::machine::line(fault, words));
    }
    for problem in &back.machine.problems {
        let texts = [&problem.refusal.message, &problem.refusal.hint].map(|message| words.text(message));
        file::complain(&format!("{}: {}", problem.name, texts.join(" ")));
    }
    Ok(!back.machine.problems.is_empty() || !back.unread.is_empty())
}

fn print(view: &DefinitionsView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for one in &view.files {
        writeln!(out, "; {}\n{}", one.name, one.text)?;
    }
    if view.files.is_empty() {
        writeln!(out, "{}\n", words.key("definitions-none"))?;
    }
    if !view.memory.is_empty() {
        writeln!(out, "{}", words.key("definitions-memory"))?;
    }
    for share in &view.memory {
        let key = if share.channel { "definitions-share-channel" } else { "definitions-share" };
        let message = Message::new(key).text("name", &share.name).number("bytes", share.bytes as f64);
        writeln!(out, "  {}", words.text(&message.number("default", share.delivered as f64)))?;
    }
    for need in &view.needs {
        let message = Message::new("definitions-need").text("number", need.number).number("value", need.value);
        writeln!(out, "  {}", words.text(&message.source(need.source)))?;
    }
    for note in &view.notes {
        file::complain(&words.text(note));
    }
    Ok(())
}
