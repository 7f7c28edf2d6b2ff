//! Variables of a program: declared with `DEF`, or parameters of its `PROC`. Arrays hold their elements in the order in
//! which `SET` fills them.

use super::datum::Datum;
use super::interpret::Interpreter;
use super::types::Type;
use crate::control::{arrays, variables};
use crate::diagnostic::Span;
use crate::problem::Problem;
use std::collections::BTreeMap;

/// A variable with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Type of each element.
    pub kind: Type,
    /// Sizes; empty for a single value.
    pub sizes: Vec<usize>,
    /// Values, one an element.
    pub values: Vec<Datum>,
    /// Where it is declared.
    pub place: Span,
}

impl Variable {
    /// A variable of this type and these sizes that nothing was written to.
    pub fn new(kind: Type, sizes: Vec<usize>, place: Span) -> Variable {
        let count = sizes.iter().product();
        Variable { kind, sizes, values: vec![kind.empty(); count], place }
    }
}

/// What a name stands for on a level.
#[derive(Clone, Debug, PartialEq)]
pub enum Local {
    /// A variable of this level.
    Own(Variable),
    /// A `VAR` parameter: the variable that the call named.
    Other(Home),
}

/// Names of a level, in upper case.
pub type Locals = BTreeMap<String, Local>;

/// Where a variable is kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Home {
    /// On a program level, by its name with index.
    Level(usize, String),
    /// Among those that every program of the text sees (`DEF NCK`, `DEF CHAN`).
    Shared(String),
    /// In the control.
    Control(String),
}

/// Where the variable that a program names is kept.
pub fn home(run: &Interpreter, key: &str) -> Home {
    let (stem, index) = key.split_at(key.find('[').unwrap_or(key.len()));
    let level = run.levels.len().saturating_sub(1);
    match run.levels.last().and_then(|level| level.locals.get(stem)) {
        Some(Local::Own(_)) => Home::Level(level, key.to_owned()),
        Some(Local::Other(home)) => {
            let behind = |name: &String| format!("{name}{index}");
            match home {
                Home::Level(level, name) => Home::Level(*level, behind(name)),
                Home::Shared(name) => Home::Shared(behind(name)),
                Home::Control(name) => Home::Control(behind(name)),
            }
        }
        None if run.shared.contains_key(stem) => Home::Shared(key.to_owned()),
        None => Home::Control(key.to_owned()),
    }
}

/// Whether a name without index is a variable of the program.
pub fn declared(run: &Interpreter, name: &str) -> bool {
    let level = run.levels.last();
    level.is_some_and(|level| level.locals.contains_key(name)) || run.shared.contains_key(name)
}

/// The variable of a program at this place; none: it is one of the control.
pub fn variable<'a>(run: &'a Interpreter, home: &Home) -> Option<&'a Variable> {
    let (locals, key) = match home {
        Home::Level(level, key) => (&run.levels.get(*level)?.locals, key),
        Home::Shared(key) => (&run.shared, key),
        Home::Control(_) => return None,
    };
    match locals.get(stem(key))? {
        Local::Own(variable) => Some(variable),
        Local::Other(_) => None,
    }
}

fn variable_mut<'a>(run: &'a mut Interpreter, home: &Home) -> Option<&'a mut Variable> {
    let (locals, key) = match home {
        Home::Level(level, key) => (&mut run.levels.get_mut(*level)?.locals, key),
        Home::Shared(key) => (&mut run.shared, key),
        Home::Control(_) => return None,
    };
    match locals.get_mut(stem(key))? {
        Local::Own(variable) => Some(variable),
        Local::Other(_) => None,
    }
}

/// Value of a variable of a program: a whole array as a list, a character of a text, a component of a frame.
pub fn read(run: &Interpreter, home: &Home, place: Span) -> Option<Result<Datum, Problem>> {
    let (Home::Level(_, key) | Home::Shared(key)) = home else {
        return None;
    };
    let variable = variable(run, home)?;
    let refused = || Problem::new("run-index", place, key.as_str());
    Some(taken(run, variable, key).ok_or_else(refused))
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
        (Datum::Text(text), [number]) => {
            let character = text.chars().nth(number.parse().ok()?)?;
            Some(Datum::Text(character.into()))
        }
        (Datum::Frame(frame), [axis, part]) => {
            let value = variables::component(frame, axis, part)?;
            Some(Datum::Number(value / component_factor(run, part)))
        }
        _ => None,
    }
}

/// Writes a variable of a program; none: it is one of the control.
pub fn write(run: &mut Interpreter, home: &Home, value: &Datum, place: Span) -> Option<Result<(), Problem>> {
    let (Home::Level(_, key) | Home::Shared(key)) = home else {
        return None;
    };
    variable(run, home)?;
    Some(put(run, home, key, value, place))
}

fn put(run: &mut Interpreter, home: &Home, key: &str, value: &Datum, place: Span) -> Result<(), Problem> {
    let outside = || Problem::new("run-index", place, key);
    let index = indices(key);
    let factor = index.last().map_or(1.0, |part| component_factor(run, part));
    let variable = variable_mut(run, home).ok_or_else(outside)?;
    let (at, rest) = element(variable, &index).ok_or_else(outside)?;
    let kind = variable.kind;
    let slot = variable.values.get_mut(at).ok_or_else(outside)?;
    match (&mut *slot, rest) {
        (_, []) => *slot = kind.converted(value).ok_or_else(|| wrong(kind, value, place, key))?,
        (Datum::Text(text), [number]) => {
            let code = Type::Char.converted(value);
            let changed = code.and_then(|code| replaced(text, number, &code.shown()));
            *text = changed.ok_or_else(outside)?;
        }
        (Datum::Frame(frame), [axis, part]) => {
            let number = value.number().ok_or_else(|| Problem::new("run-not-a-number", place, key))?;
            if !variables::set_component(frame, axis, part, number * factor) {
                return Err(outside());
            }
        }
        _ => return Err(outside()),
    }
    Ok(())
}

/// A value that its variable cannot hold.
fn wrong(kind: Type, value: &Datum, place: Span, key: &str) -> Problem {
    match (kind, value) {
        (Type::Text(length), Datum::Text(_)) => {
            let mut problem = Problem::new("run-text-long", place, key);
            problem.message = problem.message.number("limit", length as f64);
            problem
        }
        (Type::Real | Type::Int | Type::Char, Datum::Number(_)) => Problem::new("run-range", place, key),
        _ => Problem::new("run-type", place, key),
    }
}

/// A text with another character at this place.
fn replaced(text: &str, number: &str, character: &str) -> Option<String> {
    let at: usize = number.parse().ok()?;
    let (from, old) = text.char_indices().nth(at)?;
    let mut text = text.to_owned();
    text.replace_range(from..from + old.len_utf8(), character);
    Some(text)
}

/// mm in the unit of a component of a frame; angles, factors and mirrors have none.
fn component_factor(run: &Interpreter, part: &str) -> f64 {
    match part {
        "TR" | "FI" => run.sim.control.data_factor(),
        _ => 1.0,
    }
}

/// Element that the first indices name, and the indices behind them.
fn element<'i, 'k>(variable: &Variable, index: &'i [&'k str]) -> Option<(usize, &'i [&'k str])> {
    let (own, rest) = index.split_at_checked(variable.sizes.len())?;
    let own: Result<Vec<usize>, _> = own.iter().map(|number| number.parse()).collect();
    Some((arrays::place(&own.ok()?, &variable.sizes)?, rest))
}

/// The name without its index.
pub fn stem(key: &str) -> &str {
    key.split('[').next().unwrap_or_default()
}

/// The indices of a name, as written in its key.
pub fn indices(key: &str) -> Vec<&str> {
    match key.split_once('[') {
        Some((_, rest)) => rest.trim_end_matches(']').split(',').collect(),
        None => Vec::new(),
    }
}
