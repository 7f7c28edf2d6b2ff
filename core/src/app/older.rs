//! Measuring programs of the 840C: what each R parameter means, and the program with the names of today.

use super::finding::{Edit, Finding, edits, placed};
use super::{Error, ProgramText};
use crate::catalogue::CYCLES;
use crate::catalogue::r_parameters::{SETPOINTS, number, numbers, printed};
use crate::check;
use crate::control::delivery;
use crate::dialect::Dialect;
use crate::entry::{Typed, names};
use crate::message::Message;
use crate::name::Name;
use crate::program::r_parameters::{
    Answers, Assigned, Call, Older, edits as of_program, find, findings, left_out, reasons,
};
use crate::refused::Path;
use crate::syntax::position::Positions;
use crate::syntax::programs::programs;
use crate::syntax::{self, Program};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A program, and what is answered where the manual leaves a parameter open.
#[derive(Clone, Debug)]
pub struct OlderRequest {
    /// Text of the program.
    pub text: ProgramText,
    /// R parameter and the name that it is: `R19`, `_SZA`.
    pub answers: BTreeMap<String, String>,
}

/// The measuring calls of an 840C in a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OlderView {
    /// The calls in the order of the text.
    pub calls: Vec<OlderCall>,
    /// Edits that write them as calls of today; none: nothing to convert, or a question is open.
    pub edits: Vec<Edit>,
    /// What is to be said, questions among it.
    pub findings: Vec<Finding>,
}

/// A measuring call.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OlderCall {
    /// As it is called, `L977`.
    pub name: String,
    /// The cycle of today.
    pub cycle: &'static str,
    /// Line of the call, from 1.
    pub line: u32,
    /// What reaches it, in the order of the R parameters.
    pub parameters: Vec<OlderParameter>,
    /// What nothing gives a value, so that the value of an earlier call counts (B:1696).
    pub left_open: Vec<OlderLeft>,
}

/// A parameter that a call leaves open.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OlderLeft {
    /// The R parameter that it was, `R27`.
    pub parameter: String,
    /// Its name and meaning today.
    #[serde(flatten)]
    pub name: OlderName,
    /// The value on delivery.
    pub delivered: f64,
}

/// An R parameter that reaches a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OlderParameter {
    /// The assignment as it is written, `R19=-20`.
    pub text: String,
    /// Its line, from 1.
    pub line: u32,
    /// The names that it may be, each with its meaning here; none: this variant does not use it, or `instead`.
    pub names: Vec<OlderName>,
    /// The R parameter that is this parameter in its place, `R32`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instead: Option<String>,
}

/// A parameter of today.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OlderName {
    /// Its name.
    pub name: Name,
    /// What it means in this call.
    pub label: Message,
}

/// The calls, what their parameters mean, and the program with the names of today.
///
/// # Errors
/// An answer that no R parameter of the 840C can have.
pub fn older(asked: OlderRequest) -> Result<OlderView, Error> {
    let program = syntax::read_held(Dialect::Sinumerik, &asked.text.0, &Arc::default(), &mut |_| {});
    let programs = programs(&program);
    let older = find(&program, &programs, &answers(&asked.answers)?);
    let positions = Positions::new(&program.source);
    let mut found = Vec::new();
    findings(&program, &programs, &older, &mut found);
    found.extend(reasons(&program, &programs, &older));
    found.sort_by_key(|one| one.span.map_or(0, |span| span.start));
    Ok(OlderView {
        calls: older.calls.iter().map(|call| told(&program, &older, call)).collect(),
        edits: edits(&of_program(&program, &older), &positions),
        findings: placed(&found, &positions),
    })
}

/// Answers as they are given, by the numbers of their R parameters.
///
/// # Errors
/// No cycle has this name for this R parameter, or two answers contradict each other.
pub fn answers<'a>(asked: impl IntoIterator<Item = (&'a String, &'a String)>) -> Result<Answers, Error> {
    let mut answers = Answers::new();
    for (parameter, value) in asked {
        let number = number(&parameter.to_ascii_uppercase()).unwrap_or_default();
        let mut all = CYCLES.iter().flat_map(|cycle| printed(cycle, number));
        let name = all.find(|known| known.eq_ignore_ascii_case(value)).ok_or_else(|| {
            Error::new("older-answer-unknown", Path::of(&["answers"])).text("name", parameter).text("value", value)
        })?;
        if let Some(other) = answers.insert(number, name).filter(|other| *other != name) {
            return Err(contradiction((number, other), (number, name)));
        }
    }
    let [first, second] = SETPOINTS.map(|number| Some((number, *answers.get(&number)?)));
    first.zip(second).map_or(Ok(answers), |(first, second)| Err(contradiction(first, second)))
}

/// Of an R parameter that is two names, or two that are one.
fn contradiction(first: (u16, Name), second: (u16, Name)) -> Error {
    let text = |(number, name): (u16, Name)| format!("R{number}={name}");
    Error::new("older-answer-twice", Path::of(&["answers"])).text("first", text(first)).text("second", text(second))
}

fn told(program: &Program, older: &Older, call: &Call) -> OlderCall {
    let reaching: Vec<&Assigned> = numbers()
        .filter_map(|number| call.given.get(&number))
        .flatten()
        .filter_map(|at| older.assigned.get(*at))
        .collect();
    let names = |one: &Assigned| call.names.get(&one.number).into_iter().flatten().copied();
    let value = |one: &Assigned| program.written(program.place(one.value));
    let typed: Typed = reaching.iter().filter_map(|one| Some((names(one).next()?.to_string(), value(one)))).collect();
    let inputs = check::read(call.cycle, &typed, &delivery(Dialect::Sinumerik), &mut Vec::new());
    let named = |name: Name| {
        let param = call.cycle.param(&name)?;
        let key = if name == names::MVAR { variant(call, &typed) } else { None };
        let key = key.unwrap_or_else(|| format!("param-{}", param.label(&inputs)));
        Some(OlderName { name, label: Message::new(key) })
    };
    let parameter = |one: &&Assigned| OlderParameter {
        text: one.text(program),
        line: program.line_of(one.word.start) + 1,
        names: names(one).filter_map(named).collect(),
        instead: call.instead.get(&one.number).map(|rival| format!("R{rival}")),
    };
    let left = left_out(program, older, call).into_iter().filter_map(|(number, name, delivered)| {
        Some(OlderLeft { parameter: format!("R{number}"), name: named(name)?, delivered })
    });
    OlderCall {
        name: program.name(call.name),
        cycle: call.cycle.name,
        line: program.line_of(call.name.start) + 1,
        parameters: reaching.iter().map(parameter).collect(),
        left_open: left.collect(),
    }
}

/// The key of the variant, where its number is known.
fn variant(call: &Call, typed: &Typed) -> Option<String> {
    let number: f64 = typed.get(names::MVAR.as_str())?.trim().parse().ok()?;
    let variant = call.cycle.variants.iter().find(|one| one.number as f64 == number)?;
    Some(variant.key.to_owned())
}
