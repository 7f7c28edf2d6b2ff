//! A run held against what must come of it.

use super::file::{Expected, ExpectedCall};
use crate::control::{AXES, Value};
use crate::diagnostic::Severity;
use crate::machine::{MotionKind, Step, Stop};
use crate::message::Message;
use crate::run::Outcome;
use std::collections::{BTreeMap, BTreeSet};

/// By how much a number may differ, in its unit, where the scenario says nothing.
const TOLERANCE: f64 = 1e-6;

/// How a run differs from what must come of it; empty: it does not.
pub fn differences(expected: &Expected, outcome: &Outcome) -> Vec<Message> {
    let mut held = Held { tolerance: expected.tolerance.unwrap_or(TOLERANCE), found: Vec::new() };
    held.stop(expected.stop.as_ref(), outcome.stop.as_ref());
    if expected.stop.is_none() {
        let errors = outcome.diagnostics.iter().filter(|one| one.severity == Severity::Error);
        // what stopped the run is one of them, and told already
        for one in errors {
            if !held.found.contains(&one.message) {
                held.found.push(one.message.clone());
            }
        }
    }
    if let Some(alarms) = &expected.alarms {
        held.alarms(alarms, outcome);
    }
    held.data(expected, outcome);
    if let Some(calls) = &expected.calls {
        held.calls(calls, outcome);
    }
    held.path(expected, outcome);
    if let Some(lines) = &expected.log {
        held.lines("log", lines, &outcome.log());
    }
    if let Some(files) = &expected.files {
        held.files(files, outcome);
    }
    held.found
}

/// What differs so far.
struct Held {
    tolerance: f64,
    found: Vec<Message>,
}

impl Held {
    fn stop(&mut self, expected: Option<&Value>, found: Option<&Stop>) {
        let (expected, caused) = (expected.map(named), found.map(cause));
        if expected == caused {
            return;
        }
        // what a fault is about stands in its own line
        let fault = found.and_then(|stop| if let Stop::Fault(message) = stop { Some(message) } else { None });
        let told = fault.filter(|message| !message.args.is_empty());
        let found = told.map_or(caused, |_| Some("scenario-fault".to_owned()));
        let key = match (&expected, &found) {
            (None, _) => "scenario-stopped",
            (Some(_), None) => "scenario-not-stopped",
            _ => "scenario-stopped-otherwise",
        };
        let texts = Message::new(key).text("expected", expected.unwrap_or_default());
        self.found.push(texts.text("found", found.unwrap_or_default()));
        self.found.extend(told.cloned());
    }

    fn alarms(&mut self, expected: &[Value], outcome: &Outcome) {
        let expected: Vec<String> = expected.iter().map(named).collect();
        let found: Vec<String> = outcome.alarms().iter().map(ToString::to_string).collect();
        if expected != found {
            let all = |codes: Vec<String>| if codes.is_empty() { "–".to_owned() } else { codes.join(", ") };
            self.differs("scenario-alarms", "", all(found), all(expected));
        }
    }

    /// What the control holds afterwards.
    fn data(&mut self, expected: &Expected, outcome: &Outcome) {
        let control = &outcome.control;
        for (name, value) in expected.data.iter().flatten() {
            let there = !name.starts_with('$') && control.knows(name, &Value::Number(*value));
            if !there && !control.data.contains_key(name) {
                self.found.push(Message::new("scenario-datum").text("name", name));
                continue;
            }
            self.value(name, *value, Some(control.number(name)));
        }
        let written = outcome.written();
        for (name, value) in expected.written.iter().flatten() {
            self.value(name, *value, written.get(name.as_str()).copied());
        }
        for (name, value) in expected.variables.iter().flatten() {
            self.value(name, *value, control.variable(name));
        }
        for (name, origin) in expected.origins.iter().flatten() {
            let frame = control.make().settable_named(name).and_then(|number| control.frames.get(&number));
            self.point(name, *origin, frame.map(|frame| frame.origin()));
        }
        let Some(expected) = &expected.changes else { return };
        let changes: BTreeMap<String, f64> = outcome.changes().into_iter().map(|one| (one.name, one.after)).collect();
        self.exactly("", expected, &changes);
    }

    /// These names with these values and no others.
    fn exactly(&mut self, whose: &str, expected: &BTreeMap<String, f64>, found: &BTreeMap<String, f64>) {
        let names: BTreeSet<&String> = expected.keys().chain(found.keys()).collect();
        for name in names {
            let told = format!("{whose}{name}");
            match expected.get(name) {
                Some(value) => self.value(&told, *value, found.get(name).copied()),
                None => self.differs("scenario-more", &told, shown(found[name]), String::new()),
            }
        }
    }

    fn calls(&mut self, expected: &[ExpectedCall], outcome: &Outcome) {
        let left = outcome.left();
        self.count("calls", left.len(), expected.len());
        for (left, expected) in left.iter().zip(expected) {
            let (line, cycle) = (left.call.line + 1, left.call.cycle);
            let place = format!("{line}: {cycle}");
            if line != expected.line || cycle != expected.cycle {
                let wanted = format!("{}: {}", expected.line, expected.cycle);
                self.differs("scenario-call", "", place, wanted);
                continue;
            }
            let results = left.results.iter().map(|(field, value)| (field.name.to_owned(), *value)).collect();
            self.exactly(&format!("{place}: "), &expected.results, &results);
        }
    }

    /// Where it goes and measures.
    fn path(&mut self, expected: &Expected, outcome: &Outcome) {
        let steps = || outcome.trace.entries.to_vec().into_iter().map(|entry| entry.step);
        let measuring = |step: Step| match step {
            Step::Motion { kind: MotionKind::Measuring, from, feed, .. } => Some((from.0, feed)),
            _ => None,
        };
        if let Some(expected) = &expected.starts {
            let found: Vec<_> = steps().filter_map(measuring).map(|(from, _)| from).collect();
            self.points("starts", expected, &found);
        }
        if let Some(expected) = &expected.touches {
            let touched = |step| if let Step::Touch { latched, .. } = step { Some(latched.0) } else { None };
            self.points("touches", expected, &steps().filter_map(touched).collect::<Vec<_>>());
        }
        if let Some(expected) = &expected.ends {
            self.points("ends", expected, &ends(steps()));
        }
        if let Some(expected) = expected.feed {
            let found: Vec<f64> = steps().filter_map(measuring).map(|(_, feed)| feed).collect();
            self.numbers("feed", &vec![expected; found.len().max(1)], &found);
        }
        if let Some(expected) = &expected.orientations {
            let turned = |step| if let Step::Orient { angle } = step { Some(angle.0) } else { None };
            self.numbers("orientations", expected, &steps().filter_map(turned).collect::<Vec<_>>());
        }
    }

    fn files(&mut self, expected: &BTreeMap<String, Vec<String>>, outcome: &Outcome) {
        let found: BTreeMap<&str, &[String]> = outcome.files.iter().collect();
        self.count("files", found.len(), expected.len());
        for (name, lines) in expected {
            match found.get(name.as_str()) {
                Some(found) => self.lines(name, lines, &found.iter().map(String::as_str).collect::<Vec<_>>()),
                None => self.found.push(Message::new("scenario-no-file").text("name", name)),
            }
        }
    }

    fn lines(&mut self, name: &str, expected: &[String], found: &[&str]) {
        self.count(name, found.len(), expected.len());
        for (number, (found, expected)) in found.iter().zip(expected).enumerate() {
            if found != expected {
                self.differs("scenario-text", &element(name, number), (*found).to_owned(), expected.clone());
            }
        }
    }

    fn points(&mut self, name: &str, expected: &[[f64; 3]], found: &[[f64; 3]]) {
        self.count(name, found.len(), expected.len());
        for (number, (expected, found)) in expected.iter().zip(found).enumerate() {
            self.point(&element(name, number), *expected, Some(*found));
        }
    }

    fn point(&mut self, name: &str, expected: [f64; 3], found: Option<[f64; 3]>) {
        for (axis, letter) in AXES.into_iter().enumerate() {
            self.value(&format!("{name} {letter}"), expected[axis], found.map(|found| found[axis]));
        }
    }

    fn numbers(&mut self, name: &str, expected: &[f64], found: &[f64]) {
        self.count(name, found.len(), expected.len());
        for (number, (expected, found)) in expected.iter().zip(found).enumerate() {
            self.value(&element(name, number), *expected, Some(*found));
        }
    }

    fn count(&mut self, name: &str, found: usize, expected: usize) {
        if found != expected {
            self.differs("scenario-count", name, found.to_string(), expected.to_string());
        }
    }

    fn value(&mut self, name: &str, expected: f64, found: Option<f64>) {
        match found {
            Some(found) if (found - expected).abs() <= self.tolerance => {}
            Some(found) => self.differs("scenario-value", name, shown(found), shown(expected)),
            None => self.differs("scenario-none", name, String::new(), shown(expected)),
        }
    }

    fn differs(&mut self, key: &'static str, name: &str, found: String, expected: String) {
        let message = Message::new(key).text("name", name);
        self.found.push(message.text("found", found).text("expected", expected));
    }
}

/// A place in a list, from 1.
fn element(name: &str, number: usize) -> String {
    format!("{name} {}", number + 1)
}

/// An alarm, a message of NCT, a fault, as a scenario names it.
fn named(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => text.clone(),
    }
}

/// What stopped a run, in the same way.
pub(super) fn cause(stop: &Stop) -> String {
    match stop {
        Stop::Alarm(code) => code.to_string(),
        Stop::Fault(message) => message.key.to_string(),
    }
}

/// With as many decimals as are compared.
fn shown(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Where the machine stands at the end of every call.
fn ends(steps: impl Iterator<Item = Step>) -> Vec<[f64; 3]> {
    let mut here = [0.0; 3];
    let mut ends = Vec::new();
    for step in steps {
        match step {
            Step::Motion { to, .. } => here = to.0,
            Step::CallEnd => ends.push(here),
            _ => {}
        }
    }
    ends
}
