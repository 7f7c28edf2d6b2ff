//! `probewright jog`.

use crate::file;
use crate::file::Problem;
use crate::record;
use probewright_core::app::{
    self, Change, JogAhead, JogLine, JogResult, JogView, JogWrong, PracticeRefusal, Raised, Record,
};
use probewright_core::control::{AXES, Control, OLDER_JOG, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::jog::mask::{Field, Mask, decimals, key};
use probewright_core::jog::values::{Values, taken as choices};
use probewright_core::jog::{State, masks};
use probewright_core::json;
use probewright_core::machine::Setup;
use probewright_core::message::Message;
use probewright_core::words::{Words, rounded};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// What is carried out, on which machine.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(required_unless_present = "masks")]
    script: Option<PathBuf>,
    #[arg(long, required_unless_present = "masks")]
    setup: Option<PathBuf>,
    #[arg(long, value_name = "RANDOM")]
    random: Option<u64>,
    #[arg(long)]
    what_if: bool,
    #[arg(long)]
    masks: bool,
    #[arg(long)]
    as_program: bool,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
}

/// Carries out a script; 1 when a line is refused or an alarm is raised.
pub fn jog(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let (Some(script), Some(setup), false) = (&arguments.script, &arguments.setup, arguments.masks) else {
        list(words, out)?;
        return Ok(ExitCode::SUCCESS);
    };
    let record = arguments.record.as_deref().map(record::File::of).transpose()?;
    let setup = file::setup(setup, arguments.json, words, out)?;
    if arguments.as_program {
        return program(script, &setup, arguments, words, out);
    }
    let view = app::jog(&file::text(script)?, &setup, arguments.random).map_err(|wrong| told(script, wrong, words))?;
    let failed = view.lines.iter().any(|line| line.refused.is_some() || line.raised.is_some());
    if arguments.json {
        file::print_json(json::document(&view), words, out)?;
    } else {
        print(script, &view, words, out)?;
        if arguments.what_if {
            told_ahead(view.ahead.as_ref(), words).iter().try_for_each(|line| writeln!(out, "{line}"))?;
        }
    }
    if let Some(record) = record {
        let name = script.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        record.write(&Record::of_jog(name, &setup, view), words)?;
    }
    Ok(if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// What the mask means as a program that is open in the end; 1 when it means none, or a line is refused.
fn program(
    script: &Path,
    setup: &Setup,
    arguments: &Arguments,
    words: &Words,
    out: &mut dyn Write,
) -> Result<ExitCode, Problem> {
    let found = app::jog_program(&file::text(script)?, setup, arguments.random);
    let found = found.map_err(|wrong| told(script, wrong, words))?;
    if arguments.json {
        file::print_json(json::document(&found), words, out)?;
    } else {
        let comment = if found.text.is_empty() { "" } else { "; " };
        if let Some(PracticeRefusal { line, message, hint, left }) = &found.refused {
            let why = with_hint(message, hint.as_ref(), words);
            writeln!(out, "{comment}{}:{line}: {why}", script.display())?;
            left_out(*line, *left).iter().try_for_each(|message| writeln!(out, "{comment}{}", words.text(message)))?;
        }
        found.told.iter().try_for_each(|message| writeln!(out, "{comment}{}", words.text(message)))?;
        write!(out, "{}", found.text)?;
    }
    let failed = found.text.is_empty() || found.refused.is_some();
    Ok(if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Why a script is not carried out, with its line and what helps.
fn told(script: &Path, wrong: JogWrong, words: &Words) -> Problem {
    match wrong {
        JogWrong::Machine(message) => file::wrong(message),
        JogWrong::Line(wrong) => {
            let (cause, cure) = (words.text(&wrong.message), words.text(&wrong.hint));
            format!("{}:{}: {cause} {cure}", script.display(), wrong.line).into()
        }
    }
}

fn print(script: &Path, view: &JogView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    if let Some(message) = app::jog_in_mm(&view.setup.control) {
        writeln!(out, "{}", words.text(&message))?;
    }
    for line in &view.lines {
        for text in lines(line, words) {
            writeln!(out, "{}:{}: {text}", script.display(), line.line)?;
        }
    }
    let last = view.lines.last().map_or(0, |line| line.line);
    left_out(last, view.left).iter().try_for_each(|message| writeln!(out, "{}", words.text(message)))?;
    if let Some(truth) = view.truth {
        let ([x, y, z], [a, b, c]) = (truth.shift, truth.tilt.0);
        let numbers = [("x", x), ("y", y), ("z", z), ("a", a), ("b", b), ("c", c), ("size", truth.size)];
        let message = Message::new("jog-truth").text("seed", truth.seed.to_string());
        let message = numbers.into_iter().fold(message, |message, (name, value)| message.number(name, value));
        writeln!(out, "{}", words.text(&message))?;
    }
    if let Some(last) = view.lines.last() {
        writeln!(out, "{}", words.text(&Message::new("jog-offset-active").text("offset", &last.offset)))?;
        writeln!(out, "{}", words.text(&state(view, last, words)))?;
    }
    Ok(())
}

/// What is on the screen in the end.
fn state(view: &JogView, last: &JogLine, words: &Words) -> Message {
    let pending = || view.lines.iter().rev().find_map(|line| line.raised.as_ref()).filter(|one| one.code.is_empty());
    if last.state == State::Alarm
        && let Some(raised) = pending()
    {
        return Message::new("jog-state-stopped").text("text", words.text(&raised.message));
    }
    let key = match last.state {
        State::Menu => "jog-state-menu",
        State::Mask => "jog-state-mask",
        State::Ready => "jog-state-ready",
        State::Busy => "jog-state-busy",
        State::Activate => "jog-state-activate",
        State::Moving => "jog-state-moving",
        State::Alarm => "jog-state-alarm",
    };
    let alarm = view.lines.iter().rev().find_map(|line| line.raised.as_ref()).map_or("", |one| one.code.as_str());
    Message::new(key)
        .text("alarm", alarm)
        .text("mask", last.mask.as_ref().map_or(String::new(), |mask| words.text(mask)))
}

/// What a line tells: points, results, what was written, what was raised or refused.
fn lines(line: &JogLine, words: &Words) -> Vec<String> {
    let mut told = Vec::new();
    for point in &line.points {
        let numbers: Vec<(&str, f64)> = match (point.touch, point.centre) {
            (Some(touch), _) => AXES.into_iter().zip(touch).collect(),
            (_, Some(centre)) => line.plane.iter().copied().zip(centre).collect(),
            _ => Vec::new(),
        };
        let place: Vec<String> =
            numbers.into_iter().map(|(axis, value)| format!("{axis} {}", figure(value, "mm"))).collect();
        let message = Message::new("jog-point").text("point", &point.name).text("place", place.join(", "));
        told.push(words.text(&message));
    }
    told.extend(line.results.iter().map(|result| {
        let (label, value) = shown(result, words);
        format!("{label} = {value}")
    }));
    told.extend(line.changes.iter().map(|Change { name, before, after, unit, .. }| {
        format!("{name}: {} -> {}", figure(*before, unit), with_unit(*after, unit))
    }));
    told.extend(line.notes.iter().chain(&line.screen).map(|message| words.text(message)));
    if let Some(raised) = &line.raised {
        let code = Message::new("terminal-raised").text("alarm", &raised.code);
        let code = if raised.code.is_empty() { String::new() } else { words.text(&code) + ": " };
        told.push(format!("{code}{}", reason(raised, words)));
    }
    told.extend(line.refused.iter().map(|message| with_hint(message, line.hint.as_ref(), words)));
    told
}

/// What is raised, and what helps.
fn reason(raised: &Raised, words: &Words) -> String {
    with_hint(&raised.message, raised.hint.as_ref(), words)
}

fn with_hint(message: &Message, hint: Option<&Message>, words: &Words) -> String {
    let hint = hint.map_or(String::new(), |hint| format!(" {}", words.text(hint)));
    words.text(message) + &hint
}

/// That lines of the script were left out behind one.
fn left_out(line: u32, lines: u32) -> Option<Message> {
    let message = || Message::new("jog-left-out").number("line", line.into()).number("lines", lines.into());
    (lines > 0).then(message)
}

/// A result with its unit.
fn shown(result: &JogResult, words: &Words) -> (String, String) {
    (words.text(&result.label), with_unit(result.value, result.unit))
}

/// A value with the decimals of the control.
fn figure(value: f64, unit: &str) -> String {
    let Some(digits) = decimals(unit) else { return rounded(value).to_string() };
    let text = format!("{value:.digits$}");
    if text.trim_start_matches('-').trim_matches(['0', '.']).is_empty() {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

fn with_unit(value: f64, unit: &str) -> String {
    let number = figure(value, unit);
    match unit {
        "" => number,
        "deg" => format!("{number}°"),
        _ => format!("{number} {unit}"),
    }
}

/// What the next key would do, a line a thing.
fn told_ahead(ahead: Option<&JogAhead>, words: &Words) -> Vec<String> {
    let Some(ahead) = ahead else { return vec![words.key("jog-ahead-none")] };
    let mut told: Vec<Message> = ahead.notes.clone();
    for at in &ahead.touches {
        let place = AXES.iter().zip(at).map(|(axis, value)| format!("{axis} {}", figure(*value, "mm")));
        told.push(Message::new("jog-ahead-touch").text("place", place.collect::<Vec<_>>().join(", ")));
    }
    let stores = if ahead.waits { "jog-ahead-hold" } else { "jog-ahead-store" };
    told.extend(ahead.point.iter().map(|point| Message::new(stores).text("point", point)));
    told.extend(ahead.raised.iter().map(|raised| {
        let key = if raised.code.is_empty() { "jog-ahead-stop" } else { "jog-ahead-raise" };
        Message::new(key).text("alarm", &raised.code).text("text", reason(raised, words))
    }));
    told.extend(ahead.refused.iter().map(|why| Message::new("jog-ahead-refuse").text("text", words.text(why))));
    told.extend(ahead.results.iter().map(|result| {
        let (label, value) = shown(result, words);
        Message::new("jog-ahead-show").text("label", label).text("value", value)
    }));
    told.extend(ahead.changes.iter().map(|Change { name, before, after, unit, .. }| {
        let [before, after] = [figure(*before, unit), with_unit(*after, unit)];
        Message::new("jog-ahead-write").text("label", name).text("before", before).text("after", after)
    }));
    if !ahead.results.is_empty() && ahead.changes.is_empty() {
        told.push(Message::new("jog-ahead-nothing"));
    }
    if ahead.activates {
        told.push(Message::new("jog-ahead-activates"));
    }
    let heading = words.key(if ahead.start { "jog-ahead-start" } else { "jog-ahead-calculate" });
    std::iter::once(heading).chain(told.iter().map(|one| format!("  {}", words.text(one)))).collect()
}

/// The masks, with their fields and what these take.
fn list(words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for mask in masks::all() {
        let mut control = delivery(Dialect::Sinumerik);
        control.set(OLDER_JOG, f64::from(u8::from(mask.older.is_some())));
        writeln!(out, "{:14} {}", mask.name, words.key(key("mask", mask.name)))?;
        for field in mask.fields {
            writeln!(out, "{:14} {}", "", words.text(&takes(mask, field, &control, words)))?;
        }
    }
    Ok(())
}

/// A field, and what it takes.
fn takes(mask: &Mask, field: &Field, control: &Control, words: &Words) -> Message {
    let label = Message::new(key("field", field.name));
    let axis = if field.name.starts_with('y') {
        "Y"
    } else if ["z0", "dz"].contains(&field.name) {
        "Z"
    } else {
        "X"
    };
    let label = words.text(&label.text("axis", axis));
    let message = |key: &'static str| Message::new(key).text("label", &label).text("name", field.name);
    match choices(field, &Values::first(mask, control), control) {
        Some(known) => message("jog-takes-one-of").text("words", known.join(", ")),
        None => message("jog-takes"),
    }
}
