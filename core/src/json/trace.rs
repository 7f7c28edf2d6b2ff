//! Outcome and trace as JSON.

use super::setup_write::{put_body, solids};
use super::{document, object, put, trace_tool, trace_turned};
use crate::control::Control;
use crate::control::rotary::ROTARY;
use crate::diagnostic::Code;
use crate::geometry::arc::Around;
use crate::machine::setup::Setup;
use crate::machine::trace::{Entry, MotionKind, Step};
use crate::message::Message;
use crate::run::outcome::Outcome;
use crate::scene::Source;
use crate::scene::frames::Frame;
use crate::workpiece::Solid;
use crate::workpiece::feeler::Touching;
use crate::{SIMULATES, catalogue, scene};
use serde::{Serialize, Serializer};
use serde_json::Value;

impl Serialize for Source {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        if !SIMULATES {
            return to.serialize_unit(); // nothing ran
        }
        let mut view = trace(&self.setup, &self.outcome);
        put(&mut view, "zones", solids(&self.zones));
        put(&mut view, "limits", solids(&self.limits));
        view.serialize(to)
    }
}

/// Everything that happened, with what is needed to draw it.
fn trace(setup: &Setup, outcome: &Outcome) -> Value {
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

/// An alarm that was raised.
fn alarm(code: Code) -> Value {
    let key = catalogue::alarms::key(code);
    object([
        ("code", document(&code)),
        ("hint", document(&Message::new(format!("{key}.cure")))),
        ("message", document(&Message::new(key))),
        ("stops", catalogue::alarms::stops(code).into()),
    ])
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
        Step::Decision(text) => object([("step", "decision".into()), ("message", document(text))]),
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
