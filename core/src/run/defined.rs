//! User data that definition files add to the control: typed, with first values. What was given or written is with the
//! other data of the control, by name with index; a frame by its components.

use super::{Datum, Interpreter, Type, datum::replaced, indices, locals, stem};
use crate::control::definitions::ELEMENTS;
use crate::control::variables::{component, set_component};
use crate::control::{AXES, Definition, Frame, Value, arrays};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::program::defined_here;
use std::rc::Rc;
use std::sync::Arc;

/// Components of a frame, as a program names them.
const PARTS: [&str; 5] = ["TR", "FI", "RT", "SC", "MI"];

/// Longest array that is handed over whole.
const WHOLE: usize = 10_000;

/// The datum that a name stands for, where a definition file defines it.
pub fn find<'a>(run: &'a Interpreter, key: &str) -> Option<&'a Definition> {
    run.sim.control.definitions.find(stem(key))
}

/// Adds what the definition files in the text define.
pub fn add(run: &mut Interpreter) {
    let program = Rc::clone(&run.program);
    let found = crate::syntax::definitions::of_text(&program, &run.programs);
    for finding in found.findings() {
        run.tell_once(finding);
    }
    if let Some(finding) = defined_here::finding(&found, &run.sim.control) {
        run.tell_once(finding);
    }
    if !found.definitions.is_empty() {
        Arc::make_mut(&mut run.sim.control.definitions).extend(found.definitions);
    }
}

/// Value of a datum: a whole array as a list, a character of a text, a component of a frame.
pub fn read(run: &Interpreter, key: &str, place: Span) -> Option<Result<Datum, Problem>> {
    let datum = find(run, key)?;
    Some(taken(run, datum, key).ok_or_else(|| Problem::new("run-index", place, key)))
}

fn taken(run: &Interpreter, datum: &Definition, key: &str) -> Option<Datum> {
    let (name, index) = (stem(key), indices(key));
    if index.is_empty() && !datum.sizes.is_empty() {
        let elements = (datum.elements() <= WHOLE).then(|| arrays::elements_from(name, &datum.sizes))?;
        return Some(Datum::List(
            elements.iter().enumerate().map(|(at, one)| Some(held(run, datum, one, at))).collect(),
        ));
    }
    let (at, rest) = element(datum, &index)?;
    let own = spelled(name, &index[..datum.sizes.len()]);
    let value = held(run, datum, &own, at);
    match (value, rest) {
        (value, []) => Some(value),
        (Datum::Text(text), [number]) => Some(Datum::Text(text.chars().nth(number.parse().ok()?)?.into())),
        (Datum::Frame(frame), [axis, part]) => {
            Some(Datum::Number(component(&frame, axis, part)? / locals::component_factor(run, part)))
        }
        _ => None,
    }
}

/// What an element holds: what was given or written, else what it begins with.
fn held(run: &Interpreter, datum: &Definition, key: &str, at: usize) -> Datum {
    if datum.kind == Type::Frame {
        return Datum::Frame(Box::new(frame(run, key)));
    }
    let value = run.sim.control.data.get(key).or_else(|| datum.begins(at));
    match (datum.kind, value) {
        (_, None) => datum.kind.empty(),
        (Type::Axis, Some(Value::Text(name))) => Datum::Word(name.to_ascii_uppercase()),
        (Type::Char, Some(Value::Number(code))) => Datum::Char(*code as u8),
        (_, Some(value)) => datum.kind.converted(&Datum::from(value)).unwrap_or_else(|| datum.kind.empty()),
    }
}

/// The frame of which some components were written.
fn frame(run: &Interpreter, key: &str) -> Frame {
    let mut frame = Frame::default();
    for (axis, part, name) in components(key) {
        if let Some(Value::Number(value)) = run.sim.control.data.get(&name) {
            set_component(&mut frame, axis, part, *value);
        }
    }
    frame
}

/// The components of a frame with the names of their data: `F[X,TR]`, `F[0,X,TR]`.
fn components(key: &str) -> impl Iterator<Item = (&'static str, &'static str, String)> {
    let open = match key.strip_suffix(']') {
        Some(array) => format!("{array},"),
        None => format!("{key}["),
    };
    let all = AXES.into_iter().flat_map(|axis| PARTS.map(|part| (axis, part)));
    all.map(move |(axis, part)| (axis, part, format!("{open}{axis},{part}]")))
}

/// Writes such a datum; false: it is none.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Result<bool, Problem> {
    let Some(datum) = find(run, key) else { return Ok(false) };
    let (kind, name, index) = (datum.kind, stem(key), indices(key));
    let outside = || Problem::new("run-index", place, key);
    let (at, rest) = element(datum, &index).ok_or_else(outside)?;
    let own = spelled(name, &index[..datum.sizes.len()]);
    match (held(run, datum, &own, at), rest) {
        (Datum::Frame(_), []) => {
            let Datum::Frame(new) = value else { return Err(locals::wrong(kind, value, place, key)) };
            for (axis, part, name) in components(&own) {
                run.sim.control.set(name, component(new, axis, part).unwrap_or(0.0));
            }
        }
        (Datum::Frame(_), [axis, part]) => {
            let number = value.number().ok_or_else(|| Problem::new("run-not-a-number", place, key))?;
            let known = components(&own).find(|one| (one.0, one.1) == (*axis, *part)).ok_or_else(outside)?;
            let factor = locals::component_factor(run, part);
            run.sim.control.set(known.2, number * factor);
        }
        (before, []) => {
            let new = kind.converted(value).ok_or_else(|| locals::wrong(kind, value, place, key))?;
            keep(run, own, &before, &new);
        }
        (Datum::Text(text), [number]) => {
            let code = Type::Char.converted(value);
            let new = code.and_then(|code| replaced(&text, number, &code.shown())).ok_or_else(outside)?;
            keep(run, own, &Datum::Text(text), &Datum::Text(new));
        }
        _ => return Err(outside()),
    }
    Ok(true)
}

/// Keeps a value, and records that a number was written.
fn keep(run: &mut Interpreter, name: String, before: &Datum, new: &Datum) {
    let stored = match new {
        Datum::Word(word) => Some(Value::Text(word.clone())),
        other => other.value(),
    };
    if let (Some(before), Some(after)) = (before.number(), new.number()) {
        run.note_set(&name, before, after);
    }
    if let Some(stored) = stored {
        run.sim.control.data.insert(name, stored);
    }
}

/// Element that the first indices name, and the indices behind them.
fn element<'i, 'k>(datum: &Definition, index: &'i [&'k str]) -> Option<(usize, &'i [&'k str])> {
    let (own, rest) = index.split_at_checked(datum.sizes.len())?;
    let own: Vec<usize> = own.iter().map(|number| number.parse().ok()).collect::<Option<_>>()?;
    Some((arrays::place(&own, &datum.sizes)?, rest)).filter(|(at, _)| *at < ELEMENTS)
}

/// Name of an element, without what stands behind its own indices.
fn spelled(name: &str, index: &[&str]) -> String {
    if index.is_empty() { name.to_owned() } else { format!("{name}[{}]", index.join(",")) }
}
