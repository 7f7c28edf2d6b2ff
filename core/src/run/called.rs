//! The measuring calls that a run carried out, with what they were given.

use super::Outcome;
use crate::catalogue::log;
use crate::control::{Control, Units};
use crate::entry::{Cycle, Inputs, Unit, result_unit};
use crate::machine::{Entry, Step};

/// A call that was carried out, or that its check refused.
#[derive(Clone, Debug, PartialEq)]
pub struct Called {
    /// Index of the entry of the trace with which it begins.
    pub at: usize,
    /// What it was given; of one that was refused nothing.
    pub inputs: Inputs,
    /// Active system of units at the call.
    pub units: Units,
    /// Basic system of the machine.
    pub basic: Units,
    /// What its block of values in the log shows; none: it is not logged.
    pub log: Option<log::Layout>,
    /// What the results of its cycle held when a result screen showed them, in their order; empty: none did.
    pub shown: Vec<f64>,
}

/// Whether a call of this cycle is a measurement: it touches, and leaves what it found.
pub fn measures(cycle: &Cycle) -> bool {
    cycle.purpose.probe.measures() && !cycle.results.is_empty()
}

/// Keeps of the last call what a result screen shows now: later calls write other values.
pub fn show(called: &mut [Called], control: &Control) {
    if let Some(last) = called.last_mut().filter(|last| last.shown.is_empty()) {
        last.shown = last.inputs.cycle.results.iter().map(|field| control.number(field.name)).collect();
    }
}

impl Called {
    /// Name of the unit in which a result of this rule stands.
    pub fn unit(&self, unit: Unit) -> &'static str {
        result_unit(unit, self.units, self.basic)
    }

    /// What happened in it, and whether it came to its end.
    pub fn entries(&self, outcome: &Outcome) -> (Vec<Entry>, bool) {
        let mut own = Vec::new();
        let mut depth = 0_usize;
        for entry in outcome.trace.entries.behind(self.at) {
            own.push(entry);
            match own.last().map(|last| &last.step) {
                Some(Step::CallBegin { .. }) => depth += 1,
                Some(Step::CallEnd) if depth <= 1 => return (own, true),
                Some(Step::CallEnd) => depth -= 1,
                _ => {}
            }
        }
        (own, false)
    }
}
