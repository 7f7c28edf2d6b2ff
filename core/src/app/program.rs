//! The measuring calls of a program, and what is wrong with it.

use super::beside::{Beside, FileStart, Whole};
use super::finding::{Finding, placed};
use super::places::{self, Places};
use super::start::{Machine, start};
use super::{Error, ProgramText};
use crate::control::{Control, Plane, Transverse, UnitFunction, delivery};
use crate::dialect::Dialect;
use crate::entry::{Style, Typed};
use crate::message::Message;
use crate::name::Name;
use crate::program::calls::{CallSite, calls_told};
use crate::program::others::{Other, others as without_form};
use crate::program::touched::cured_elsewhere;
use crate::program::user_programs::UserPrograms;
use crate::syntax::position::Positions;
use crate::syntax::programs::{Unit, bare, programs};
use crate::syntax::{Program, Word, WordKind};
use crate::{program, syntax};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Which program is read.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ReadRequest {
    /// Control.
    pub control: Dialect,
    /// Text of the program.
    pub text: ProgramText,
    /// Machine on which it starts; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Files beside it: its subprograms, definition files; absent: none.
    pub with: Option<Vec<Beside>>,
}

/// A program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ReadView {
    /// Measuring calls of the program in order.
    pub calls: Vec<CallView>,
    /// Calls of cycles that have no form: they are read and explained.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<OtherCall>>"))]
    pub others: Vec<OtherCall>,
    /// What is wrong with it.
    pub diagnostics: Vec<Finding>,
    /// Where the files beside it begin.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<FileStart>>"))]
    pub files: Vec<FileStart>,
    /// Its programs, where the text holds several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<ProgramPlace>>"))]
    pub programs: Vec<ProgramPlace>,
    /// Parameters of its own `PROC`, which have no caller where it is run.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<ProgramParameter>>"))]
    pub parameters: Vec<ProgramParameter>,
}

/// A call of a cycle that has no form.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OtherCall {
    /// Cycle as it is called.
    pub cycle: String,
    /// What it does.
    pub title: Message,
    /// Line of the call, from 1.
    pub line: u32,
    /// Where it begins in the text, UTF-16 units.
    pub from: u32,
    /// What stands at its arguments, by their names in the published list.
    #[serde(skip_serializing_if = "Typed::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Typed>"))]
    pub values: Typed,
}

/// A program of a text that holds several.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ProgramPlace {
    /// As a call writes it.
    pub name: String,
    /// Its first block, UTF-16 units.
    pub from: u32,
    /// Line of that block, from 1.
    pub line: u32,
    /// Parameters of its `PROC`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<ProgramParameter>>"))]
    pub parameters: Vec<ProgramParameter>,
}

/// A parameter of the `PROC` of a program that is run as main program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ProgramParameter {
    /// Its name, in upper case.
    pub name: String,
    /// Its type, as the control calls it.
    pub kind: String,
    /// Whether it has a default.
    pub optional: bool,
}

/// A measuring call of a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CallView {
    /// Control.
    pub control: Dialect,
    /// Cycle.
    pub cycle: &'static str,
    /// Stem of its messages.
    pub key: &'static str,
    /// Number of the variant, where it is known.
    pub mvar: Option<i64>,
    /// What it is called, where it is written in a list of newer controls and its variant is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional, as = "Option<Message>"))]
    pub title: Option<Message>,
    /// First line with an assignment that belongs to it, from 1.
    pub line: u32,
    /// Line of the call itself.
    pub last_line: u32,
    /// Where the call itself begins in the text, UTF-16 units.
    pub from: u32,
    /// One past its end.
    pub to: u32,
    /// How it is written.
    pub style: Style,
    /// Values that arrive at it, as a form wants them.
    pub values: Typed,
    /// Of those that are the worth of an expression: as it is written.
    pub expressions: Typed,
    /// Of the values that differ by the way or from pass to pass: those that arrive first.
    pub first: BTreeMap<Name, Arrival>,
    /// Where each value is written that is written in one place: first UTF-16 unit, and one past the end.
    pub places: Places,
    /// Working plane there.
    pub plane: Plane,
    /// How X is given there.
    pub transverse: Transverse,
    /// G function of units active there.
    pub units: UnitFunction,
    /// What is wrong with it.
    pub diagnostics: Vec<Finding>,
    /// Notes at values that come from other programs of the text, or differ by the way to the call; without a parameter
    /// those about the user's programs that run before and after it.
    pub arrivals: Vec<Finding>,
}

/// A value that arrives at a call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Arrival {
    /// As it is written.
    pub value: String,
    /// Line of the assignment, from 1.
    pub line: u32,
}

/// Of reading: until the text is read, and until its calls are found. What is left are warnings about the whole.
const SHARES: [f64; 2] = [0.6, 0.9];

/// Findings that travel: with more of them it is another sort of file, not a program with mistakes.
const MOST_FINDINGS: usize = 10_000;

/// Reads a program, telling from time to time which share of the work is done; short programs are done at once.
///
/// ```
/// use probewright_core::app::{ReadRequest, read};
/// use probewright_core::dialect::Dialect;
///
/// let text = "_MVAR=1 _SETVAL=132\nCYCLE977\nM30\n".into();
/// let view = read(ReadRequest { control: Dialect::Sinumerik, text, setup: None, with: None }, &mut |_| {})?;
/// let [call] = &view.calls[..] else { unreachable!() };
/// assert_eq!((call.cycle, call.line, call.values["_SETVAL"].as_str()), ("CYCLE977", 1, "132"));
/// # Ok::<(), probewright_core::app::Error>(())
/// ```
///
/// # Errors
/// The machine has no such G function of units.
pub fn read(asked: ReadRequest, told: &mut dyn FnMut(f64)) -> Result<ReadView, Error> {
    let [text, calls] = SHARES;
    let whole = Whole::new(asked.control, asked.text, asked.with);
    let control = start(asked.control, asked.setup)?.setup.control;
    let macros = &control.definitions.macros;
    let program = syntax::read_held(asked.control, whole.text(), macros, &mut |share| told(share * text));
    Ok(view(&program, &whole, control, &mut |share| told(text + share * (calls - text))))
}

/// The measuring calls of a program on a metric control as delivered.
pub fn calls(program: &Program) -> ReadView {
    calls_on(program, delivery(program.dialect))
}

/// The measuring calls of a program that starts on a control in this state.
pub fn calls_on(program: &Program, control: Control) -> ReadView {
    let whole = Whole::new(program.dialect, ProgramText::default(), None);
    view(program, &whole, control, &mut |_| {})
}

/// Of the files beside it the calls are left out: each shows them where it is opened itself.
fn view(program: &Program, whole: &Whole, control: Control, told: &mut dyn FnMut(f64)) -> ReadView {
    let positions = Positions::new(&program.source);
    let sites = calls_told(program, control.clone(), told);
    let mut found = program::findings_of(program, &sites, &control);
    found.truncate(MOST_FINDINGS);
    let finding = |one| {
        let elsewhere = Some(cured_elsewhere(program, &sites, one)).filter(|lines| !lines.is_empty());
        Finding { elsewhere, ..Finding::placed(one, &positions) }
    };
    let around = UserPrograms::of(program);
    let own = sites.iter().filter(|site| whole.of_program(site.span.start));
    ReadView {
        diagnostics: found.iter().map(finding).collect(),
        calls: own.map(|site| call(program, site, &around, &positions)).collect(),
        others: others(program, whole, &positions),
        files: whole.files(&positions),
        programs: places_of(program, whole, &positions),
        parameters: programs(program).units.first().map_or_else(Vec::new, |main| parameters(program, main)),
    }
}

/// The calls of cycles that have no form.
fn others(program: &Program, whole: &Whole, positions: &Positions) -> Vec<OtherCall> {
    let own = without_form(program).filter(|other| whole.of_program(other.span.start));
    own.map(|Other { name, title, span, arguments }| {
        let (line, _) = positions.line_column(span.start);
        let values = arguments.into_iter().map(|(name, text)| (name.to_owned(), text)).collect();
        OtherCall { cycle: name, title, line, from: positions.utf16(span.start), values }
    })
    .collect()
}

/// The programs of the text itself, where it holds several that have a name.
fn places_of(program: &Program, whole: &Whole, positions: &Positions) -> Vec<ProgramPlace> {
    let all = programs(program);
    let place = |unit: &Unit| {
        let declared = || program.signature(unit).iter().find_map(Word::declared).map(|name| program.name(name));
        let name = unit.file.as_deref().map(bare).map(str::to_owned).or_else(declared)?;
        let start = program.blocks.get(unit.blocks.start).map(|block| block.span.start)?;
        let (line, _) = positions.line_column(start);
        let place = || ProgramPlace { name, from: positions.utf16(start), line, parameters: parameters(program, unit) };
        whole.of_program(start).then(place)
    };
    let found: Vec<_> = all.units.iter().filter_map(place).collect();
    if found.len() > 1 { found } else { Vec::new() }
}

/// The parameters of a program of the text that a single value can be given.
fn parameters(program: &Program, unit: &Unit) -> Vec<ProgramParameter> {
    let words = program.signature(unit);
    let mut kind = String::new();
    let mut found = Vec::new();
    let mut named = false;
    for word in words {
        match &word.kind {
            WordKind::Keyword { name, .. } => kind = program.name(*name),
            WordKind::Declare { .. } if !named => named = true,
            WordKind::Declare { name, index, value } if index.is_empty() => found.push(ProgramParameter {
                name: program.name(*name),
                kind: std::mem::take(&mut kind),
                optional: value.is_some(),
            }),
            _ => {}
        }
    }
    found
}

fn call(program: &Program, site: &CallSite, around: &UserPrograms, positions: &Positions) -> CallView {
    let mut control = delivery(site.cycle.dialect);
    control.plane = site.plane;
    let variant = site.variant(&control);
    let arrival = |origin: &program::calls::Origin| Arrival {
        value: origin.text.clone(),
        line: program.line_of(origin.place.start) + 1,
    };
    CallView {
        control: program.dialect,
        cycle: site.cycle.name,
        key: site.cycle.key,
        mvar: variant,
        title: site.newer_list().and_then(|_| site.title(&control)),
        line: site.first_line + 1,
        last_line: site.line + 1,
        from: positions.utf16(site.span.start),
        to: positions.utf16(site.span.end),
        style: site.list.map_or(Style::Direct, |list| list.style),
        values: site.values.clone(),
        expressions: site.expressions.clone(),
        first: site.first.iter().map(|(name, origin)| (*name, arrival(origin))).collect(),
        places: places::of_call(program, site, positions),
        plane: site.plane,
        transverse: site.transverse,
        units: site.unit_function,
        diagnostics: placed(&site.diagnostics, positions),
        arrivals: placed(&[program::arrivals(program, site), around.around(site.cycle)].concat(), positions),
    }
}
