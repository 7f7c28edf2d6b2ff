//! What a call did.

use super::answer::{self, Answer};
use super::changes::{Change, changes};
use super::predict::ErrorLimit;
use super::supply::Offer;
use super::written::{WrittenFile, written};
use crate::catalogue::alarms::newer_cure;
use crate::control::Control;
use crate::diagnostic::Code;
use crate::entry::{Inputs, result_unit};
use crate::machine::Stop;
use crate::message::Message;
use crate::scene::Source;
use crate::{catalogue, run};
use serde::Serialize;

/// What a call does.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Outcome {
    /// What it came to; absent where nothing is measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub answer: Option<Answer>,
    /// What it wrote, and what it would have written but left as it was.
    pub results: Vec<Measured>,
    /// Decisions of the tolerance chain in order, the branch taken last.
    pub decisions: Vec<Message>,
    /// Alarms raised, the one that stopped it last.
    pub alarms: Vec<Raised>,
    /// Tool wear, zero offsets, memories, …
    pub changes: Vec<Change>,
    /// Lines of the print-out, and blocks that were sent.
    pub log: Vec<String>,
    /// Files that it leaves on the control: the log of measurements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<WrittenFile>>"))]
    pub written: Vec<WrittenFile>,
    /// Everything that happened.
    pub trace: Source,
    /// Where asked for: up to which errors it comes to its end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<Vec<ErrorLimit>>,
}

/// A result of a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Measured {
    /// `_OVR[4]`.
    pub name: &'static str,
    /// Meaning of the result.
    pub label: Message,
    /// Value of the result.
    pub value: f64,
    /// Unit on this machine.
    pub unit: &'static str,
    /// There where this call did not write it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(type = "0"))]
    pub earlier: Option<u8>,
}

/// An alarm that was raised, or why a simulation went no further.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Raised {
    /// Name of the alarm; empty: none of the control.
    pub code: String,
    /// What it says.
    pub message: Message,
    /// What helps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<Message>,
    /// Whether it stops the program.
    pub stops: bool,
    /// What the machine lacks, each a fix.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<Offer>>"))]
    pub offers: Vec<Offer>,
}

impl Outcome {
    pub(super) fn new(inputs: &Inputs, trace: Source, limits: Option<Vec<ErrorLimit>>) -> Outcome {
        let outcome = &trace.outcome;
        Outcome {
            answer: answer::of_call(inputs, outcome),
            results: results(inputs, outcome),
            decisions: outcome.decisions().into_iter().cloned().collect(),
            alarms: alarms(outcome),
            changes: changes(outcome),
            log: outcome.log().into_iter().map(str::to_owned).collect(),
            written: written(outcome),
            trace,
            limits,
        }
    }
}

fn results(inputs: &Inputs, outcome: &run::Outcome) -> Vec<Measured> {
    let unwritten = outcome.unwritten(inputs.cycle);
    let of_variant = outcome.results(inputs.cycle).into_iter().filter(|(field, _)| field.when.holds(inputs));
    let result = of_variant.map(|(field, value)| Measured {
        name: field.name,
        label: Message::new(field.key),
        value,
        unit: result_unit(field.unit, outcome.before.active_units, outcome.before.basic_units),
        earlier: unwritten.contains(field.name).then_some(0),
    });
    result.collect()
}

/// Alarms raised, the one that stopped the run last, a fault of the simulation after them.
pub(super) fn alarms(outcome: &run::Outcome) -> Vec<Raised> {
    let fault = outcome.stop.iter().filter(|stop| matches!(stop, Stop::Fault(_)));
    let raised = outcome.alarms().into_iter().map(|code| Raised::alarm(code).on(&outcome.control));
    raised.chain(fault.map(Raised::stop)).collect()
}

impl Raised {
    /// An alarm.
    pub fn alarm(code: Code) -> Raised {
        let key = catalogue::alarms::key(code);
        Raised {
            code: code.to_string(),
            hint: Some(Message::new(format!("{key}.cure"))),
            message: Message::new(key),
            stops: catalogue::alarms::stops(code),
            offers: Vec::new(),
        }
    }

    /// With the remedy of the generation of this control.
    pub(super) fn on(self, control: &Control) -> Raised {
        let hint = newer_cure(&self.code, control).map(Message::new).or(self.hint);
        Raised { hint, ..self }
    }

    /// Why something did not go on.
    pub fn stop(stop: &Stop) -> Raised {
        match stop {
            Stop::Alarm(code) => Raised::alarm(*code),
            Stop::Fault(message) => {
                Raised { code: String::new(), message: message.clone(), hint: None, stops: true, offers: Vec::new() }
            }
        }
    }
}
