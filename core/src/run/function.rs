//! Functions of expressions: arithmetic, texts, frames. Angles in degree.

use super::{Datum, Interpreter, asked_functions, expression::element, expression::list, uncomputed};
use crate::control::{AXES, Frame, ROTARY, variables::set_component};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::ExprId;
use crate::syntax::{arithmetic, number};

pub fn call(run: &Interpreter, place: Span, args: &[ExprId]) -> Result<Datum, Problem> {
    let name = run.program.name(place);
    let refused = || Problem::new("run-function", place, name.as_str());
    if name == "SET" {
        return list(run, args).map(Datum::List);
    }
    if uncomputed::find(&name).is_some() {
        return Err(Problem::new("run-not-simulated", place, name));
    }
    let values = args.iter().map(|arg| element(run, *arg, place)).collect::<Result<Vec<_>, _>>()?;
    if name == "REP" {
        return repeated(values).ok_or_else(refused);
    }
    if let Some(value) = tool_number(run, &name, &values) {
        return Ok(value);
    }
    if let Some(frame) = frame(run, &name, &values) {
        return frame.map(|frame| Datum::Frame(Box::new(frame))).ok_or_else(refused);
    }
    if let Some(value) = of_texts(&name, &values) {
        return Ok(value);
    }
    // a name that is none of the functions is not known, whatever its values are
    let missing = || match asked_functions::is_known(&name) {
        true => refused(),
        false => Problem::new("run-unknown-word", place, name.as_str()),
    };
    let numbers: Vec<f64> = values.iter().filter_map(Datum::number).collect();
    if numbers.len() < values.len() {
        return asked_functions::call(run, &name, &values, place).ok_or_else(missing);
    }
    let value = match numbers[..] {
        [number] if name == "NOT" => Some((run.rules().not)(number)),
        _ => arithmetic::function(&name, &numbers),
    };
    match value {
        Some(value) if value.is_finite() => Ok(Datum::Number(value)),
        Some(_) => Err(refused()),
        None => asked_functions::call(run, &name, &values, place).ok_or_else(missing),
    }
}

/// `REP(value)` up to the end of an array, `REP(value,count)` for so many elements.
fn repeated(values: Vec<Datum>) -> Option<Datum> {
    let mut values = values.into_iter();
    let value = Box::new(values.next()?);
    let count = match values.next() {
        None => None,
        Some(count) => Some(count.number().filter(|count| *count >= 1.0)? as usize),
    };
    values.next().is_none().then_some(Datum::Repeat(value, count))
}

/// `GETT("NAME",1)`: number of the tool with this name, -1 where there is none.
fn tool_number(run: &Interpreter, name: &str, values: &[Datum]) -> Option<Datum> {
    let [Datum::Text(wanted), ..] = values else { return None };
    let number = run.sim.control.tool_named(wanted).unwrap_or(-1);
    (name == "GETT" && values.len() <= 2).then_some(Datum::Number(number as f64))
}

/// `CTRANS(X,10,Y,20)`, `CFINE(…)`, `CROT(Z,30)`, `CSCALE(X,2)`, `CMIRROR(X,Y)`, `CRPL(0,30)`, `INVFRAME(…)`; the outer
/// option: whether it is a function of frames.
fn frame(run: &Interpreter, name: &str, values: &[Datum]) -> Option<Option<Frame>> {
    let (part, factor) = match name {
        "CTRANS" => ("TR", run.sim.control.active_factor()),
        "CFINE" => ("FI", run.sim.control.active_factor()),
        "CROT" => ("RT", 1.0),
        "CSCALE" => ("SC", 1.0),
        "CMIRROR" => return Some(mirrored(values)),
        "CRPL" => return Some(turned_in_plane(run, values)),
        "INVFRAME" => return Some(if let [Datum::Frame(frame)] = values { frame.inverse() } else { None }),
        _ => return None,
    };
    let mut frame = Frame::default();
    for pair in values.chunks(2) {
        let [Datum::Word(axis), Datum::Number(value)] = pair else { return Some(None) };
        let value = if ROTARY.contains(&axis.as_str()) { *value } else { value * factor };
        let shrinks = part == "SC" && value == 0.0; // to nothing
        if shrinks || !set_component(&mut frame, axis, part, value) {
            return Some(None);
        }
    }
    Some(Some(frame))
}

/// `CRPL(plane,angle)`: 0 in the working plane, 1 to 3 about Z, Y, X (function manual K2, constant rotation plane).
fn turned_in_plane(run: &Interpreter, values: &[Datum]) -> Option<Frame> {
    let [plane, angle] = values else { return None };
    let axis = match plane.number()? {
        0.0 => run.sim.tool_axis(),
        plane @ (1.0 | 2.0 | 3.0) => 3 - plane as usize,
        _ => return None,
    };
    let mut frame = Frame::default();
    *frame.rotation.get_mut(axis)? = angle.number()?;
    Some(frame)
}

fn mirrored(values: &[Datum]) -> Option<Frame> {
    let mut frame = Frame::default();
    for value in values {
        let Datum::Word(axis) = value else { return None };
        set_component(&mut frame, axis, "MI", 1.0).then_some(())?;
    }
    Some(frame)
}

/// Value of a function of texts, places counted from 0; none: another function, or no values for it.
fn of_texts(name: &str, values: &[Datum]) -> Option<Datum> {
    Some(match (name, values) {
        ("STRLEN", [Datum::Text(text)]) => Datum::Number(text.chars().count() as f64),
        ("TOUPPER", [Datum::Text(text)]) => Datum::Text(text.to_uppercase()),
        ("TOLOWER", [Datum::Text(text)]) => Datum::Text(text.to_lowercase()),
        ("ISNUMBER", [Datum::Text(text)]) => Datum::from(number::of_text(text).is_some()),
        ("NUMBER", [Datum::Text(text)]) => Datum::Number(number::of_text(text)?),
        ("INDEX", [Datum::Text(text), wanted]) => place(text, text.find(wanted.character()?)),
        ("RINDEX", [Datum::Text(text), wanted]) => place(text, text.rfind(wanted.character()?)),
        ("MINDEX", [Datum::Text(text), Datum::Text(any)]) => place(text, text.find(|one: char| any.contains(one))),
        ("MATCH", [Datum::Text(text), Datum::Text(part)]) => place(text, text.find(part.as_str())),
        ("SUBSTR", [Datum::Text(text), Datum::Number(from)]) => Datum::Text(text.chars().skip(whole(*from)?).collect()),
        ("SUBSTR", [Datum::Text(text), Datum::Number(from), Datum::Number(length)]) => {
            Datum::Text(text.chars().skip(whole(*from)?).take(whole(*length)?).collect())
        }
        ("AXNAME", [Datum::Text(text)]) => {
            let name = text.to_ascii_uppercase();
            AXES.contains(&name.as_str()).then_some(Datum::Word(name))?
        }
        ("AXSTRING", [Datum::Word(name)]) => Datum::Text(name.clone()),
        _ => return None,
    })
}

/// The place in a text of a byte, in characters; -1 where nothing was found.
fn place(text: &str, found: Option<usize>) -> Datum {
    let before = found.and_then(|at| text.get(..at));
    Datum::Number(before.map_or(-1.0, |before| before.chars().count() as f64))
}

fn whole(number: f64) -> Option<usize> {
    (number >= 0.0).then_some(number as usize)
}
