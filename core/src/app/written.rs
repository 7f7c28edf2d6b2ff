//! Files that a run left on the control.

use crate::machine::trace::Step;
use crate::run::Outcome;
use serde::Serialize;

/// A file that a run left on the control: the log of measurements.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct WrittenFile {
    /// As the control shows it: `LOG_1.MPF`.
    pub name: String,
    /// Its lines.
    pub lines: Vec<String>,
    /// Index of the entry of the trace with which each line was written.
    pub at: Vec<usize>,
}

/// All files of a run, by name.
pub(super) fn written(outcome: &Outcome) -> Vec<WrittenFile> {
    let file = |(name, lines): (&str, &[String])| WrittenFile {
        name: name.to_owned(),
        lines: lines.to_vec(),
        at: entries(outcome, name, lines.len()),
    };
    outcome.files.iter().map(file).collect()
}

/// Entries that wrote the lines of a file since it was made last. What the trace has no room for belongs to the last.
fn entries(outcome: &Outcome, name: &str, count: usize) -> Vec<usize> {
    let mut at = Vec::new();
    for (index, entry) in outcome.trace.entries.iter().enumerate() {
        match &entry.step {
            Step::File { name: of, text } if of == name => match text {
                Some(_) => at.push(index),
                None => at.clear(),
            },
            _ => {}
        }
    }
    at.resize(count, at.last().copied().unwrap_or_default());
    at
}
