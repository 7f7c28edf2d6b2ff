//! The cycles of the log in a run, and the block of values that a measuring cycle adds.

use super::contents::Subject;
use super::names::JOB;
use super::state::ON;
use super::{keep, marks};
use crate::catalogue::prelude::*;
use crate::control::Value;

/// The number of the measuring cycle that was called last (B:5693).
const LAST: &str = "_OVI[2]";

/// Nothing is measured: no part.
pub fn propose(_: &Inputs, _: &Control) -> Proposal {
    Proposal::default()
}

/// CYCLE100 (B:11227-11229).
pub fn on(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    take(machine, inputs);
    keep::open(machine)?;
    machine.write(ON, 1.0);
    Ok(())
}

/// CYCLE101 (B:11231-11233).
pub fn off(machine: &mut dyn Machine, _: &Inputs) -> Result<(), Stop> {
    machine.write(ON, 0.0);
    Ok(())
}

/// CYCLE105: contents, without an eye on files and pages (B:11237-11242).
pub fn contents(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    take(machine, inputs);
    match inputs.variant {
        1 => keep::write_contents(machine, None),
        _ => {
            let last = last(machine.control());
            keep::write_contents(machine, Some(&last))
        }
    }
}

/// CYCLE106: contents on their pages (B:11246-11253).
pub fn sequence(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    take(machine, inputs);
    match inputs.variant {
        1 => keep::write_header(machine),
        _ => {
            let last = last(machine.control());
            keep::write_values(machine, &last)
        }
    }
}

/// Puts what a form gives where a program has written it: the log is about data of the control.
fn take(machine: &mut dyn Machine, inputs: &Inputs) {
    put(machine.control(), inputs);
}

/// Writes the data of a call into the control.
pub fn put(control: &mut Control, inputs: &Inputs) {
    let data = &mut control.data;
    let of_control = |name: &Name| *name != JOB;
    for (name, text) in inputs.texts.iter().filter(|(name, _)| of_control(name)) {
        data.insert(name.to_string(), Value::Text(text.clone()));
    }
    for (name, number) in inputs.numbers.iter().filter(|(name, _)| of_control(name)) {
        data.insert(name.to_string(), Value::Number(*number));
    }
}

/// The cycle that measured last: a block that the program wants names it.
fn last(control: &Control) -> Subject {
    let last = control.number(LAST) as i64;
    let call = (last > 0).then(|| (format!("CYCLE{last}"), control.number(names::MVAR.as_str()) as i64));
    Subject { call, ..Subject::default() }
}

/// What a measuring cycle adds at its end while the log is on (B:11213).
///
/// # Errors
/// The alarm of something that cannot be logged.
pub fn measured(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let control = machine.control();
    if !inputs.cycle.is_measuring_cycle() || !control.bit(ON) {
        return Ok(());
    }
    let call = Some((inputs.cycle.name.to_owned(), inputs.variant));
    let marked = marks::marked(control, inputs);
    keep::write_values(machine, &Subject { call, marked })
}
