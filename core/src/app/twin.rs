//! A task of the form on other controls, beside it.

use crate::catalogue::twin::{Measurement, coarse, lost_zero, measured, one_sided, only_here, other};
use crate::control::{Control, delivery_in};
use crate::entry::{Cycle, Inputs, Style, Typed};
use crate::foreign::{self, Aim, CONTROLS, Foreign, OfTask, of_task};
use crate::message::Message;
use crate::program::write::snippet;
use crate::{catalogue, check, entry};
use serde::Serialize;

/// A task as another control does it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct TwinView {
    /// Name of that control, the same in every language.
    pub control: &'static str,
    /// Cycle of the other control.
    pub cycle: &'static str,
    /// Stem of its messages.
    pub key: &'static str,
    /// What both measure.
    pub task: Message,
    /// Values as typed there.
    pub values: Typed,
    /// Text of the program there; empty: it is not written.
    pub snippet: String,
    /// Why it is not written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Message>,
    /// What both say.
    pub shared: Vec<Shared>,
    /// What is different there.
    pub differences: Vec<Message>,
}

/// What both calls say.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Shared {
    /// What it is.
    pub label: Message,
    /// Value on both controls; a length in the active unit.
    pub value: f64,
}

/// The task on the other controls; empty where none has it.
pub(super) fn twins(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Vec<TwinView> {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let foreign = CONTROLS.into_iter().filter_map(|other| of_foreign(other, &inputs, control));
    twin(cycle, typed, control).into_iter().chain(foreign).collect()
}

/// None where the other control has no such task.
fn twin(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<TwinView> {
    let there = catalogue::twin::twin(cycle, typed, control)?;
    let mut machine = delivery_in(other(cycle.dialect), control.basic_units);
    machine.plane = control.plane;
    machine.active_units = control.active_units;
    let written = snippet(there.cycle, &there.values, &machine, Style::Direct, None);
    Some(TwinView {
        control: there.cycle.dialect.name(),
        cycle: there.cycle.name,
        key: there.cycle.key,
        task: Message::new(there.measurement.task.key()),
        values: there.values,
        snippet: written.text,
        refused: None,
        shared: shared(&there.measurement, control),
        differences: there.differences,
    })
}

/// On a control that is not run here.
fn of_foreign(other: &'static Foreign, inputs: &Inputs, control: &Control) -> Option<TwinView> {
    let (here, measurement) = measured(inputs, control)?;
    let there = of_task(other, &measurement, control.active_units)?;
    let per = control.active_factor();
    let length = |name: &str, value: f64| match there.cycle.parameter(name) {
        Some(parameter) if parameter.value.is_length() => value / per,
        _ => value,
    };
    let values: Vec<(&'static str, f64)> =
        there.values.iter().map(|(name, value)| (*name, length(name, *value))).collect();
    let values: Typed = values.into_iter().map(|(name, value)| (name.to_owned(), value.to_string())).collect();
    let written = foreign::written(other, there.cycle, &values);
    let refused = there.cycle.unwritten(other);
    let known = Measurement { corner: None, limit: None, reach: None, ..measurement };
    // a call that sets a datum does not say which: it is the active one
    let both = Measurement { zero: None, ..known.clone() };
    let both = if values.is_empty() { Vec::new() } else { shared(&both, control) };
    Some(TwinView {
        control: other.name,
        cycle: there.cycle.name,
        key: there.cycle.key,
        task: Message::new(known.task.key()),
        values,
        snippet: written.unwrap_or_default(),
        differences: [zero_offset(other, here, inputs, &known), told(other, &there, inputs, here, control)].concat(),
        refused,
        shared: both,
    })
}

/// What becomes of the zero offset that the call corrects.
fn zero_offset(other: &Foreign, here: &entry::Shared, inputs: &Inputs, known: &Measurement) -> Vec<Message> {
    let said = |key: &'static str, zero: f64| Message::new(key).number("value", zero).text("control", other.name);
    let lost = lost_zero(here, inputs, known).map(|zero| said("foreign-zero-lost", zero));
    let active = known.zero.map(|zero| said("foreign-zero-active", zero as f64));
    lost.into_iter().chain(coarse(here, inputs)).chain(active).collect()
}

/// What the reader of both calls has to know.
fn told(other: &Foreign, there: &OfTask, inputs: &Inputs, here: &entry::Shared, control: &Control) -> Vec<Message> {
    let per = control.active_factor();
    let named = |key: &'static str, names: &[&str]| Message::new(key).text("names", names.join(", "));
    let mut all = Vec::new();
    let is_written = there.cycle.is_written();
    if is_written && !there.assumed.is_empty() {
        let place = named("foreign-place", &there.assumed).text("control", other.name);
        all.push(place.number("height", there.height / per).number("clearance", there.clearance / per));
    }
    if is_written && !there.usual.is_empty() {
        all.push(named("foreign-usual", &there.usual));
    }
    if there.cycle.tasks.iter().any(|(_, aim)| *aim == Aim::Datum) {
        all.push(Message::new("foreign-datum").text("control", other.name));
    } else {
        all.push(Message::new(other.results));
    }
    let only = only_here(inputs, here, &|meaning| there.carried.contains(&meaning));
    all.extend(one_sided("twin-only", &only, inputs.cycle));
    all
}

/// What both calls say, lengths in the active unit.
fn shared(measurement: &Measurement, control: &Control) -> Vec<Shared> {
    let per = control.active_factor();
    let length = |value: Option<f64>| value.map(|value| value / per);
    let whole = |value: Option<i64>| value.map(|value| value as f64);
    let axis = measurement.axis.map(|axis| axis as f64 + 1.0);
    let all = [
        ("meaning-nominal", length(measurement.nominal)),
        ("meaning-side-1", length(measurement.sides.map(|sides| sides[0]))),
        ("meaning-side-2", length(measurement.sides.map(|sides| sides[1]))),
        ("meaning-axis", axis),
        ("meaning-depth", length(measurement.depth)),
        ("meaning-corner-1", length(measurement.corner.map(|at| at[0]))),
        ("meaning-corner-2", length(measurement.corner.map(|at| at[1]))),
        ("meaning-half", length(measurement.half)),
        ("meaning-limit", length(measurement.limit)),
        ("meaning-reach", length(measurement.reach)),
        ("meaning-zero", whole(measurement.zero)),
        ("meaning-tool", whole(measurement.tool)),
    ];
    all.into_iter().filter_map(|(key, value)| Some(Shared { label: Message::new(key), value: value? })).collect()
}
