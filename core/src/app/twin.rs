//! A task of the form on the other control, beside it.

use crate::catalogue;
use crate::catalogue::twin::{Measurement, other};
use crate::control::{Control, delivery_in};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Style, Typed};
use crate::message::Message;
use crate::program::write::snippet;
use serde::Serialize;

/// A task as the other control does it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct TwinView {
    /// That control.
    pub control: Dialect,
    /// Cycle of the other control.
    pub cycle: &'static str,
    /// Stem of its messages.
    pub key: &'static str,
    /// What both measure.
    pub task: Message,
    /// Values as typed there.
    pub values: Typed,
    /// Text of the program there.
    pub snippet: String,
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

/// None where the other control has no such task.
pub(super) fn twin(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<TwinView> {
    let there = catalogue::twin::twin(cycle, typed, control)?;
    let mut machine = delivery_in(other(cycle.dialect), control.basic_units);
    machine.plane = control.plane;
    machine.active_units = control.active_units;
    let written = snippet(there.cycle, &there.values, &machine, Style::Direct, None);
    Some(TwinView {
        control: there.cycle.dialect,
        cycle: there.cycle.name,
        key: there.cycle.key,
        task: Message::new(there.measurement.task.key()),
        values: there.values,
        snippet: written.text,
        shared: shared(&there.measurement, control),
        differences: there.differences,
    })
}

/// What both calls say, lengths in the active unit.
fn shared(measurement: &Measurement, control: &Control) -> Vec<Shared> {
    let per = control.active_factor();
    let length = |value: Option<f64>| value.map(|value| value / per);
    let whole = |value: Option<i64>| value.map(|value| value as f64);
    let axis = measurement.axis.map(|axis| axis as f64 + 1.0);
    let all = [
        ("meaning-nominal", length(measurement.nominal)),
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
