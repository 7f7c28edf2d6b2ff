//! What came out of a run, put the way a page or a terminal shows it.

use crate::control::{Control, Value, gud, nct_data};
use crate::diagnostic::{Code, Diagnostic};
use crate::dialect::Dialect;
use crate::entry::{Cycle, ResultField};
use crate::geometry::{Mcs, TOLERANCE, Wcs};
use crate::machine::setup::Setup;
use crate::machine::trace::{Step, Trace};
use crate::machine::{Sim, Stop};
use crate::message::{Arg, Message};
use crate::scan::Sent;
use std::collections::{BTreeMap, BTreeSet};

/// After a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// State before.
    pub before: Control,
    /// State after.
    pub control: Control,
    /// Position after, of the point to which the tool length refers.
    pub position: Mcs,
    /// What happened.
    pub trace: Trace,
    /// What was scanned, whole: of a long scan the trace holds the beginning only.
    pub scans: Vec<Sent>,
    /// Why it ended early; none: to its end.
    pub stop: Option<Stop>,
    /// Problems found in the program while running; empty for a single call.
    pub diagnostics: Vec<Diagnostic>,
    /// What the run went on without, in its order.
    pub passed_over: Vec<PassedOver>,
    /// Line of the last block, from 1; none for a single call.
    pub line: Option<u32>,
}

/// Most words that the end of a run names.
const NAMED: usize = 20;

/// A word or call that the run went on without.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PassedOver {
    /// As it stands in the program.
    pub word: String,
    /// Its line, from 1.
    pub line: u32,
}

/// Something that is different after a run. Lengths in mm, also of memories that an inch machine keeps in inch.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// `$TC_DP15[20,1]`, `$P_UIFR[1,X,FI]`, `_MV[9]`.
    pub name: String,
    /// Before.
    pub before: f64,
    /// After.
    pub after: f64,
}

impl Outcome {
    /// Whether the run reached its end.
    pub fn finished(&self) -> bool {
        self.stop.is_none()
    }

    /// How the run ended: at its end or before, and what it went on without.
    pub fn ending(&self) -> Message {
        let named = self.passed_over.iter().take(NAMED);
        let named = named.map(|one| format!("{} ({})", one.word, one.line));
        let mut words: Vec<String> = named.collect();
        if self.passed_over.len() > NAMED {
            words.push("…".to_owned());
        }
        let key = match (self.finished(), words.is_empty()) {
            (true, true) => "run-ended",
            (true, false) => "run-ended-without",
            (false, true) => "run-ended-early",
            (false, false) => "run-ended-early-without",
        };
        let line = f64::from(self.line.unwrap_or(0));
        let mut message = Message::new(key).number("line", line);
        // each of them is short already, and each is to be named
        message.args.push(("words", Arg::Text(words.join(", "))));
        message
    }

    /// The results of a cycle with the values they have now. Those of a macro of NCT have names of ours, and are none
    /// before it has written them; user data of the other control are there before.
    pub fn results(&self, cycle: &'static Cycle) -> Vec<(&'static ResultField, f64)> {
        let there =
            |field: &&ResultField| cycle.dialect == Dialect::Sinumerik || self.control.data.get(field.name).is_some();
        cycle.results.iter().filter(there).map(|field| (field, self.control.number(field.name))).collect()
    }

    /// Tools, frames, mean values and calibrated values of probes that are different now, in the order of the names.
    /// Less than the resolution of contact is no difference.
    pub fn changes(&self) -> Vec<Change> {
        let [before, after] = [&self.before, &self.control].map(addressable);
        let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
        // what does not exist on one side counts there as a control reads it: a frame has scale factors of 1
        let value = |side: &BTreeMap<String, f64>, control: &Control, name: &String| {
            let known = side.get(name).copied();
            known.or_else(|| control.variable(name)).unwrap_or(0.0) + 0.0 // a 0 has no sign
        };
        let changes = names.into_iter().map(|name| Change {
            name: name.clone(),
            before: value(&before, &self.before, name),
            after: value(&after, &self.control, name),
        });
        changes.filter(|change| (change.before - change.after).abs() > TOLERANCE).collect()
    }

    /// What each step tells, in order.
    fn told<'a, T>(&'a self, tell: impl FnMut(&'a Step) -> Option<T>) -> Vec<T> {
        self.trace.entries.iter().map(|entry| &entry.step).filter_map(tell).collect()
    }

    /// Alarms and operator messages, in order; the one that stopped the run last.
    pub fn alarms(&self) -> Vec<Code> {
        let mut alarms = self.told(|step| match step {
            Step::Alarm(code) => Some(*code),
            _ => None,
        });
        if let Some(Stop::Alarm(code)) = self.stop
            && alarms.last() != Some(&code)
        {
            alarms.push(code);
        }
        alarms
    }

    /// Decisions of the cycles, in order.
    pub fn decisions(&self) -> Vec<&Message> {
        self.told(|step| match step {
            Step::Decision { message } => Some(message),
            _ => None,
        })
    }

    /// Lines of the measuring log or print-out, and blocks that were sent, in order.
    pub fn log(&self) -> Vec<&str> {
        self.told(|step| match step {
            Step::Log { text } | Step::Sent { text } => Some(text.as_str()),
            _ => None,
        })
    }

    /// Lines of the measuring log or print-out alone.
    pub fn printed(&self) -> Vec<&str> {
        self.told(|step| match step {
            Step::Log { text } => Some(text.as_str()),
            _ => None,
        })
    }

    /// Results that the cycles wrote, by name, with their last values; tools and frames are in [`Outcome::changes`].
    pub fn written(&self) -> BTreeMap<&str, f64> {
        let written = self.told(|step| match step {
            Step::Set { name, after, .. } if !name.starts_with('$') => Some((name.as_str(), *after)),
            _ => None,
        });
        written.into_iter().collect()
    }

    /// Position after, in the WCS that is active now.
    pub fn end(&self) -> Wcs {
        self.control.to_workpiece(self.position)
    }

    /// An outcome where nothing has happened yet.
    pub fn new(setup: &Setup) -> Outcome {
        Outcome {
            before: setup.control.clone(),
            control: setup.control.clone(),
            position: setup.position,
            trace: Trace::default(),
            scans: Vec::new(),
            stop: None,
            diagnostics: Vec::new(),
            passed_over: Vec::new(),
            line: None,
        }
    }

    /// What a machine leaves that began as the setup says.
    pub fn left_by(sim: Sim, before: &Setup, stop: Option<Stop>) -> Outcome {
        let Sim { control, position, trace, scans, line, .. } = sim;
        Outcome { control, position, trace, scans, stop, line: line.map(|line| line + 1), ..Outcome::new(before) }
    }
}

/// Every corrected quantity by the name a program would use for it, lengths in mm.
fn addressable(control: &Control) -> BTreeMap<String, f64> {
    let names = control.variable_names().into_iter();
    let variables = names.filter_map(|name| control.variable(&name).map(|value| (name, value)));
    let memories = control.data.iter().filter_map(|(name, value)| match value {
        Value::Number(value) if remembered(name) => Some((name.clone(), value * control.basic_factor())),
        _ => None,
    });
    variables.chain(memories).collect()
}

/// User data in which later measurements find what this one left: empirical and mean values, how a workpiece probe and
/// a tool probe were calibrated, and where.
const MEMORIES: [&str; 6] = ["_EV[", "_MV[", "_WP[", "_TP[", "_TPW[", "_KB["];

/// Whether a datum is one of these, or a calibrated value of NCT, and a length: the code of the calibration status
/// tells nobody anything.
fn remembered(name: &str) -> bool {
    if let Some(datum) = nct_data::find(name) {
        return datum.element.unit == gud::Unit::Length(gud::System::Basic);
    }
    let length = |(gud, at): (&gud::Gud, Vec<usize>)| {
        gud.element(&at).is_some_and(|element| element.unit == gud::Unit::Length(gud::System::Basic))
    };
    MEMORIES.iter().any(|stem| name.starts_with(stem)) && gud::place(name).is_some_and(length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::Plane;
    use crate::dialect::Dialect;

    // oracle: hand
    #[test]
    fn a_frame_that_was_not_there_differs_by_what_was_written() {
        let mut outcome = Outcome::new(&Setup::calibrated(Dialect::Sinumerik, Plane::G17));
        assert!(outcome.control.set_variable("$P_UIFR[7,X,TR]", 1.5));
        let change = Change { name: "$P_UIFR[7,X,TR]".into(), before: 0.0, after: 1.5 };
        assert_eq!(outcome.changes(), [change]);
    }

    // oracle: manual B:13357 (a trigger point), B:13366 (the shape of the probe is none), C:92-94 (#500 of NCT)
    #[test]
    fn what_a_calibration_found_is_a_change() {
        for (dialect, name, other) in [
            (Dialect::Sinumerik, "_TP[0,0]", "_TP[0,8]"),
            (Dialect::Sinumerik, "_TPW[2,3]", "_TPW[2,8]"),
            (Dialect::Nct, "#500", "#150"),
        ] {
            let mut outcome = Outcome::new(&Setup::calibrated(dialect, Plane::G17));
            let before = outcome.before.number(name);
            outcome.control.set(name, before + 0.25);
            outcome.control.set(other, 101.0);
            let changes = outcome.changes();
            let [change] = &changes[..] else {
                unreachable!("{changes:?}");
            };
            assert_eq!((&*change.name, change.after - change.before), (name, 0.25));
        }
    }

    // oracle: hand
    #[test]
    fn the_last_bits_of_a_sum_are_no_change() {
        let mut outcome = Outcome::new(&Setup::calibrated(Dialect::Sinumerik, Plane::G17));
        for (name, value) in [("$P_UIFR[2,X,FI]", 0.1), ("$P_UIFR[2,Y,FI]", -2.8e-14)] {
            assert!(outcome.control.set_variable(name, value));
        }
        let changes = outcome.changes();
        assert!(matches!(&changes[..], [change] if change.name == "$P_UIFR[2,X,FI]"));
    }
}
