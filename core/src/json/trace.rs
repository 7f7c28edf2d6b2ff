//! Outcome and trace as JSON.

use super::setup_write::{put_body, solids};
use super::{code, message, object, put, trace_tool, trace_turned};
use crate::catalogue;
use crate::control::Control;
use crate::control::rotary::ROTARY;
use crate::diagnostic::Code;
use crate::entry::{Inputs, unit_name};
use crate::geometry::arc::Around;
use crate::machine::Stop;
use crate::machine::setup::Setup;
use crate::machine::trace::{Entry, MotionKind, Step};
use crate::message::Message;
use crate::run::outcome::Outcome;
use crate::scene::{self, frames::Frame};
use crate::workpiece::Solid;
use crate::workpiece::feeler::Touching;
use serde_json::Value;

/// What a call does: results, decisions, alarms, changes, log and trace.
pub fn outcome(inputs: &Inputs, setup: &Setup, outcome: &Outcome) -> Value {
    object([
        ("results", results(inputs, outcome).into()),
        ("decisions", outcome.decisions().into_iter().map(message).collect()),
        ("alarms", alarms(outcome).into()),
        ("changes", super::changes::changes(outcome).into()),
        ("log", outcome.log().into()),
        ("trace", trace(setup, outcome)),
    ])
}

/// What the call wrote, and what it would have written but left as it was, which is marked.
fn results(inputs: &Inputs, outcome: &Outcome) -> Vec<Value> {
    let unwritten = outcome.unwritten(inputs.cycle);
    outcome
        .results(inputs.cycle)
        .into_iter()
        .filter(|(field, _)| field.when.holds(inputs))
        .map(|(field, value)| {
            let mut result = object([
                ("name", field.name.into()),
                ("label", super::key(field.key)),
                ("value", value.into()),
                ("unit", unit_name(field.unit, &outcome.control).into()),
            ]);
            if unwritten.contains(field.name) {
                put(&mut result, "earlier", 0);
            }
            result
        })
        .collect()
}

/// Alarms raised, the one that stopped the run last, a fault of the simulation after them.
pub(super) fn alarms(outcome: &Outcome) -> Vec<Value> {
    let mut list: Vec<Value> = outcome.alarms().into_iter().map(alarm).collect();
    if let Some(stop @ Stop::Fault(_)) = &outcome.stop {
        list.push(stopped(stop));
    }
    list
}

/// Why something did not go on.
pub(super) fn stopped(stop: &Stop) -> Value {
    match stop {
        Stop::Alarm(code) => alarm(*code),
        Stop::Fault(text) => object([("code", "".into()), ("message", message(text)), ("stops", true.into())]),
    }
}

/// An alarm that was raised.
fn alarm(alarm: Code) -> Value {
    let stops = catalogue::alarms::stops(alarm);
    let key = catalogue::alarms::key(alarm);
    let hint = message(&Message::new(format!("{key}.cure")));
    object([
        ("code", code(alarm).into()),
        ("message", message(&Message::new(key))),
        ("hint", hint),
        ("stops", stops.into()),
    ])
}

/// Everything that happened, with what is needed to draw it.
pub(super) fn trace(setup: &Setup, outcome: &Outcome) -> Value {
    let (tools, in_use) = trace_tool::tools(setup, outcome);
    // a program may begin without a tool that tells
    let turning = outcome.before.turns() || outcome.control.turns();
    let mut view = object([
        ("entries", outcome.trace.entries.iter().map(entry).collect()),
        ("ball", ball(setup)),
        ("tools", tools),
        ("inUse", in_use),
        ("turning", turning.into()),
        ("solids", solids(&clamped(setup))),
        ("toolProbes", trace_tool::probes(setup)),
        ("frames", frames(&outcome.before, &outcome.control)),
    ]);
    if turning {
        put(&mut view, "drawing", trace_turned::drawing(setup, outcome));
    }
    view
}

/// The part as it stands at the start.
fn clamped(setup: &Setup) -> Vec<Solid> {
    let solids = setup.workpiece.solids.iter();
    solids.map(|solid| setup.control.on_table(solid)).collect()
}

/// Ball, stylus and body.
fn ball(setup: &Setup) -> Value {
    let probe = &setup.probe;
    let mut view = object([
        ("radius", probe.radius.into()),
        ("length", probe.length.into()),
        ("stylus", probe.stylus_radius().into()),
    ]);
    put_body(&mut view, probe);
    view
}

fn arc(around: &Around) -> Value {
    object([("centre", around.centre.into()), ("axis", around.axis.into()), ("degrees", around.degrees.into())])
}

fn entry(entry: &Entry) -> Value {
    let mut view = step(&entry.step);
    if let Some(line) = entry.line {
        put(&mut view, "line", line + 1);
    }
    view
}

fn step(step: &Step) -> Value {
    match step {
        Step::Motion { kind, from, to, around, feed } => {
            let mut view = object([
                ("step", "motion".into()),
                ("kind", kind_name(*kind).into()),
                ("from", (*from).into()),
                ("to", (*to).into()),
                ("feed", (*feed).into()),
            ]);
            if let Some(around) = around {
                put(&mut view, "around", arc(around));
            }
            view
        }
        Step::Touch { latched, ball, point, normal, by } => {
            let view = object([
                ("step", "touch".into()),
                ("latched", (*latched).into()),
                ("ball", (*ball).into()),
                ("point", (*point).into()),
                ("normal", (*normal).into()),
            ]);
            touched_by(view, *by)
        }
        Step::Crash { point, normal, by } => {
            let view = object([("step", "crash".into()), ("point", (*point).into()), ("normal", (*normal).into())]);
            touched_by(view, *by)
        }
        Step::Table { axis, from, to, solids: turned } => object([
            ("step", "table".into()),
            ("axis", ROTARY.get(*axis).copied().unwrap_or_default().into()),
            ("from", (*from).into()),
            ("to", (*to).into()),
            ("solids", solids(turned)),
        ]),
        Step::Orient(angle) => object([("step", "orient".into()), ("angle", (*angle).into())]),
        Step::Spin(speed) => object([("step", "spin".into()), ("speed", (*speed).into())]),
        Step::Tool(tool, edge) => object([("step", "tool".into()), ("tool", (*tool).into()), ("edge", (*edge).into())]),
        Step::Set { name, before, after } => object([
            ("step", "set".into()),
            ("name", name.as_str().into()),
            ("before", (*before).into()),
            ("after", (*after).into()),
        ]),
        Step::Decision(text) => object([("step", "decision".into()), ("message", message(text))]),
        Step::Alarm(code) => {
            let mut value = alarm(*code);
            put(&mut value, "step", "alarm");
            value
        }
        Step::Message(text) => object([("step", "message".into()), ("text", text.as_str().into())]),
        Step::Log(text) | Step::Sent(text) => object([("step", "log".into()), ("text", text.as_str().into())]),
        Step::CallBegin { cycle, variant } => {
            object([("step", "call".into()), ("cycle", (*cycle).into()), ("variant", (*variant).into())])
        }
        Step::CallEnd => object([("step", "return".into())]),
    }
}

/// What of the probe touched, where it is not the ball.
fn touched_by(mut view: Value, by: Touching) -> Value {
    match by {
        Touching::Ball => {}
        Touching::Stylus => put(&mut view, "by", "stylus"),
        Touching::Body => put(&mut view, "by", "body"),
    }
    view
}

fn kind_name(kind: MotionKind) -> &'static str {
    match kind {
        MotionKind::Rapid => "rapid",
        MotionKind::Positioning => "positioning",
        MotionKind::Measuring => "measuring",
        MotionKind::Retract => "retract",
    }
}

fn frames(before: &Control, after: &Control) -> Value {
    let frame = |one: Frame| {
        let mut view = object([("name", one.name.into()), ("at", one.at.into()), ("axes", one.axes.into())]);
        if let Some(when) = one.moved {
            put(&mut view, "moved", when);
        }
        view
    };
    scene::frames::frames(before, after).into_iter().map(frame).collect()
}
