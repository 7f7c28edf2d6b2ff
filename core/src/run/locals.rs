//! Variables of a program: declared with `DEF`, or parameters of its `PROC`. Elements are in the order of `SET`.

use super::{Datum, Interpreter, Type, datum::replaced, defined};
use crate::control::arrays::{self, stem};
use crate::control::variables;
use crate::diagnostic::Span;
use crate::problem::Problem;
use std::collections::BTreeMap;

/// A variable with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    pub kind: Type,
    /// Sizes; empty for a single value.
    pub sizes: Vec<usize>,
    pub values: Vec<Datum>,
    /// Where it is declared.
    pub place: Span,
}

impl Variable {
    /// A variable of this type and these sizes that nothing was written to.
    pub fn new(kind: Type, sizes: Vec<usize>, place: Span) -> Variable {
        Variable { kind, values: vec![kind.empty(); sizes.iter().product()], sizes, place }
    }
}

/// What a name stands for on a level.
#[derive(Clone, Debug, PartialEq)]
pub enum Local {
    Own(Variable),
    /// A `VAR` parameter: the variable that the call named.
    Other(Home),
}

impl Local {
    /// The variable of this level.
    pub fn own(&self) -> Option<&Variable> {
        if let Local::Own(variable) = self { Some(variable) } else { None }
    }
}

/// Names of a level, in upper case.
pub type Locals = BTreeMap<String, Local>;

/// Where a variable is kept, and its name there with index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Home {
    pub keeper: Keeper,
    pub key: String,
}

/// Who keeps a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeper {
    Level(usize),
    /// The text: every program of it sees the variable (`DEF NCK`, `DEF CHAN`).
    Shared,
    Control,
}

/// Where the variable that a program names is kept.
pub fn home(run: &Interpreter, key: &str) -> Home {
    let (stem, index) = key.split_at(stem(key).len());
    let level = run.levels.len().saturating_sub(1);
    let keeper = match run.levels.last().and_then(|level| level.locals.get(stem)) {
        Some(Local::Own(_)) => Keeper::Level(level),
        Some(Local::Other(home)) => return Home { key: format!("{}{index}", home.key), ..home.clone() },
        None if run.shared.contains_key(stem) => Keeper::Shared,
        None => Keeper::Control,
    };
    Home { keeper, key: key.to_owned() }
}

/// Whether a name without index is a variable of the program, or a datum of a definition file.
pub fn declared(run: &Interpreter, name: &str) -> bool {
    let level = run.levels.last();
    let own = level.is_some_and(|level| level.locals.contains_key(name)) || run.shared.contains_key(name);
    own || defined::find(run, name).is_some()
}

/// Sizes of an array of the program or of a definition file; none: it is another variable.
pub fn sizes(run: &Interpreter, home: &Home) -> Option<Vec<usize>> {
    match home.keeper {
        Keeper::Control => defined::find(run, &home.key).map(|datum| datum.sizes.clone()),
        _ => variable(run, home).map(|variable| variable.sizes.clone()),
    }
}

/// The variable of a program at this place; none: it is one of the control.
pub fn variable<'a>(run: &'a Interpreter, home: &Home) -> Option<&'a Variable> {
    let locals = match home.keeper {
        Keeper::Level(level) => &run.levels.get(level)?.locals,
        Keeper::Shared => &run.shared,
        Keeper::Control => return None,
    };
    locals.get(stem(&home.key))?.own()
}

fn variable_mut<'a>(run: &'a mut Interpreter, home: &Home) -> Option<&'a mut Variable> {
    let locals = match home.keeper {
        Keeper::Level(level) => &mut run.levels.get_mut(level)?.locals,
        Keeper::Shared => &mut run.shared,
        Keeper::Control => return None,
    };
    if let Local::Own(variable) = locals.get_mut(stem(&home.key))? { Some(variable) } else { None }
}

/// Value of a variable of a program: a whole array as a list, a character of a text, a component of a frame.
pub fn read(run: &Interpreter, home: &Home, place: Span) -> Option<Result<Datum, Problem>> {
    let variable = variable(run, home)?;
    Some(taken(run, variable, &home.key).ok_or_else(|| Problem::new("run-index", place, &*home.key)))
}

fn taken(run: &Interpreter, variable: &Variable, key: &str) -> Option<Datum> {
    let index = indices(key);
    if index.is_empty() && !variable.sizes.is_empty() {
        return Some(Datum::List(variable.values.iter().cloned().map(Some).collect()));
    }
    let (at, rest) = element(variable, &index)?;
    let value = variable.values.get(at)?;
    match (value, rest) {
        (_, []) => Some(value.clone()),
        (Datum::Text(text), [number]) => Some(Datum::Text(text.chars().nth(number.parse().ok()?)?.into())),
        (Datum::Frame(frame), [axis, part]) => {
            Some(Datum::Number(variables::component(frame, axis, part)? / component_factor(run, part)))
        }
        _ => None,
    }
}

/// Writes a variable of a program; false: it is one of the control.
pub fn write(run: &mut Interpreter, home: &Home, value: &Datum, place: Span) -> Result<bool, Problem> {
    let key = home.key.as_str();
    let outside = || Problem::new("run-index", place, key);
    let index = indices(key);
    let factor = index.last().map_or(1.0, |part| component_factor(run, part));
    let Some(variable) = variable_mut(run, home) else { return Ok(false) };
    let (at, rest) = element(variable, &index).ok_or_else(outside)?;
    let kind = variable.kind;
    let slot = variable.values.get_mut(at).ok_or_else(outside)?;
    match (&mut *slot, rest) {
        (_, []) => *slot = kind.converted(value).ok_or_else(|| wrong(kind, value, place, key))?,
        (Datum::Text(text), [number]) => {
            let code = Type::Char.converted(value);
            *text = code.and_then(|code| replaced(text, number, &code.shown())).ok_or_else(outside)?;
        }
        (Datum::Frame(frame), [axis, part]) => {
            let number = value.number().ok_or_else(|| Problem::new("run-not-a-number", place, key))?;
            if !variables::set_component(frame, axis, part, number * factor) {
                return Err(outside());
            }
        }
        _ => return Err(outside()),
    }
    Ok(true)
}

/// A value that its variable cannot hold.
pub fn wrong(kind: Type, value: &Datum, place: Span, key: &str) -> Problem {
    match (kind, value) {
        (Type::Text(length), Datum::Text(_)) => {
            Problem::new("run-text-long", place, key).number("limit", length as f64)
        }
        (Type::Real | Type::Int | Type::Char, Datum::Number(_)) => Problem::new("run-range", place, key),
        _ => Problem::new("run-type", place, key),
    }
}

/// mm in the unit of a component of a frame; angles, factors and mirrors have none.
pub fn component_factor(run: &Interpreter, part: &str) -> f64 {
    match part {
        "TR" | "FI" => run.sim.control.data_factor(),
        _ => 1.0,
    }
}

/// Element that the first indices name, and the indices behind them.
fn element<'i, 'k>(variable: &Variable, index: &'i [&'k str]) -> Option<(usize, &'i [&'k str])> {
    let (own, rest) = index.split_at_checked(variable.sizes.len())?;
    let own: Vec<usize> = own.iter().map(|number| number.parse().ok()).collect::<Option<_>>()?;
    Some((arrays::place(&own, &variable.sizes)?, rest))
}

/// The indices of a name, as written in its key.
pub fn indices(key: &str) -> Vec<&str> {
    match key.split_once('[') {
        Some((_, rest)) => rest.trim_end_matches(']').split(',').collect(),
        None => Vec::new(),
    }
}
