//! The same task on the other control as JSON, beside the form.

use super::{dialect_name, message, object};
use crate::catalogue::twin::{Measurement, other, twin};
use crate::control::{Control, delivery_in};
use crate::entry::Cycle;
use crate::entry::Typed;
use crate::entry::{Style, Task};
use crate::message::Message;
use crate::program::write::snippet;
use serde_json::Value;

/// A `TwinView`; null where the other control has no such task.
pub(super) fn view(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Value {
    let Some(there) = twin(cycle, typed, control) else {
        return Value::Null;
    };
    let mut machine = delivery_in(other(cycle.dialect), control.basic_units);
    machine.plane = control.plane;
    machine.active_units = control.active_units;
    let written = snippet(there.cycle, &there.values, &machine, Style::Direct, None);
    let values = there.values.iter();
    let values = values.map(|(name, value)| (name.as_str(), value.as_str().into()));
    object([
        ("control", dialect_name(there.cycle.dialect).into()),
        ("cycle", there.cycle.name.into()),
        ("key", there.cycle.key.into()),
        ("task", message(&Message::new(task_key(there.measurement.task)))),
        ("values", object(values)),
        ("snippet", written.text.into()),
        ("shared", shared(&there.measurement, control)),
        ("differences", there.differences.iter().map(message).collect()),
    ])
}

/// Key of the name of a task.
fn task_key(task: Task) -> &'static str {
    match task {
        Task::Bore => "task-bore",
        Task::Boss => "task-boss",
        Task::Pocket => "task-pocket",
        Task::Web => "task-web",
        Task::Wall => "task-wall",
        Task::Face => "task-face",
        Task::InnerCorner => "task-inner-corner",
        Task::OuterCorner => "task-outer-corner",
        Task::Ball => "task-ball",
        Task::Length => "task-length",
    }
}

/// What both calls say, in the active unit.
fn shared(measurement: &Measurement, control: &Control) -> Value {
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
    let said = all.into_iter().filter_map(|(key, value)| {
        let label = message(&Message::new(key));
        Some(object([("label", label), ("value", value?.into())]))
    });
    said.collect()
}
