//! Reading, changing and running program text. The page counts in UTF-16 units, the core in bytes.

use super::setup_active::units_name;
use super::setup_write::{plane_name, transverse_name};
use super::start::start;
use super::{Error, diagnostic, dialect, dialect_name, message, object, put, style_name, typed};
use crate::check::variants;
use crate::control::{Control, delivery};
use crate::diagnostic::Diagnostic;
use crate::entry::unit_name;
use crate::entry::{ResultField, Style};
use crate::machine::setup::Setup;
use crate::machine::trace::Step;
use crate::message::Message;
use crate::program::calls::{CallSite, calls_told};
use crate::program::change::{Edit, apply};
use crate::program::revise::revise;
use crate::program::touched::{Line, cured_elsewhere};
use crate::program::{self};
use crate::run::left::{CallAt, Left};
use crate::run::outcome::{Outcome, PassedOver};
use crate::run::{Limits, Session};
use crate::syntax;
use crate::syntax::Program;
use crate::syntax::position::Positions;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeSet;

#[derive(Deserialize)]
struct ReadRequest {
    control: String,
    text: String,
    #[serde(default)]
    setup: Option<Value>,
}

#[derive(Deserialize)]
struct ChangeRequest {
    control: String,
    text: String,
    call: usize,
    name: String,
    value: String,
    #[serde(default)]
    setup: Option<Value>,
}

#[derive(Deserialize)]
struct ConvertRequest {
    control: String,
    text: String,
    call: usize,
    style: String,
    #[serde(default)]
    setup: Option<Value>,
}

#[derive(Deserialize)]
struct RunRequest {
    control: String,
    text: String,
    #[serde(default)]
    setup: Option<Value>,
}

/// Of reading: until the text is read, and until its calls are found. What is left are doubts about the whole.
const SHARES: [f64; 2] = [0.6, 0.9];

/// Findings that travel: with more of them it is another sort of file, not a program with mistakes.
const MOST_FINDINGS: usize = 10_000;

/// Answers a `ReadRequest` with a `ReadView`: every measuring call, and what is wrong.
pub fn read(request: &str) -> Result<Value, Error> {
    read_told(request, &mut |_| {})
}

/// The same, telling from time to time which share of the work is done; short programs are done at once.
pub fn read_told(request: &str, told: &mut dyn FnMut(f64)) -> Result<Value, Error> {
    let request: ReadRequest = super::request(request)?;
    let dialect = dialect(&request.control)?;
    let [text, calls] = SHARES;
    let source = request.text.as_bytes();
    let program = syntax::read_told(dialect, source, &mut |share| told(share * text));
    let mut found = |share: f64| told(text + share * (calls - text));
    let control = start(dialect, request.setup)?.setup.control;
    Ok(view(&program, control, &mut found))
}

/// The measuring calls of a program as a `ReadView`; the control is a metric one as delivered.
pub fn calls(program: &Program) -> Value {
    view(program, delivery(program.dialect), &mut |_| {})
}

fn view(program: &Program, control: Control, told: &mut dyn FnMut(f64)) -> Value {
    let positions = Positions::new(&program.source);
    let sites = calls_told(program, control.clone(), told);
    let calls: Vec<Value> = sites.iter().map(|site| call(program, site, &positions)).collect();
    let mut found = program::findings_of(program, &sites, &control);
    found.truncate(MOST_FINDINGS);
    let found = found.iter().map(|one| {
        let mut view = placed(one, &positions);
        let lines = cured_elsewhere(program, &sites, one);
        if !lines.is_empty() {
            put(&mut view, "elsewhere", touched(&lines));
        }
        view
    });
    object([("calls", calls.into()), ("diagnostics", found.collect())])
}

fn call(program: &Program, site: &CallSite, positions: &Positions) -> Value {
    let style = site.list.map_or(Style::Direct, |list| list.style);
    object([
        ("control", dialect_name(program.dialect).into()),
        ("cycle", site.cycle.name.into()),
        ("key", site.cycle.key.into()),
        ("mvar", variant(site).into()),
        ("line", (site.first_line + 1).into()),
        ("lastLine", (site.line + 1).into()),
        ("from", positions.utf16(site.span.start).into()),
        ("to", positions.utf16(site.span.end).into()),
        ("style", style_name(style).into()),
        ("values", typed(&site.values)),
        ("expressions", typed(&site.expressions)),
        ("first", first(program, site)),
        ("plane", plane_name(site.plane).into()),
        ("transverse", transverse_name(site.transverse).into()),
        ("units", units_name(site.unit_function).into()),
        ("diagnostics", findings(&site.diagnostics, positions).into()),
        ("arrivals", findings(&program::arrivals(program, site), positions).into()),
    ])
}

/// Of the values that differ by the way, those that arrive first, with their lines.
fn first(program: &Program, site: &CallSite) -> Value {
    let members = site.first.iter().map(|(name, origin)| {
        let line = program.line_of(origin.place.start) + 1;
        let value = [("value", origin.text.as_str().into()), ("line", line.into())];
        (name.as_str(), object(value))
    });
    object(members)
}

/// Number of the measuring variant, where it is known.
fn variant(site: &CallSite) -> Option<i64> {
    let mut control = delivery(site.cycle.dialect);
    control.plane = site.plane;
    variants::chosen(site.cycle, &site.values, &control)
}

/// Findings with their places.
fn findings(list: &[Diagnostic], positions: &Positions) -> Vec<Value> {
    list.iter().map(|found| placed(found, positions)).collect()
}

/// What is wrong with a program, with the places in its text.
pub fn diagnostics(list: &[Diagnostic], source: &[u8]) -> Value {
    findings(list, &Positions::new(source)).into()
}

fn placed(found: &Diagnostic, positions: &Positions) -> Value {
    let mut value = diagnostic(found);
    if let Some(span) = found.span {
        let (line, column) = positions.line_column(span.start);
        put(&mut value, "from", positions.utf16(span.start));
        put(&mut value, "to", positions.utf16(span.end));
        put(&mut value, "line", line);
        put(&mut value, "column", column);
    }
    if let Some(cure) = &found.cure {
        let edits = cure.edits.iter().map(|edit| placed_edit(edit, positions));
        let members = [("label", message(&cure.label)), ("edits", edits.collect())];
        put(&mut value, "cure", object(members));
    }
    value
}

/// Answers a `ChangeRequest` with a `Changed`: edits, the only places of the text that change, and the lines of others.
pub fn change(request: &str) -> Result<Value, Error> {
    let request: ChangeRequest = super::request(request)?;
    let dialect = dialect(&request.control)?;
    let mut program = syntax::read(dialect, request.text.as_bytes());
    let control = start(dialect, request.setup)?.setup.control;
    let done = revise(&program, request.call, &request.name, &request.value, &control);
    let done = done.ok_or_else(|| super::unknown("document-call", &request.call.to_string()))?;
    let mut steps: Vec<Value> = Vec::new();
    for edits in &done.steps {
        let positions = Positions::new(&program.source);
        let placed = edits.iter().map(|edit| placed_edit(edit, &positions));
        steps.push(placed.collect());
        program = syntax::read(dialect, &apply(&program.source, edits));
    }
    Ok(object([
        ("steps", steps.into()),
        ("elsewhere", touched(&done.elsewhere)),
        ("taken", done.taken.into()),
        ("findings", findings(&done.findings, &Positions::new(b"")).into()),
    ]))
}

/// Lines that would change, counted from 1.
fn touched(lines: &[Line]) -> Value {
    let line = |one: &Line| {
        object([
            ("line", (one.line + 1).into()),
            ("before", one.before.as_str().into()),
            ("after", one.after.as_str().into()),
        ])
    };
    lines.iter().map(line).collect()
}

fn placed_edit(edit: &Edit, positions: &Positions) -> Value {
    object([
        ("from", positions.utf16(edit.span.start).into()),
        ("to", positions.utf16(edit.span.end).into()),
        ("insert", edit.insert.as_str().into()),
    ])
}

/// Answers a `ConvertRequest`: edits that write the call in another way, and what has to be said about it.
pub fn convert(request: &str) -> Result<Value, Error> {
    let request: ConvertRequest = super::request(request)?;
    let dialect = dialect(&request.control)?;
    let program = syntax::read(dialect, request.text.as_bytes());
    let style = super::style(&request.style)?;
    let control = start(dialect, request.setup)?.setup.control;
    let done = program::convert::convert(&program, request.call, style, &control);
    let positions = Positions::new(&program.source);
    let edits = done.edits.iter().map(|edit| placed_edit(edit, &positions));
    Ok(object([("edits", edits.collect()), ("findings", findings(&done.findings, &positions).into())]))
}

/// The answer to a `RunRequest` in pieces, so that whoever waits for it can be told how far it is, halt it and leave
/// it.
pub struct Run {
    session: Session,
    setup: Setup,
    source: Vec<u8>,
}

impl Run {
    /// A run before its first block.
    pub fn new(request: &str) -> Result<Run, Error> {
        let request: RunRequest = super::request(request)?;
        let dialect = dialect(&request.control)?;
        let setup = start(dialect, request.setup)?.setup;
        let program = syntax::read(dialect, request.text.as_bytes());
        Ok(Run { session: Session::new(program, &setup, Limits::default()), setup, source: request.text.into_bytes() })
    }

    /// Carries out about so many blocks; true: the run is over.
    pub fn advance(&mut self, blocks: usize) -> bool {
        self.session.advance(blocks)
    }

    /// How much of the main program is done, 0 to 1.
    pub fn share(&self) -> f64 {
        self.session.share()
    }

    /// What it did so far, as a `RunView`.
    pub fn view(self) -> Value {
        run_outcome(&self.setup, &self.session.outcome(), &self.source)
    }
}

/// A result of the run: what it means, where a call left it, and which one.
fn result(name: &str, value: f64, meaning: Option<(&ResultField, CallAt)>, of: &Control) -> Value {
    let mut result = object([("name", name.into()), ("value", value.into())]);
    if let Some((field, call)) = meaning {
        put(&mut result, "label", super::key(field.key));
        put(&mut result, "unit", unit_name(field.unit, of));
        put_call(&mut result, Some(call));
    }
    result
}

/// A word that the run went on without, and its line.
fn passed_over(one: &PassedOver) -> Value {
    object([("word", one.word.as_str().into()), ("line", one.line.into())])
}

/// The call to which something belongs, its line counted from 1.
fn put_call(view: &mut Value, call: Option<CallAt>) {
    if let Some(CallAt { line, cycle }) = call {
        put(view, "line", line + 1);
        put(view, "cycle", cycle);
    }
}

/// The results of each call; behind them what the program wrote beside them.
fn results(outcome: &Outcome) -> Vec<Value> {
    let control = &outcome.control;
    let mut all = Vec::new();
    let mut told = BTreeSet::new();
    for Left { line, cycle, results } in outcome.left() {
        let call = CallAt { line, cycle };
        for (field, value) in results {
            told.insert(field.name);
            all.push(result(field.name, value, Some((field, call)), control));
        }
    }
    let written = outcome.written().into_iter();
    let rest = written.filter(|(name, _)| !told.contains(name));
    all.extend(rest.map(|(name, value)| result(name, value, None, control)));
    all
}

/// What the cycles decided, in order, each with its call.
fn decisions(outcome: &Outcome) -> Vec<Value> {
    let steps = outcome.by_call().filter_map(|(call, step)| match step {
        Step::Decision(text) => Some((call, text)),
        _ => None,
    });
    let view = |(call, text): (Option<CallAt>, &Message)| {
        let mut view = object([("message", message(text))]);
        put_call(&mut view, call);
        view
    };
    steps.map(view).collect()
}

/// The alarms in order, each with the call that raised it.
fn alarms(outcome: &Outcome) -> Vec<Value> {
    let steps = outcome.by_call();
    let calls = steps.filter_map(|(call, step)| matches!(step, Step::Alarm(_)).then_some(call));
    let last = outcome.by_call().last().and_then(|(call, _)| call);
    let mut alarms = super::trace::alarms(outcome);
    for (alarm, call) in alarms.iter_mut().zip(calls.chain(std::iter::repeat(last))) {
        put_call(alarm, call);
    }
    alarms
}

/// What was assumed for a program that came without a machine, in words and as a setup file.
pub fn assumed(told: &[Message], setup: &Setup) -> Value {
    let messages = told.iter().map(message);
    object([("messages", messages.collect()), ("setup", super::setup_to_json(setup))])
}

/// What a program did, as a `RunView`.
pub fn run_outcome(setup: &Setup, outcome: &Outcome, source: &[u8]) -> Value {
    object([
        ("trace", super::trace::trace(setup, outcome)),
        ("diagnostics", findings(&outcome.diagnostics, &Positions::new(source)).into()),
        ("results", results(outcome).into()),
        ("decisions", decisions(outcome).into()),
        ("changes", super::changes::changes(outcome).into()),
        ("alarms", alarms(outcome).into()),
        ("log", outcome.log().into()),
        ("finished", outcome.finished().into()),
        ("passedOver", outcome.passed_over.iter().map(passed_over).collect()),
        ("ending", message(&outcome.ending())),
    ])
}
