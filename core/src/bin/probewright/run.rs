//! `probewright run`.

use crate::check::{print_all, print_placed, printed};
use crate::file::Problem;
use crate::joined::Joined;
use crate::progress::Progress;
use crate::protocol::Protocol;
use crate::read::{user_programs, ways};
use crate::stream::Stream;
use crate::{document, file, log, protocol, record, scan};
use probewright_core::app::{Change, Record, ResultScreen, RunAssumed, RunView, ScreenUntil, changes};
use probewright_core::catalogue::alarms;
use probewright_core::control::Value;
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::entry::{Unit, unit_behind};
use probewright_core::foreign::control_of;
use probewright_core::machine::Setup;
use probewright_core::machine::trace::Step;
use probewright_core::message::{Arg, Message, printable};
use probewright_core::program::calls::calls_on;
use probewright_core::program::user_programs::UserPrograms;
use probewright_core::run::assumed::Assumed;
use probewright_core::run::left::CallAt;
use probewright_core::run::mode::{MODES, Mode};
use probewright_core::run::of_machine;
use probewright_core::run::outcome::Outcome;
use probewright_core::run::{Limits, Session, assumed};
use probewright_core::syntax::{self, Program};
use probewright_core::words::{Words, rounded};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::rc::Rc;
use std::sync::Arc;

/// What is run, and where what comes out goes.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, conflicts_with = "setup")]
    control: Option<file::Control>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
    #[arg(long, value_name = "NAME")]
    program: Option<String>,
    #[arg(long, value_name = "VALUES")]
    arg: Vec<String>,
    #[arg(long)]
    strict: bool,
    #[arg(long, value_name = "MODE", value_parser = MODES.map(|(_, name)| name))]
    mode: Option<String>,
    #[arg(long, value_name = "LINE", value_parser = clap::value_parser!(u32).range(1..),
        required_if_eq("mode", "block-search"))]
    target: Option<u32>,
    #[arg(long)]
    screens: bool,
    #[arg(long, value_name = "NUMBER")]
    max_blocks: Option<u64>,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    print: Option<PathBuf>,
    #[arg(long, value_name = "FOLDER")]
    log: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    #[command(flatten)]
    protocol: protocol::Named,
    #[command(flatten)]
    scan: scan::Files,
}

impl Arguments {
    /// How the program is carried out; a line alone is the target of a block search.
    fn mode(&self) -> Mode {
        let named = MODES.iter().find(|(_, name)| self.mode.as_deref() == Some(*name)).map(|(mode, _)| *mode);
        named.unwrap_or(if self.target.is_some() { Mode::BlockSearch } else { Mode::Automatic })
    }

    /// Whether all of the program and of the run is needed afterwards.
    fn whole(&self) -> bool {
        self.json || self.screens || self.record.is_some() || self.protocol.given()
    }
}

/// Runs a program; 1 when it has an error or did not reach its end.
pub fn run(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let record = arguments.record.as_deref().map(record::File::of).transpose()?;
    let protocol = arguments.protocol.read()?;
    let text = Text::of(arguments)?;
    let file = arguments.file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let given = Given { file, program: arguments.program.clone(), values: values(&arguments.arg)? };
    if let Some(control) = control_of(&text.joined.text).filter(|_| protocol.is_some() || record.is_some()) {
        let told = Message::new("terminal-foreign-record").text("control", control.name);
        return Err(file::wrong_file(&arguments.file, told));
    }
    let (mode, target) = (arguments.mode(), arguments.target.unwrap_or_default());
    let limits = Limits { strict: arguments.strict, mode, target, ..Limits::default() }.permitted(arguments.max_blocks);
    let limits = if arguments.whole() { limits } else { limits.unrecorded() };
    let setup = setup(arguments, words, out)?;
    let mut text = text.on(setup.as_ref(), arguments)?;
    let mut progress = Progress::new(words);
    let (mut program, mut ran) = carried_out(&text, setup.as_ref(), &given, limits, &mut progress)?;
    if !text.was_run()? {
        text = Text::whole(arguments)?.on(setup.as_ref(), arguments)?;
        (program, ran) = carried_out(&text, setup.as_ref(), &given, limits, &mut progress)?;
    }
    progress.end();
    let Assumed { setup, outcome, told } = ran;
    let joined = &text.joined;
    let outcome = if arguments.json {
        let mut view = RunView::new(setup.clone(), outcome, &joined.text);
        if arguments.setup.is_none() {
            view.assumed = Some(RunAssumed { messages: told, setup: setup.clone() });
        }
        document::print(view, words, out)?
    } else {
        for assumption in &told {
            writeln!(out, "{}", words.text(assumption))?;
        }
        text.print(&outcome.diagnostics, words, out)?;
        text.print_around(&program, &setup, words, out)?;
        print_outcome(joined, &outcome, words, out)?;
        if arguments.screens {
            let view = RunView::new(setup.clone(), outcome, &joined.text);
            view.answers
                .iter()
                .filter_map(|one| one.answer.screen.as_ref())
                .try_for_each(|one| screen(one, words, out))?;
            view.trace.outcome
        } else {
            outcome
        }
    };
    if let Some(print) = &arguments.print {
        let lines = outcome.printed().into_iter();
        file::write(print, lines.map(|line| format!("{line}\n")))?;
    }
    let ways = (record.as_ref(), protocol);
    let fits = match arguments.json {
        true => write_record(ways, joined, (&setup, &outcome), words, &mut std::io::sink())?,
        false => write_record(ways, joined, (&setup, &outcome), words, out)?,
    };
    arguments.scan.write(&outcome.scans)?;
    let written = match (&arguments.log, arguments.json) {
        (None, true) => true, // they are in the document
        (Some(folder), true) => log::write(&outcome.files, Some(folder), words, &mut std::io::sink())?,
        (folder, false) => log::write(&outcome.files, folder.as_deref(), words, out)?,
    };
    let wrong = |found: &Diagnostic| found.severity == Severity::Error;
    Ok(if written && fits && outcome.finished() && !outcome.diagnostics.iter().any(wrong) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Lays the protocol onto the run and tells how, and writes the record of both; whether something of the protocol fits.
fn write_record(
    (record, protocol): (Option<&record::File>, Option<Protocol>),
    joined: &Joined,
    (setup, outcome): (&Setup, &Outcome),
    words: &Words,
    out: &mut dyn Write,
) -> Result<bool, Problem> {
    let laid = protocol.map(|protocol| protocol.laid(setup, outcome)).transpose()?;
    let fits = laid.as_ref().map_or(Ok(true), |laid| laid.print(words, out))?;
    if let Some(file) = record {
        let made = match laid {
            Some(laid) => Record::measured(joined.name(), laid.view, joined.beside()),
            None => Record::new(joined.name(), setup, outcome, joined.beside()),
        };
        file.write(&made, words)?;
    }
    Ok(fits)
}

/// Runs a text on the machine that is named, else on one that fits it; with the program, or its beginning.
fn carried_out(
    text: &Text,
    setup: Option<&Setup>,
    given: &Given,
    limits: Limits,
    progress: &mut Progress,
) -> Result<(Rc<Program>, Assumed), Problem> {
    let mut told = |session: &Session| progress.tell(session);
    let (program, prepare) = text.begin(setup, given.clone())?;
    let main = given.program.as_deref();
    let ran = match setup {
        None => assumed::run_with(&program, main, limits, prepare, &mut told),
        Some(setup) => {
            let outcome = prepare(Session::new(Rc::clone(&program), setup, limits)).complete_told(&mut told);
            Assumed { outcome, setup: setup.clone(), told: Vec::new() }
        }
    };
    Ok((program, ran))
}

/// The machine that is named.
fn setup(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<Option<Setup>, Problem> {
    let Some(path) = &arguments.setup else { return Ok(None) };
    let mut setup = file::setup(path, arguments.json, words, out)?;
    arguments.scan.put_surface(&mut setup)?;
    Ok(Some(setup))
}

/// What a run is given beside the text: which program of it is run, and values of its parameters.
#[derive(Clone)]
struct Given {
    /// Name of the file.
    file: String,
    program: Option<String>,
    values: BTreeMap<String, Value>,
}

impl Given {
    fn to(self, session: Session) -> Session {
        let session = match &self.program {
            Some(name) => session.of_program(name),
            None => session,
        };
        session.with_arguments(self.values).of_file(&self.file)
    }
}

/// A program, held whole or coming in pieces.
struct Text {
    joined: Joined,
    stream: Option<Stream>,
}

impl Text {
    fn of(arguments: &Arguments) -> Result<Text, Problem> {
        let begins = RefCell::new(Ok(()));
        let language = |source: &[u8]| {
            *begins.borrow_mut() = file::no_log(&arguments.file, source);
            file::dialect(arguments.control, source)
        };
        let alone = !arguments.whole() && arguments.with.is_empty() && arguments.program.is_none();
        let stream = alone.then(|| Stream::of(&arguments.file, language)).flatten();
        begins.into_inner()?;
        match stream {
            Some(stream) => Ok(Text { joined: Joined::unheld(&arguments.file, stream.dialect), stream: Some(stream) }),
            None => Text::whole(arguments),
        }
    }

    fn whole(arguments: &Arguments) -> Result<Text, Problem> {
        let joined = Joined::read(&arguments.file, &arguments.with, arguments.control)?;
        Ok(Text { joined, stream: None })
    }

    /// On a machine, in its language; its macros may stand for words on every line.
    fn on(self, setup: Option<&Setup>, arguments: &Arguments) -> Result<Text, Problem> {
        let Some(control) = setup.map(|setup| &setup.control) else { return Ok(self) };
        let suits = |stream: &Stream| stream.dialect == control.dialect && control.definitions.macros.is_empty();
        let text = if self.stream.as_ref().is_none_or(suits) { self } else { Text::whole(arguments)? };
        Ok(Text { joined: text.joined.of(control.dialect), ..text })
    }

    /// The program, or its beginning, and what a run of it is to have.
    fn begin(&self, setup: Option<&Setup>, given: Given) -> Result<Begun, Problem> {
        let Some(stream) = &self.stream else {
            let macros = setup.map(|setup| Arc::clone(&setup.control.definitions.macros)).unwrap_or_default();
            let program = syntax::read_held(self.joined.dialect, &self.joined.text, &macros, &mut |_| {});
            return Ok((Rc::new(program), Box::new(|session| given.to(session))));
        };
        let (program, prepare) = stream.begin()?;
        Ok((program, Box::new(|session| given.to(prepare(session)))))
    }

    /// Whether what was run is all of it; else it has to be run whole.
    fn was_run(&self) -> Result<bool, Problem> {
        self.stream.as_ref().map_or(Ok(true), Stream::was_run)
    }

    /// Prints the blocks that stand around the calls and what the user runs there, where the text is held.
    fn print_around(
        &self,
        program: &Program,
        setup: &Setup,
        words: &Words,
        out: &mut dyn Write,
    ) -> std::io::Result<()> {
        if self.stream.is_some() {
            return Ok(());
        }
        let around = UserPrograms::of(program);
        for call in calls_on(program, setup.control.clone()) {
            let notes = user_programs(&around, &call, &self.joined, words);
            for block in ways(program, &call, &setup.control, words).into_iter().chain(notes) {
                let (path, line) = self.joined.line(call.line);
                writeln!(out, "{}:{}: {}: {block}", path.display(), line + 1, call.cycle.name)?;
            }
        }
        Ok(())
    }

    /// Prints what was found, in the file where it stands.
    fn print(&self, found: &[Diagnostic], words: &Words, out: &mut dyn Write) -> Result<(), Problem> {
        let Some(stream) = &self.stream else {
            for (path, source, found) in self.joined.files(found) {
                print_all(path, source, &found, words, out)?;
            }
            return Ok(());
        };
        let positions = stream.positions(printed(found))?;
        let position = |place| positions.get(&place).copied().unwrap_or_default();
        Ok(print_placed(&stream.path, &position, found, words, out)?)
    }
}

/// A program, and what a run of it is to have.
type Begun = (Rc<Program>, Box<dyn FnOnce(Session) -> Session>);

/// `DEPTH=5`, `NAME="A"`: values of parameters by their names in upper case.
fn values(asked: &[String]) -> Result<BTreeMap<String, Value>, Problem> {
    let one = |text: &String| {
        let (name, value) = text.split_once('=').filter(|(name, _)| !name.trim().is_empty())?;
        let value = value.trim();
        let value = match value.parse::<f64>().ok().filter(|number| number.is_finite()) {
            Some(number) => Value::Number(number),
            None => Value::Text(value.trim_matches('"').to_owned()),
        };
        Some((name.trim().to_ascii_uppercase(), value))
    };
    let refused = |text: &String| file::wrong(Message::new("terminal-pair").text("text", printable(text)));
    asked.iter().map(|text| one(text).ok_or_else(|| refused(text))).collect()
}

/// What came out, how the run ended last; why it ended early is among the findings.
fn print_outcome(joined: &Joined, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for ((call, step), other) in outcome.by_call().zip(outcome.trace.entries.others()) {
        let at = other.line.map_or(String::new(), |line| {
            let (path, line) = joined.line(line);
            format!("{}:{}: ", path.display(), line + 1)
        });
        match step {
            Step::Decision { message: decision } => {
                // a subprogram that is no measuring call has its line alone
                let at = if call.is_some() { place(joined, call) } else { at };
                writeln!(out, "{at}{}", words.text(decision))?;
            }
            Step::Message { text, waits } => {
                let key = if *waits { "terminal-waits" } else { "terminal-message" };
                let told = words.text(&Message::new(key).text("text", printable(text)));
                writeln!(out, "{at}{told}")?;
            }
            _ => {}
        }
    }
    print_results(joined, outcome, words, out)?;
    for line in outcome.log() {
        writeln!(out, "{}: {}", words.key("terminal-log"), printable(line))?;
    }
    for change in changes(outcome) {
        writeln!(out, "{}", changed(&change))?;
    }
    for (alarm, call) in outcome.alarms().into_iter().zip(outcome.calls_of_alarms()) {
        let raised = words.text(&Message::new("terminal-raised").text("alarm", alarm.to_string()));
        writeln!(out, "{}{raised}: {}", place(joined, call), words.key(alarms::key(alarm)))?;
    }
    let assumed = outcome.machine_values.iter().map(|one| {
        let at = match joined.within(one.line) {
            (Some(file), line) => format!("{file}:{line}"),
            (None, line) => line.to_string(),
        };
        format!("{} = {} ({at})", one.name, of_machine::shown(&one.value))
    });
    let assumed: Vec<String> = assumed.collect();
    if !assumed.is_empty() {
        let mut told = Message::new("terminal-assumed-values");
        told.args.push(("values", Arg::Text(assumed.join(", "))));
        writeln!(out, "{}", words.text(&told))?;
    }
    writeln!(out, "{}", words.text(&outcome.ending(|line| joined.within(line))))?;
    Ok(())
}

/// `part.mpf:12: CYCLE977: `, what was said there behind it.
fn place(joined: &Joined, call: Option<CallAt>) -> String {
    call.map_or(String::new(), |CallAt { line, cycle }| {
        let (path, line) = joined.line(line);
        format!("{}:{}: {cycle}: ", path.display(), line + 1)
    })
}

/// What is different afterwards, with its unit: that of the basic system, which the program need not have.
pub fn changed(change: &Change) -> String {
    format!("{}: {} -> {}", change.name, rounded(change.before), with_unit(change.after, change.unit))
}

/// As a person reads it.
pub fn with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" => rounded(value).to_string(),
        "deg" => format!("{}°", rounded(value)),
        _ => format!("{} {unit}", rounded(value)),
    }
}

/// What each call measured: its results that have a unit.
fn print_results(joined: &Joined, outcome: &Outcome, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    for left in outcome.left() {
        let measured = left.results.iter().filter(|(field, _)| field.unit != Unit::None);
        let lines = measured.map(|(field, value)| {
            let unit = unit_behind(field.unit, &outcome.control).replace('\u{a0}', " "); // searched with plain blanks
            let meaning = words.key(field.key);
            format!("  {} = {}{unit}  {meaning}", field.name, rounded(*value))
        });
        let lines: Vec<String> = lines.collect();
        if !lines.is_empty() {
            let (path, line) = joined.line(left.call.line);
            writeln!(out, "{}:{}: {}", path.display(), line + 1, left.call.cycle)?;
            writeln!(out, "{}", lines.join("\n"))?;
        }
    }
    Ok(())
}

/// A measuring result screen, as the operator has it.
fn screen(screen: &ResultScreen, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let say = |message: &Message| words.text(message);
    let head = format!("{} {}: {}", screen.cycle, screen.variant, say(&screen.measures));
    writeln!(out, "\n{}\n{head}", say(&screen.title))?;
    let columns = ["screen-set", "screen-actual", "screen-difference"].map(|key| words.key(key));
    let [set, actual, difference] = columns;
    writeln!(out, "{set:>16}{actual:>16}{difference:>16}")?;
    let digits = screen.digits as usize;
    let number = |value: Option<f64>| value.map_or(String::new(), |value| decimals(value, digits));
    for row in &screen.rows {
        let [set, actual, difference] = [row.set, row.actual, row.difference].map(number);
        writeln!(out, "{set:>16}{actual:>16}{difference:>16} {:<4} {}", row.unit, say(&row.label))?;
    }
    for one in &screen.values {
        let value = decimals(one.value, if one.unit.is_empty() { 0 } else { digits });
        writeln!(out, "{value:>16} {:<4} {}", one.unit, say(&one.label))?;
    }
    let until = match screen.until {
        ScreenUntil::End => "screen-until-end",
        ScreenUntil::Start => "screen-until-start",
        ScreenUntil::Next => "screen-until-next",
    };
    writeln!(out, "{}", words.key(until))
}

/// A value with so many decimals; a 0 has no sign.
fn decimals(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let zero = text.bytes().all(|one| matches!(one, b'-' | b'0' | b'.'));
    if zero { text.trim_start_matches('-').to_owned() } else { text }
}
