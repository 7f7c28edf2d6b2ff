//! What came out of a run, put the way a page or a terminal shows it.

use super::called::Called;
use super::limits::NO_END;
use super::of_machine::MachineValue;
use crate::control::{Control, Value, gud, nct_data};
use crate::diagnostic::{Code, Diagnostic};
use crate::dialect::Dialect;
use crate::entry::{Cycle, ResultField};
use crate::geometry::{Mcs, TOLERANCE, Wcs};
use crate::machine::{Files, Setup, Sim, Step, Stop, Trace};
use crate::message::{Arg, Message, printable};
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
    /// Files that it left on the control.
    pub files: Files,
    /// Why it ended early; none: to its end.
    pub stop: Option<Stop>,
    /// Problems found in the program while running; empty for a single call.
    pub diagnostics: Vec<Diagnostic>,
    /// What the run went on without, in its order.
    pub passed_over: Vec<PassedOver>,
    /// Values that only the machine has and that were assumed, in the order of the text.
    pub machine_values: Vec<MachineValue>,
    /// Line of the last block, from 1; none for a single call.
    pub line: Option<u32>,
    /// The measuring calls of a program, in their order; empty for a single call.
    pub called: Vec<Called>,
}

/// Most words that the end of a run names.
const NAMED: usize = 20;

/// A word or call that the run went on without.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PassedOver {
    /// As it is in the program.
    pub word: String,
    /// Line of the word, from 1.
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

    /// Why it was given up where it did not come to an end: another run takes as long, and tells nothing.
    pub fn given_up(&self) -> Option<&Message> {
        match &self.stop {
            Some(Stop::Fault(message)) if message.key == NO_END => Some(message),
            _ => None,
        }
    }

    /// How the run ended: at its end or before, and what it went on without. `place`: the file that holds a line of
    /// the text (from 1) where that is not the program itself, and the line in it.
    pub fn ending(&self, place: impl Fn(u32) -> (Option<String>, u32)) -> Message {
        let named = self.passed_over.iter().take(NAMED).map(|one| match place(one.line) {
            (Some(file), line) => format!("{} ({}:{line})", one.word, printable(&file)),
            (None, line) => format!("{} ({line})", one.word),
        });
        let mut words: Vec<String> = named.collect();
        if self.passed_over.len() > NAMED {
            words.push("…".to_owned());
        }
        let (file, line) = self.line.map_or((None, 0), place);
        let key = match (self.finished(), words.is_empty(), &file) {
            (true, true, _) => "run-ended",
            (true, false, _) => "run-ended-without",
            (false, true, None) if self.line.is_none() => "run-ended-before",
            (false, true, None) => "run-ended-early",
            (false, false, None) => "run-ended-early-without",
            (false, true, Some(_)) => "run-ended-in-file",
            (false, false, Some(_)) => "run-ended-in-file-without",
        };
        let mut message = Message::new(key).number("line", f64::from(line));
        if let Some(file) = file {
            message = message.text("file", file);
        }
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

    /// Tools, frames, mean and calibrated values that differ now by more than contact resolves, ordered by name.
    pub fn changes(&self) -> Vec<Change> {
        let before = addressable(&self.before, &self.control);
        let after = addressable(&self.control, &self.before);
        let names: BTreeSet<&String> = before.keys().chain(after.keys()).collect();
        // what does not exist on one side counts there as a control reads it: a frame has scale factors of 1
        let value = |side: &BTreeMap<String, f64>, control: &Control, name: &String| {
            side.get(name).copied().or_else(|| control.variable(name)).unwrap_or(0.0) + 0.0 // a 0 has no sign
        };
        let changes = names.into_iter().map(|name| Change {
            name: name.clone(),
            before: value(&before, &self.before, name),
            after: value(&after, &self.control, name),
        });
        changes.filter(|change| (change.before - change.after).abs() > TOLERANCE).collect()
    }

    /// What each step that is no motion tells, in order.
    fn told<'a, T>(&'a self, tell: impl FnMut(&'a Step) -> Option<T>) -> Vec<T> {
        self.trace.entries.others().map(|other| other.step).filter_map(tell).collect()
    }

    /// Alarms and operator messages, in order; the one that stopped the run last.
    pub fn alarms(&self) -> Vec<Code> {
        let mut alarms = self.told(|step| if let Step::Alarm(code) = step { Some(*code) } else { None });
        if let Some(Stop::Alarm(code)) = self.stop
            && alarms.last() != Some(&code)
        {
            alarms.push(code);
        }
        alarms
    }

    /// Decisions of the cycles, in order.
    pub fn decisions(&self) -> Vec<&Message> {
        self.told(|step| if let Step::Decision { message } = step { Some(message) } else { None })
    }

    /// Lines of the measuring log or print-out, and blocks that were sent, in order.
    pub fn log(&self) -> Vec<&str> {
        self.told(|step| if let Step::Log { text } | Step::Sent { text } = step { Some(text.as_str()) } else { None })
    }

    /// Lines of the measuring log or print-out alone.
    pub fn printed(&self) -> Vec<&str> {
        self.told(|step| if let Step::Log { text } = step { Some(text.as_str()) } else { None })
    }

    /// Results that the cycles wrote, by name, with their last values; tools and frames are in [`Outcome::changes`].
    pub fn written(&self) -> BTreeMap<&str, f64> {
        let later = self.trace.later.iter().map(|(name, after)| (name.as_str(), *after));
        self.told(set).into_iter().chain(later).filter(|(name, _)| !name.starts_with('$')).collect()
    }

    /// Position after, in the WCS that is active now.
    pub fn end(&self) -> Wcs {
        self.control.to_workpiece(self.position)
    }

    /// An outcome where nothing has happened yet.
    pub fn new(setup: &Setup) -> Outcome {
        Outcome::left_by(Sim::new(setup), setup, None)
    }

    /// What a machine leaves that began as the setup says.
    pub fn left_by(sim: Sim, before: &Setup, stop: Option<Stop>) -> Outcome {
        let (before, line) = (before.control.clone(), sim.line.map(|line| line + 1));
        let Sim { control, position, trace, scans, files, .. } = sim;
        let (diagnostics, passed_over, called) = (Vec::new(), Vec::new(), Vec::new());
        let machine_values = Vec::new();
        Outcome {
            before,
            control,
            position,
            trace,
            scans,
            files,
            stop,
            diagnostics,
            passed_over,
            machine_values,
            line,
            called,
        }
    }
}

/// Name and value of a datum that a step writes.
pub(super) fn set(step: &Step) -> Option<(&str, f64)> {
    if let Step::Set { name, after, .. } = step { Some((name, *after)) } else { None }
}

/// Every corrected quantity by the name a program would use for it, lengths in mm; without what the other control has
/// the same, as far as that is seen without comparing one by one.
fn addressable(control: &Control, other: &Control) -> BTreeMap<String, f64> {
    let memory = |(name, value): (&String, &Value)| match value {
        Value::Number(value) if is_length(name) => Some((name.clone(), value * control.basic_factor())),
        Value::Number(value) if is_axes(name) => Some((name.clone(), *value)),
        _ => None,
    };
    let variables = control.variables_unlike(other);
    if control.basic_units == other.basic_units {
        variables.chain(control.data.unlike(&other.data).filter_map(memory)).collect()
    } else {
        variables.chain(control.data.iter().filter_map(memory)).collect()
    }
}

/// User data in which later measurements find what this one left: empirical and mean values, calibration of probes.
const MEMORIES: [&str; 6] = ["_EV[", "_MV[", "_WP[", "_TP[", "_TPW[", "_KB["];

/// Whether a datum has the axes of a tool probe: without them, where it is erased (B:13644), it cannot be measured with
/// (B:13364).
fn is_axes(name: &str) -> bool {
    ["_TP[", "_TPW["].iter().any(|stem| name.starts_with(stem)) && name.ends_with(",7]")
}

/// Whether a datum is one of the memories or a calibrated value of NCT, and a length: the calibration status tells
/// nothing.
pub fn is_length(name: &str) -> bool {
    let unit = match nct_data::find(name) {
        Some(datum) => Some(datum.element.unit),
        None if !MEMORIES.iter().any(|stem| name.starts_with(stem)) => None,
        None => gud::place(name).and_then(|(gud, at)| Some(gud.element(&at)?.unit)),
    };
    unit == Some(gud::Unit::Length(gud::System::Basic))
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

    // oracle: hand (whatever is written is told, and nothing else)
    #[test]
    fn each_variable_that_is_written_is_a_change() {
        for dialect in [Dialect::Sinumerik, Dialect::Nct] {
            let setup = Setup::calibrated(dialect, Plane::G17);
            for (name, value) in setup.control.variables() {
                let mut outcome = Outcome::new(&setup);
                assert!(outcome.changes().is_empty());
                assert!(outcome.control.set_variable(&name, value + 1.0));
                let after = outcome.control.variable(&name).unwrap_or_default();
                let change = Change { name, before: value, after };
                assert_eq!(outcome.changes(), if after == value { vec![] } else { vec![change] });
            }
        }
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
