//! `probewright read`.

use crate::file::{self, Control, Problem};
use crate::foreign;
use crate::joined::Joined;
use probewright_core::control::{Control as State, delivery::delivery};
use probewright_core::message::{Message, printable};
use probewright_core::program::around;
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::user_programs::UserPrograms;
use probewright_core::syntax::{self, Program};
use probewright_core::words::Words;
use probewright_core::{app, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

/// What is read.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    json: bool,
    #[arg(long)]
    control: Option<Control>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
}

/// Lists the measuring calls of a program.
pub fn read(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let joined = Joined::read(&asked.file, &asked.with, asked.control)?;
    if let Some(view) = app::foreign(&joined.text).filter(|_| asked.control.is_none()) {
        match asked.json {
            true => file::print_json(json::document(&view), words, out)?,
            false => foreign::list(&asked.file, &view, words, out)?,
        }
        return Ok(ExitCode::SUCCESS);
    }
    let program = syntax::read_held(joined.dialect, &joined.text, &Arc::default(), &mut |_| {});
    if asked.json {
        file::print_json(json::document(&app::calls(&program)), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    let around = UserPrograms::of(&program);
    let control = delivery(joined.dialect);
    for call in calls(&program) {
        let (path, last) = joined.line(call.line);
        let (_, first) = joined.line(call.first_line);
        writeln!(out, "{}:{}-{}: {}", path.display(), first + 1, last + 1, call.cycle.name)?;
        for (name, value) in &call.values {
            writeln!(out, "    {name}={}", printable(value))?;
        }
        for block in ways(&program, &call, &control, words) {
            writeln!(out, "    {block}")?;
        }
        for note in around.around(call.cycle) {
            writeln!(out, "    {}", words.text(&note.message))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// What stands around a call and is known as a block: its title, and its values.
pub fn ways(program: &Program, call: &CallSite, control: &State, words: &Words) -> Vec<String> {
    let inputs = around::inputs_at(call, control);
    let told = |found: &around::Found| {
        let values = found.values().into_iter().map(|(name, value)| format!("{name}={}", printable(&value)));
        let values = values.collect::<Vec<_>>().join(", ");
        let told = Message::new("terminal-around-found").text("title", words.key(found.block.key()));
        words.text(&told.text("name", found.block.name).text("values", values))
    };
    around::found(program, call, &inputs).iter().map(told).collect()
}
