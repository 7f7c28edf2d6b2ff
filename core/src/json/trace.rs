//! Outcome and trace as JSON.

use super::setup::{settable_name, solid_value};
use super::{Error, code, message, number};
use crate::check::{Inputs, unit_name};
use crate::control::Control;
use crate::diagnostic::Code;
use crate::message::Message;
use crate::run::outcome::Outcome;
use crate::run::setup::Setup;
use crate::run::trace::{Entry, MotionKind, Step, Trace};
use crate::workpiece::Solid;
use serde_json::{Map, Value, json};

/// What a call does: results, decisions, alarms, changes, log and trace.
pub fn outcome(inputs: &Inputs, setup: &Setup, outcome: &Outcome) -> Result<Value, Error> {
    Ok(json!({
        "results": results(inputs, outcome),
        "decisions": outcome.decisions().into_iter().map(message).collect::<Vec<_>>(),
        "alarms": alarms(outcome),
        "changes": super::changes::changes(outcome),
        "log": outcome.log(),
        "trace": trace(setup, outcome)?,
    }))
}

fn results(inputs: &Inputs, outcome: &Outcome) -> Vec<Value> {
    outcome
        .results(inputs.cycle)
        .into_iter()
        .filter(|(field, _)| field.when.holds(inputs))
        .map(|(field, value)| {
            json!({
                "name": field.name,
                "label": super::key(field.key),
                "value": number(value),
                "unit": unit_name(field.unit, &outcome.control),
            })
        })
        .collect()
}

/// Alarms raised, the one that stopped the run last, a fault of the simulation after them.
pub(super) fn alarms(outcome: &Outcome) -> Vec<Value> {
    let mut list: Vec<Value> = outcome.alarms().into_iter().map(alarm).collect();
    if let Some(crate::run::Stop::Fault(text)) = &outcome.stop {
        list.push(json!({ "code": "", "message": message(text), "stops": true }));
    }
    list
}

/// A 61xxx stops, a 62xxx informs (A: alarm list); NCT operator messages that inform are told apart by the words.
fn alarm(alarm: Code) -> Value {
    let stops = match alarm {
        Code::Alarm(number) => number < 62000,
        Code::Nct(_) => !crate::catalogue::nct::informs(alarm),
        Code::Own(_) => true,
    };
    let key = alarm_key(alarm);
    let hint = message(&Message::new(format!("{key}.cure")));
    json!({ "code": code(alarm), "message": message(&Message::new(key)), "hint": hint, "stops": stops })
}

/// Key of an alarm's words: `alarm-61303`, `nct-format-error`, `pw012`.
pub fn alarm_key(alarm: Code) -> String {
    match alarm {
        Code::Alarm(number) => format!("alarm-{number}"),
        Code::Nct(text) => {
            let words: String = text
                .chars()
                .map(|c| {
                    if c.is_ascii_alphanumeric() {
                        c.to_ascii_lowercase()
                    } else {
                        '-'
                    }
                })
                .collect();
            format!("nct-{words}")
        }
        Code::Own(number) => format!("pw{number:03}"),
    }
}

/// Everything that happened, with what is needed to draw it.
pub(super) fn trace(setup: &Setup, outcome: &Outcome) -> Result<Value, Error> {
    Ok(json!({
        "entries": entries(&outcome.trace),
        "ball": ball(setup, outcome),
        "solids": solids(&setup.workpiece.solids)?,
        "frames": frames(&outcome.before, &outcome.control),
    }))
}

/// Solids as the setup file has them.
pub(super) fn solids(list: &[Solid]) -> Result<Value, Error> {
    list.iter().map(solid_value).collect()
}

/// Ball and stylus. The axis points from the ball to the spindle, in machine coordinates: the applicate of the plane in
/// which was measured.
fn ball(setup: &Setup, outcome: &Outcome) -> Value {
    let mut axis = [0.0; 3];
    axis[outcome.control.plane.axes()[2]] = 1.0;
    json!({ "radius": number(setup.probe.radius), "length": number(setup.probe.length), "axis": axis })
}

fn entries(trace: &Trace) -> Vec<Value> {
    trace.entries.iter().map(entry).collect()
}

fn entry(entry: &Entry) -> Value {
    let mut object = match step(&entry.step) {
        Value::Object(object) => object,
        _ => Map::new(),
    };
    if let Some(line) = entry.line {
        object.insert("line".into(), json!(line + 1));
    }
    Value::Object(object)
}

fn step(step: &Step) -> Value {
    match step {
        Step::Motion {
            kind,
            from,
            to,
            feed,
        } => {
            json!({ "step": "motion", "kind": kind_name(*kind), "from": from, "to": to, "feed": feed })
        }
        Step::Touch {
            latched,
            ball,
            point,
            normal,
        } => {
            json!({ "step": "touch", "latched": latched, "ball": ball, "point": point, "normal": normal })
        }
        Step::Crash { point } => json!({ "step": "crash", "point": point }),
        Step::Orient(angle) => json!({ "step": "orient", "angle": angle }),
        Step::Tool(tool, edge) => json!({ "step": "tool", "tool": tool, "edge": edge }),
        Step::Set {
            name,
            before,
            after,
        } => json!({ "step": "set", "name": name, "before": before, "after": after }),
        Step::Decision(text) => json!({ "step": "decision", "message": message(text) }),
        Step::Alarm(code) => {
            let mut value = alarm(*code);
            value["step"] = json!("alarm");
            value
        }
        Step::Message(text) => json!({ "step": "message", "text": text }),
        Step::Log(text) => json!({ "step": "log", "text": text }),
        Step::CallBegin { cycle, variant } => {
            json!({ "step": "call", "cycle": cycle, "variant": variant })
        }
        Step::CallEnd => json!({ "step": "return" }),
    }
}

fn kind_name(kind: MotionKind) -> &'static str {
    match kind {
        MotionKind::Rapid => "rapid",
        MotionKind::Positioning => "positioning",
        MotionKind::Measuring => "measuring",
        MotionKind::Retract => "retract",
    }
}

/// The machine's coordinate system where it is another one, the active workpiece coordinate system before, and after
/// where a correction moved it.
fn frames(before: &Control, after: &Control) -> Vec<Value> {
    let mut corrected = after.clone();
    corrected.activate(after.settable);
    let drawn = |name: String, control: &Control| {
        let at = control.to_machine([0.0; 3]);
        let axis = |direction: [f64; 3]| {
            let end = control.to_machine(direction);
            [end[0] - at[0], end[1] - at[1], end[2] - at[2]]
        };
        json!({ "name": name, "at": at, "axes": [axis([1.0, 0.0, 0.0]), axis([0.0, 1.0, 0.0]), axis([0.0, 0.0, 1.0])] })
    };
    let name = settable_name(before, before.settable);
    let mut list = Vec::new();
    if before.to_machine([0.0; 3]) != [0.0; 3] {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        list.push(json!({ "name": "MCS", "at": [0.0, 0.0, 0.0], "axes": axes }));
    }
    list.push(drawn(format!("WCS {name}"), before));
    if corrected.to_machine([0.0; 3]) != before.to_machine([0.0; 3]) {
        list.push(drawn(format!("WCS {name}′"), &corrected));
    }
    list
}
