//! Values that only the machine has: machine and setting data, inputs and outputs, what its axes and channel tell.
//! Those that are not simulated are data of the setup; one that is not given there is assumed, and the run tells which.

use super::{Datum, Interpreter, stem};
use crate::control::definitions::LONGEST;
use crate::control::{Value, machine_data};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A value that was assumed.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineValue {
    /// As the program names it: `$A_IN[1]`.
    pub name: String,
    /// What it was taken for.
    pub value: Value,
    /// Line that asked for it first, from 1.
    pub line: u32,
}

/// Most of them that are kept.
const MOST: usize = 1000;

/// Those that were assumed so far, by name, with the place that asked first.
#[derive(Debug, Default)]
pub struct Asked {
    all: RefCell<BTreeMap<String, Span>>,
    told: usize,
}

/// Value of a datum that is not simulated: what the setup gives or the program wrote, else 0 or an empty text. None:
/// it is no such datum, or nothing is to be assumed.
pub fn read(run: &Interpreter, key: &str, place: Span) -> Option<Datum> {
    if !machine_data::of_machine(key) {
        return None;
    }
    let by_number = machine_data::numbered(key);
    let control = &run.sim.control;
    if let Some(value) = control.data.get(key).or_else(|| control.data.get(by_number.as_deref()?)) {
        return Some(Datum::from(value));
    }
    if run.limits.strict {
        return None;
    }
    let mut all = run.asked.all.borrow_mut();
    if all.len() < MOST && !all.contains_key(key) {
        all.insert(key.to_owned(), place);
    }
    Some(Datum::from(&assumed(key)))
}

/// What is assumed where nobody says it.
fn assumed(key: &str) -> Value {
    if machine_data::is_text(stem(key)) { Value::Text(String::new()) } else { Value::Number(0.0) }
}

/// A value as a program writes it.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

/// Writes such a datum, which then is as written; false: it is none.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum) -> bool {
    let too_long = matches!(value, Datum::Text(text) if text.chars().count() > LONGEST);
    let Some(stored) = value.value().filter(|_| machine_data::of_machine(key) && !too_long) else { return false };
    let name = machine_data::numbered(key).unwrap_or_else(|| key.to_owned());
    run.sim.control.data.insert(name, stored);
    true
}

/// Tells the values that were asked for since, each array once.
pub fn tell(run: &mut Interpreter) {
    let all = run.asked.all.borrow();
    if all.len() == run.asked.told {
        return;
    }
    let mut new: Vec<(Span, String)> = all.iter().map(|(name, place)| (*place, name.clone())).collect();
    drop(all);
    run.asked.told = new.len();
    new.sort_by_key(|(place, _)| place.start);
    for (place, name) in new {
        if run.arrays_asked.insert(stem(&name).to_owned()) {
            let shown = shown(&assumed(&name));
            run.tell(Severity::Note, &Problem::new("run-machine-value", place, name).text("value", shown));
        }
    }
}

/// All that was assumed, in the order of the text.
pub fn all(run: &Interpreter) -> Vec<MachineValue> {
    let all = run.asked.all.borrow();
    let mut found: Vec<(Span, &String)> = all.iter().map(|(name, place)| (*place, name)).collect();
    found.sort_by_key(|(place, _)| place.start);
    let value = |(place, name): (Span, &String)| MachineValue {
        name: name.clone(),
        value: assumed(name),
        line: run.program.line_of(place.start) + 1,
    };
    found.into_iter().map(value).collect()
}
