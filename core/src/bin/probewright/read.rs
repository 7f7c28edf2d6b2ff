//! `probewright read`.

use crate::file::{self, Control, Problem};
use crate::foreign;
use crate::joined::Joined;
use probewright_core::control::{Control as State, delivery::delivery};
use probewright_core::message::{Arg, Message, printable};
use probewright_core::program::around;
use probewright_core::program::calls::{CallSite, calls_on};
use probewright_core::program::others::{Other, others};
use probewright_core::program::user_programs::UserPrograms;
use probewright_core::syntax::{self, Program};
use probewright_core::words::Words;
use probewright_core::{app, json};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is read.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    json: bool,
    #[arg(long, conflicts_with = "setup")]
    control: Option<Control>,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
}

/// Lists the measuring calls of a program.
pub fn read(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let machine = asked.setup.as_ref().map(|path| file::setup(path, asked.json, words, out)).transpose()?;
    let joined = Joined::around(&asked.file, file::program(&asked.file)?, &asked.with, asked.control, &file::program)?;
    if let Some(view) = app::foreign(&joined.text).filter(|_| asked.control.is_none()) {
        match asked.json {
            true => file::print_json(json::document(&view), words, out)?,
            false => foreign::list(&asked.file, &view, words, out)?,
        }
        return Ok(ExitCode::SUCCESS);
    }
    if probewright_core::foreign::log_of(&joined.text).is_some() {
        return Err(file::wrong_file(&asked.file, Message::new("terminal-log-empty")));
    }
    file::no_log(&asked.file, &joined.text)?;
    let control = machine.map_or_else(|| delivery(joined.dialect), |setup| setup.control);
    let joined = joined.of(control.dialect);
    let program = syntax::read_held(joined.dialect, &joined.text, &control.definitions.macros, &mut |_| {});
    if asked.json {
        file::print_json(json::document(&app::calls_on(&program, control)), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    let around = UserPrograms::of(&program);
    let mut alone: Vec<Other> = others(&program).collect();
    for call in calls_on(&program, control.clone()) {
        let behind = alone.split_off(alone.partition_point(|one| one.span.start < call.span.start));
        for one in std::mem::replace(&mut alone, behind) {
            without_form(&one, &program, &joined, words, out)?;
        }
        let (path, last) = joined.line(call.line);
        let (_, first) = joined.line(call.first_line);
        writeln!(out, "{}:{}-{}: {}", path.display(), first + 1, last + 1, call.cycle.name)?;
        for (name, value) in &call.values {
            writeln!(out, "    {name}={}", printable(value))?;
        }
        for block in ways(&program, &call, &control, words) {
            writeln!(out, "    {block}")?;
        }
        for note in user_programs(&around, &call, &joined, words) {
            writeln!(out, "    {note}")?;
        }
    }
    for one in alone {
        without_form(&one, &program, &joined, words, out)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// A call of a cycle that has no form: what it does, and its arguments by their published names.
fn without_form(
    one: &Other,
    program: &Program,
    joined: &Joined,
    words: &Words,
    out: &mut dyn Write,
) -> Result<(), Problem> {
    let (path, line) = joined.line(program.line_of(one.span.start));
    writeln!(out, "{}:{}: {}: {}", path.display(), line + 1, one.name, words.text(&one.title))?;
    for (name, value) in &one.arguments {
        writeln!(out, "    {name}={}", printable(value))?;
    }
    Ok(())
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

/// The user's programs that run before and behind a call, with the line in their own file.
pub fn user_programs(around: &UserPrograms, call: &CallSite, joined: &Joined, words: &Words) -> Vec<String> {
    let placed = |mut message: Message| {
        for (name, arg) in &mut message.args {
            if let (&mut "line", Arg::Number(line)) = (name, arg) {
                *line = f64::from(joined.within(*line as u32).1);
            }
        }
        words.text(&message)
    };
    around.around(call.cycle).into_iter().map(|note| placed(note.message)).collect()
}
