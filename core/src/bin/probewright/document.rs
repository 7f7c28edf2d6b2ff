//! The document of a run. Its steps are written one by one: together they would take many times the room of the run.

use crate::file::Problem;
use probewright_core::app::{RunView, happened};
use probewright_core::control::Control;
use probewright_core::json;
use probewright_core::machine::Entries;
use probewright_core::run::Outcome;
use probewright_core::words::Words;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::Value;
use std::io::Write;

/// Members of the document in which the steps are.
const STEPS: [&str; 2] = ["trace", "entries"];

/// Writes what a run did, with the sentence beside every key; gives it back.
pub fn print(mut view: RunView, words: &Words, out: &mut dyn Write) -> Result<Outcome, Problem> {
    view.trace.apart = true;
    let mut document = json::document(&view);
    words.speak(&mut document);
    let outcome = &view.trace.outcome;
    let steps = Steps { entries: &outcome.trace.entries, control: &outcome.control, words };
    serde_json::to_writer_pretty(&mut *out, &Part { document: &document, below: &STEPS, steps: &steps })?;
    writeln!(out)?;
    Ok(view.trace.outcome)
}

/// A part of the document, with the steps at this place below it.
struct Part<'a> {
    document: &'a Value,
    below: &'a [&'a str],
    steps: &'a Steps<'a>,
}

impl Serialize for Part<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Some((next, below)) = self.below.split_first() else { return self.steps.serialize(to) };
        let Some(members) = self.document.as_object() else { return self.document.serialize(to) };
        let mut map = to.serialize_map(Some(members.len()))?;
        for (name, document) in members {
            if name == next {
                map.serialize_entry(name, &Part { document, below, steps: self.steps })?;
            } else {
                map.serialize_entry(name, document)?;
            }
        }
        map.end()
    }
}

struct Steps<'a> {
    entries: &'a Entries,
    control: &'a Control,
    words: &'a Words,
}

impl Serialize for Steps<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(happened(self.entries, self.control).map(|step| {
            let mut step = json::document(&step);
            self.words.speak(&mut step);
            step
        }))
    }
}
