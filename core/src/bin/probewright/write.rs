//! `probewright write`.

use crate::check::one_line;
use crate::file::{self, Problem, complain, wrong};
use crate::foreign;
use probewright_core::catalogue::functions::Functions;
use probewright_core::control::{Control, Plane};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Inputs, Typed};
use probewright_core::machine::setup::Setup;
use probewright_core::message::Message;
use probewright_core::program::around::{self, Block, Lines, absent, blocks, problem};
use probewright_core::program::write::snippet;
use probewright_core::words::Words;
use probewright_core::{catalogue, check};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is written.
#[derive(clap::Args)]
pub struct Arguments {
    cycle: String,
    values: Vec<String>,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long)]
    comments: bool,
    #[arg(long, default_value = "direct", hide_default_value = true, value_parser = ["direct", "indirect", "operate"])]
    style: String,
    #[arg(long)]
    around: Vec<String>,
}

/// Writes the snippet, or every problem to standard error.
pub fn write(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    if let Some(text) = foreign::write(&asked.cycle, &asked.values)? {
        write!(out, "{text}")?;
        return Ok(ExitCode::SUCCESS);
    }
    let machine = asked.setup.as_ref().map(|path| file::setup(path, false, words, out)).transpose()?;
    let cycle = machine.as_ref().map_or_else(|| find(&asked.cycle), |setup| find_on(&setup.control, &asked.cycle))?;
    let typed = typed(cycle, &asked.values)?;
    let plane = cycle.purpose.machine.plane().unwrap_or(Plane::G17);
    let control = machine.unwrap_or_else(|| Setup::for_cycle(cycle, plane)).control;
    let checked = check::check(cycle, &typed, &control);
    let label = |_: &str, key: &str| words.key(key.to_owned());
    let comments = asked.comments.then_some(&label as &dyn Fn(&str, &str) -> String);
    let style = serde_json::from_value(asked.style.as_str().into())?;
    let written = snippet(cycle, &typed, &control, style, comments);
    let mut findings = checked.diagnostics.iter().chain(&written.findings);
    for finding in findings.clone() {
        complain(&one_line(finding, words));
    }
    if findings.any(|finding| finding.severity == Severity::Error) {
        return Ok(ExitCode::FAILURE);
    }
    let inputs = check::read(cycle, &typed, &control, &mut Vec::new());
    let lines = around(asked, &inputs, words)?;
    write!(out, "{}{}{}", lines.before, written.text, lines.after)?;
    Ok(ExitCode::SUCCESS)
}

/// The lines of the blocks that are asked for, the outer ones outside.
fn around(asked: &Arguments, inputs: &Inputs, words: &Words) -> Result<Lines, Problem> {
    let mut wanted: BTreeMap<&str, Typed> = BTreeMap::new();
    for one in &asked.around {
        let (name, field) = one.split_once('.').map_or((one.as_str(), None), |(name, field)| (name, Some(field)));
        let values = wanted.entry(name).or_default();
        if let Some(field) = field {
            let pair = field.split_once('=');
            let (field, value) = pair.ok_or_else(|| wrong(Message::new("terminal-pair").text("text", one)))?;
            values.insert(field.to_owned(), value.to_owned());
        }
    }
    let suited = blocks(inputs.cycle.dialect).iter().filter(|block| block.suits(inputs));
    let suited: Vec<&Block> = suited.collect();
    for (name, values) in &wanted {
        right(name, values, &suited, inputs, words)?;
    }
    let mut all = Lines::default();
    for block in suited.iter().rev() {
        let Some(values) = wanted.get(block.name) else { continue };
        let taken = format!("{}{}", all.before, all.after);
        let lines = around::write(block, values, inputs, &taken, &|key| words.key(key.to_owned()), asked.comments);
        all.before.insert_str(0, &lines.before);
        all.after.push_str(&lines.after);
    }
    Ok(all)
}

/// Refuses a block that does not suit the call, a field that it does not have, a value that cannot be written.
fn right(name: &str, values: &Typed, suited: &[&Block], inputs: &Inputs, words: &Words) -> Result<(), Problem> {
    let known = || suited.iter().map(|block| block.name).collect::<Vec<_>>().join(", ");
    let Some(block) = suited.iter().find(|block| block.name == name) else {
        if let Some(absent) = absent(inputs.cycle.dialect).iter().find(|absent| absent.name == name) {
            return Err(wrong(Message::new(absent.why)));
        }
        let message = Message::new("terminal-around").text("cycle", inputs.cycle.name).text("name", name);
        return Err(wrong(message.text("known", known())));
    };
    if let Some(field) = values.keys().find(|field| block.field(field).is_none()) {
        return Err(wrong(Message::new("terminal-around-field").text("name", name).text("field", field)));
    }
    for field in block.fields {
        if let Some(problem) = problem(block, field, values, inputs) {
            let place = format!("{name}.{}", field.name);
            let message = Message::new("terminal-around-problem").text("name", place);
            return Err(wrong(message.text("problem", words.text(&problem))));
        }
    }
    Ok(())
}

fn find(name: &str) -> Result<&'static Cycle, Problem> {
    [Dialect::Sinumerik, Dialect::Nct]
        .into_iter()
        .find_map(|dialect| catalogue::find(dialect, name))
        .ok_or_else(|| wrong(Message::new("terminal-cycle").text("name", name)))
}

/// The cycle of a control with this name: what the G function of an NCT control calls, else that of the catalogue.
fn find_on(control: &Control, name: &str) -> Result<&'static Cycle, Problem> {
    let code = name.strip_prefix(['G', 'g']).and_then(|digits| digits.parse::<f64>().ok());
    let called = code.and_then(|code| Functions::of(control).cycle(code));
    let none = || wrong(Message::new("terminal-cycle-control").text("name", name));
    called.or_else(|| catalogue::find(control.dialect, name)).ok_or_else(none)
}

fn typed(cycle: &Cycle, values: &[String]) -> Result<Typed, Problem> {
    let mut typed = Typed::new();
    for pair in values {
        let (name, value) =
            pair.split_once('=').ok_or_else(|| wrong(Message::new("terminal-pair").text("text", pair)))?;
        let param =
            cycle.params.iter().find(|param| param.name.eq_ignore_ascii_case(name)).ok_or_else(|| {
                wrong(Message::new("terminal-parameter").text("cycle", cycle.name).text("name", name))
            })?;
        if typed.insert(param.name.to_string(), value.to_owned()).is_some() {
            return Err(wrong(Message::new("terminal-twice").text("name", param.name)));
        }
    }
    Ok(typed)
}
