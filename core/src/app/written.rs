//! Files that a run left on the control.

use crate::machine::trace::Step;
use crate::run::Outcome;
use serde::Serialize;
use std::collections::BTreeMap;

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
    let entries = entries(outcome);
    let file = |(name, lines): (&str, &[String])| {
        let mut at = entries.get(name).cloned().unwrap_or_default();
        at.resize(lines.len(), at.last().copied().unwrap_or_default());
        WrittenFile { name: name.to_owned(), lines: lines.to_vec(), at }
    };
    outcome.files.iter().map(file).collect()
}

/// Entries that wrote the lines of each file since it was made last. What the trace has no room for belongs to the last
/// one.
fn entries(outcome: &Outcome) -> BTreeMap<&str, Vec<usize>> {
    let mut all: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for other in outcome.trace.entries.others() {
        if let Step::File { name, text } = other.step {
            let at = all.entry(name).or_default();
            match text {
                Some(_) => at.push(other.at),
                None => at.clear(),
            }
        }
    }
    all
}
