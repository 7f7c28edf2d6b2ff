//! `probewright write`.

use crate::check::one_line;
use crate::file::{self, Problem, complain, wrong};
use crate::foreign;
use probewright_core::catalogue::Argument;
use probewright_core::catalogue::functions::Functions;
use probewright_core::control::{Control, GENERATION, OF_LISTS, Plane, delivery};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{ArgumentList, Cycle, Inputs, Style, Typed};
use probewright_core::form::{Entry, argument_entry};
use probewright_core::machine::setup::Setup;
use probewright_core::message::Message;
use probewright_core::program::around::{self, Block, Lines, absent, blocks, problem};
use probewright_core::program::lists::without_form;
use probewright_core::program::write::{is_listed_on, other_generation, snippet, unsaid};
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
    #[arg(long, value_parser = ["direct", "indirect", "operate"])]
    style: Option<String>,
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
    let style: Style = match (&asked.style, &machine) {
        (Some(style), _) => serde_json::from_value(style.as_str().into())?,
        (None, Some(setup)) if is_listed_on(cycle, &setup.control) => Style::Operate,
        (None, _) => Style::Direct,
    };
    let list = cycle.lists.iter().find(|list| style == Style::Operate && list.style == style);
    let other = machine.as_ref().and_then(|setup| other_generation(cycle, style, &setup.control));
    let typed = typed(cycle, list, asked)?;
    let plane = cycle.purpose.machine.plane().unwrap_or(Plane::G17);
    let mut control = machine.unwrap_or_else(|| Setup::for_cycle(cycle, plane)).control;
    let checked = match list.filter(|list| list.is_written()) {
        Some(list) => {
            control.set(GENERATION, OF_LISTS);
            check::newer::check_listed(cycle, list, &typed, &control)
        }
        None => check::check(cycle, &typed, &control),
    };
    let label = |_: &str, key: &str| words.key(key.to_owned());
    let comments = asked.comments.then_some(&label as &dyn Fn(&str, &str) -> String);
    let written = snippet(cycle, &typed, &control, style, comments);
    let unsaid = unsaid(cycle, &typed, &written);
    let mut findings = checked.diagnostics.iter().chain(&written.findings).chain(&other).chain(&unsaid);
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
    let found = [Dialect::Sinumerik, Dialect::Nct].into_iter().find_map(|dialect| catalogue::find(dialect, name));
    found.ok_or_else(|| {
        let alone = without_form().find(|(alone, _)| alone.eq_ignore_ascii_case(name));
        wrong(match alone {
            Some((alone, _)) => Message::new("write-unpublished-alone").text("cycle", alone),
            None => Message::new("terminal-cycle").text("name", name),
        })
    })
}

/// The cycle of a control with this name: that of the catalogue, whatever function calls it on this machine, as in
/// forms and pages; else what the G function of an NCT control calls.
fn find_on(control: &Control, name: &str) -> Result<&'static Cycle, Problem> {
    let code = name.strip_prefix(['G', 'g']).and_then(|digits| digits.parse::<f64>().ok());
    let called = || code.and_then(|code| Functions::of(control).cycle(code));
    let none = || wrong(Message::new("terminal-cycle-control").text("name", name));
    catalogue::find(control.dialect, name).or_else(called).ok_or_else(none)
}

/// The values as typed, by the names of the parameters; what the list alone has, by its names there.
fn typed(cycle: &'static Cycle, list: Option<&'static ArgumentList>, asked: &Arguments) -> Result<Typed, Problem> {
    let mut typed = Typed::new();
    let mut of_list = Vec::new();
    for pair in &asked.values {
        let (name, value) =
            pair.split_once('=').ok_or_else(|| wrong(Message::new("terminal-pair").text("text", pair)))?;
        let param = cycle.params.iter().find(|param| param.name.eq_ignore_ascii_case(name));
        let argument = list.and_then(|list| Argument::all(list).find(|one| one.name.eq_ignore_ascii_case(name)));
        match (param, argument) {
            (Some(param), _) => put(&mut typed, param.name.as_str(), value)?,
            (None, Some(argument)) => of_list.push((argument, value)),
            (None, None) => {
                let unknown = Message::new("terminal-parameter").text("cycle", asked.cycle.to_uppercase());
                return Err(wrong(unknown.text("name", name)));
            }
        }
    }
    // those that choose come first: they decide which others the older control uses
    let control = delivery(cycle.dialect);
    of_list.sort_by_key(|(argument, _)| argument.place);
    for (argument, value) in of_list {
        possible(&argument, value)?;
        let name = older(cycle, &argument, &typed, &control).unwrap_or(argument.name);
        put(&mut typed, name, value)?;
    }
    Ok(typed)
}

fn put(typed: &mut Typed, name: &str, value: &str) -> Result<(), Problem> {
    match typed.insert(name.to_owned(), value.to_owned()) {
        Some(_) => Err(wrong(Message::new("terminal-twice").text("name", name))),
        None => Ok(()),
    }
}

/// The parameter with the meaning of an argument, where the older control uses it in this variant.
fn older(cycle: &'static Cycle, argument: &Argument, typed: &Typed, control: &Control) -> Option<&'static str> {
    let param = cycle.param(argument.param?.as_str())?;
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    (cycle.variant_param() == Some(param.name) || param.need(&inputs).is_some()).then_some(param.name.as_str())
}

/// Refuses an argument whose digits are not published, and a value that it cannot have.
fn possible(argument: &Argument, value: &str) -> Result<(), Problem> {
    let about = |key: &'static str| wrong(Message::new(key).text("name", argument.name).text("value", value));
    if argument.is_open() {
        return Err(about("terminal-argument-open"));
    }
    match argument_entry(argument.name) {
        Entry::Choice { choices } if !choices.iter().any(|one| value.trim() == one.value.to_string()) => {
            Err(about("terminal-argument-value"))
        }
        _ => Ok(()),
    }
}
