//! The record of a run: every measurement with its limits, the probe and what came of it. Its schema is
//! `docs/record.schema.json`.

mod of_jog;
mod probes;
mod table;
#[cfg(test)]
mod tests;

pub(super) use of_jog::Recorder;
pub use probes::{CalibrationState, ProbeOfCall};
pub(super) use probes::{Probes, of_machine, probe_of};
pub use table::{TableCall, TableRequest, csv, record_table};

use super::jog::JogView;
use super::protocol::ProtocolView;
use super::run::{RunAnswer, amid, answers};
use crate::dialect::Dialect;
use crate::machine::{Clock, Setup};
use crate::message::Message;
use crate::run::Outcome;
use serde::{Deserialize, Serialize};

/// Version of the format.
const FORMAT: u32 = 1;

/// The record of a run. Lengths in the unit beside them, angles in degree. Every `key` names a text of Probewright and
/// stays the same in all languages; `text` is what it says.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "RunRecord"))]
pub struct Record {
    /// Version of this format: 1.
    pub format: u32,
    /// Name of the file with the program.
    pub program: String,
    /// Where the values come from.
    pub about: RecordAbout,
    /// Files beside the program: lines go on there.
    pub files: Vec<RecordFile>,
    /// How the run ended.
    pub ending: Message,
    /// The measuring calls in their order.
    pub calls: Vec<RunAnswer>,
}

/// A file beside the program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RecordFile {
    /// Name of the file.
    pub name: String,
    /// Its first line, from 1.
    pub line: u32,
}

/// Where the values of a record come from.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RecordAbout {
    /// Control.
    pub control: Dialect,
    /// What the user calls the machine; empty: nothing.
    pub machine: String,
    /// Date and time of the control when the program began, `2026-05-31T08:00:00`; empty: the setup gives none.
    pub clock: String,
    /// Diameter of the ball of the workpiece probe, mm.
    pub ball: f64,
    /// What such values are worth, and what they are not, a sentence each.
    pub worth: Vec<Message>,
}

impl RecordAbout {
    /// Of a run on a machine.
    pub fn new(setup: &Setup) -> RecordAbout {
        RecordAbout::of(setup, "record-worth-simulated")
    }

    /// Of values that a real machine measured.
    pub fn measured(setup: &Setup) -> RecordAbout {
        RecordAbout::of(setup, "record-worth-measured")
    }

    fn of(setup: &Setup, worth: &'static str) -> RecordAbout {
        RecordAbout {
            control: setup.control.dialect,
            machine: setup.name.clone(),
            clock: if setup.clock == Clock::default() { String::new() } else { setup.clock.to_string() },
            ball: 2.0 * setup.probe.radius,
            worth: [worth, "record-worth-machine"].map(Message::new).into(),
        }
    }
}

impl Record {
    /// Of a run of the program in the file of this name.
    pub fn new(program: String, setup: &Setup, outcome: &Outcome, files: Vec<RecordFile>) -> Record {
        let ending = outcome.ending(|line| match files.iter().rfind(|file| file.line <= line) {
            Some(file) => (Some(file.name.clone()), line - file.line + 1),
            None => (None, line),
        });
        let (about, calls) = (RecordAbout::new(setup), answers(setup, outcome));
        Record { format: FORMAT, program, about, files, ending, calls }
    }

    /// Of a session of measuring in JOG: its script in the file of this name. `setup`: the machine before it.
    pub fn of_jog(script: String, setup: &Setup, view: JogView) -> Record {
        let count = view.calls.len() as f64;
        let ending = Message::new("record-ending-jog").number("count", count);
        let about = RecordAbout::new(setup);
        Record { format: FORMAT, program: script, about, files: Vec::new(), ending, calls: view.calls }
    }

    /// Of the values that a protocol of a real machine has for the calls of a program.
    pub fn measured(program: String, view: ProtocolView, files: Vec<RecordFile>) -> Record {
        let ProtocolView { about, ending, answers, .. } = view;
        Record { format: FORMAT, program, about, files, ending, calls: answers }
    }
}
