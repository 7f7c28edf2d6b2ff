//! Values that only the machine has: machine and setting data, inputs and outputs, what its axes and channel tell.
//! Those that are not simulated are data of the setup; one that is not given there is assumed, and the run tells which.

use super::{Datum, Interpreter, stem};
use crate::control::definitions::LONGEST;
use crate::control::{Value, machine_data};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

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
/// What a value is taken for at last: later or larger than anything that a program waits for.
const LARGE: f64 = 1e6;
/// Clocks: what a program writes into them runs on.
const CLOCKS: [&str; 2] = ["$AC_TIMER[", "$AN_TIMER["];
/// How long a block takes beside its motions, s.
const BLOCK: f64 = 0.001;
/// How often a run takes a value for another, so that a loop that waits for it is left.
const MOST_TURNS: usize = 100;

/// Those that were assumed so far, by name, with the place that asked first.
#[derive(Debug, Default)]
pub struct Asked {
    all: RefCell<BTreeMap<String, Span>>,
    told: usize,
    /// Numbers that a loop asked for since its state was kept.
    in_loop: RefCell<BTreeSet<String>>,
    /// What is no longer taken for 0, or is again.
    turned: BTreeMap<String, f64>,
    turns: usize,
    waiting: Option<Waiting>,
    /// When the program wrote into a clock, by its name, s.
    clocks: BTreeMap<String, f64>,
}

/// A loop that would never end with what is assumed: it waits for a value of the machine.
#[derive(Debug)]
struct Waiting {
    /// Block that it jumps back to.
    at: usize,
    /// Its jump.
    place: Span,
    /// The value that is taken for another now.
    name: String,
    /// What it was taken for before.
    before: f64,
    /// Others that it asks for and that were not tried.
    untried: Vec<String>,
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
        let runs = CLOCKS.iter().any(|clock| key.starts_with(clock)) && !matches!(value, Value::Number(..0.0));
        if runs && !run.limits.strict {
            run.asked.in_loop.borrow_mut().insert(key.to_owned());
            if let Some(later) = run.asked.turned.get(key) {
                return Some(Datum::Number(*later));
            }
        }
        if let (true, Value::Number(number)) = (runs, value) {
            return Some(Datum::Number(number + now(run) - run.asked.clocks.get(key).copied().unwrap_or_default()));
        }
        return Some(Datum::from(value));
    }
    if run.limits.strict {
        return None;
    }
    let mut all = run.asked.all.borrow_mut();
    if all.len() < MOST && !all.contains_key(key) {
        all.insert(key.to_owned(), place);
    }
    let value = assumed(key);
    if all.contains_key(key) && matches!(value, Value::Number(_)) {
        run.asked.in_loop.borrow_mut().insert(key.to_owned());
    }
    Some(run.asked.turned.get(key).map_or_else(|| Datum::from(&value), |turned| Datum::from(&Value::Number(*turned))))
}

/// A loop begins to be watched.
pub fn watch(run: &Interpreter) {
    run.asked.in_loop.borrow_mut().clear();
}

/// Takes one value that a loop asks for as 1 in place of 0, or the other way round, then as something large, and each
/// other one after it while the loop still repeats itself: a program that waits for an input of its machine goes on, as
/// it does there. False: the loop waits for no value that was assumed.
pub fn turn(run: &mut Interpreter, place: Span) -> bool {
    let at = run.at;
    let before = run.asked.waiting.take();
    let mut untried: Vec<String> = match before {
        Some(waiting) if waiting.at == at && grows(run, &waiting.name) => {
            run.asked.turned.insert(waiting.name.clone(), LARGE);
            run.asked.waiting = Some(waiting);
            return true;
        }
        Some(waiting) if waiting.at == at => {
            run.asked.turned.insert(waiting.name, waiting.before); // it was not this one
            waiting.untried
        }
        before => {
            run.asked.waiting = before;
            settle(run);
            run.asked.in_loop.borrow().iter().rev().cloned().collect()
        }
    };
    run.asked.turns += 1;
    let Some(name) = untried.pop().filter(|_| run.asked.turns <= MOST_TURNS) else { return false };
    let value = run.asked.turned.entry(name.clone()).or_default();
    let before = std::mem::replace(value, if *value == 0.0 { 1.0 } else { 0.0 });
    run.asked.waiting = Some(Waiting { at, place, name, before, untried });
    true
}

/// Whether a value may be larger than it was taken for: an input or output is 0 or 1.
fn grows(run: &Interpreter, name: &str) -> bool {
    let bit = name.starts_with("$A_IN[") || name.starts_with("$A_OUT[");
    !bit && run.asked.turned.get(name) != Some(&LARGE)
}

/// Tells for which value the last loop waited that the run left.
pub fn settle(run: &mut Interpreter) {
    if let Some(Waiting { place, name, .. }) = run.asked.waiting.take() {
        let value = run.asked.turned.get(&name).copied().unwrap_or_default();
        run.tell(Severity::Note, &Problem::new("run-waits", place, name).number("value", value));
    }
}

/// Assumes 0 for what only the machine has and no name of its data tells: a function that it answers, an edge of a tool
/// that the program does not make. None: nothing is to be assumed.
pub fn assume(run: &Interpreter, name: String, place: Span) -> Option<Datum> {
    if run.limits.strict {
        return None;
    }
    let mut all = run.asked.all.borrow_mut();
    if all.len() < MOST {
        all.entry(name).or_insert(place);
    }
    Some(Datum::Number(0.0))
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
    run.asked.turned.remove(&name);
    if CLOCKS.iter().any(|clock| name.starts_with(clock)) {
        run.asked.clocks.insert(name.clone(), now(run));
    }
    run.sim.control.data.insert(name, stored);
    true
}

/// How long the run takes so far, s: its motions and dwells, and a little for each block.
fn now(run: &Interpreter) -> f64 {
    run.sim.seconds + run.work as f64 * BLOCK
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
