//! What the measuring calls of a program left in their result data.

use super::called::Called;
use super::{Outcome, outcome::set};
use crate::catalogue;
use crate::control::Units;
use crate::entry::{Cycle, Inputs, ResultField};
use crate::machine::Step;
use crate::machine::entries::Other;
use std::collections::{BTreeMap, BTreeSet};

/// What one call left.
#[derive(Clone)]
pub struct Left {
    /// The call.
    pub call: CallAt,
    /// Active system of units at the call; of one that is no measurement, at the end of the program.
    pub units: Units,
    /// Results of the cycle with their values, in the order of the entry.
    pub results: Vec<(&'static ResultField, f64)>,
}

/// A call of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CallAt {
    /// Line of the call, from 0.
    pub line: u32,
    /// Name of what was called.
    pub cycle: &'static str,
}

impl Outcome {
    /// Each step that is no motion with the call of the program in which it happened; what a cycle calls belongs to the
    /// cycle.
    pub fn by_call(&self) -> impl Iterator<Item = (Option<CallAt>, &Step)> {
        let mut open: Vec<Option<CallAt>> = Vec::new();
        self.trace.entries.others().map(move |Other { line, step, .. }| {
            if let Step::CallBegin { cycle, .. } = step {
                open.push(line.map(|line| CallAt { line, cycle }));
            }
            let within = open.first().copied().flatten();
            if *step == Step::CallEnd {
                open.pop();
            }
            (within, step)
        })
    }

    /// The call in which each alarm was raised, in their order; behind them forever that in which the run ended.
    pub fn calls_of_alarms(&self) -> impl Iterator<Item = Option<CallAt>> {
        let calls = self.by_call().filter_map(|(call, step)| matches!(step, Step::Alarm(_)).then_some(call));
        calls.chain(std::iter::repeat(self.by_call().last().and_then(|(call, _)| call)))
    }

    /// Names of the results of a cycle that nothing wrote: they stand there from before.
    pub fn unwritten(&self, cycle: &'static Cycle) -> BTreeSet<&'static str> {
        let written = self.written();
        cycle.results.iter().map(|field| field.name).filter(|name| !written.contains_key(name)).collect()
    }

    /// What the calls left, in the order of their lines; of a call that was carried out several times, the last.
    pub fn left(&self) -> Vec<Left> {
        let mut others = self.trace.entries.others();
        let begins = std::iter::from_fn(|| others.next().map(|other| (other, others.clone())));
        let begins = begins.filter_map(|(other, behind)| {
            let Step::CallBegin { cycle, variant } = *other.step else { return None };
            let cycle = catalogue::find(self.control.dialect, cycle)?;
            let call = CallAt { line: other.line?, cycle: cycle.name };
            let units = self.called_at(other.at).map_or(self.control.active_units, |called| called.units);
            Some((call.line, one(call, units, &Inputs::new(cycle, variant), behind)))
        });
        begins.collect::<BTreeMap<_, _>>().into_values().collect()
    }

    /// The measuring call that begins with this entry of the trace.
    fn called_at(&self, at: usize) -> Option<&Called> {
        self.called.binary_search_by_key(&at, |called| called.at).ok().and_then(|index| self.called.get(index))
    }
}

/// What a call, of which only the variant is known, wrote before the next one began.
fn one<'a>(call: CallAt, units: Units, called: &Inputs, behind: impl Iterator<Item = Other<'a>>) -> Left {
    let own = behind.map(|other| other.step);
    let own = own.take_while(|step| !matches!(step, Step::CallBegin { .. } | Step::CallEnd));
    let written: BTreeMap<&str, f64> = own.filter_map(set).collect();
    let fields = called.cycle.results.iter().filter(|field| field.when.holds(called));
    let results = fields.filter_map(|field| Some((field, *written.get(field.name)?))).collect();
    Left { call, units, results }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

    use super::Step;
    use crate::control::Plane;
    use crate::dialect::Dialect;
    use crate::machine::Setup;
    use crate::run::{Limits, run};
    use crate::syntax::read;

    // oracle: hand
    #[test]
    fn a_step_belongs_to_the_call_in_which_it_happened() {
        let text = "_SETV[0]=SET(3,0,0,1,0,2,0)\nMSG(\"A\")\nDEF REAL P[13]\nDEF INT FAULT\nCYCLE116(P,FAULT)\n\
            MSG(\"B\")\nM30\n";
        let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let outcome = run(&program, &setup, Limits::default());
        let of = |wanted: fn(&Step) -> bool| {
            let found: Vec<_> = outcome.by_call().filter(|(_, step)| wanted(step)).collect();
            let calls = found.iter().map(|(call, _)| call.map(|call| call.line));
            calls.collect::<Vec<_>>()
        };
        assert_eq!(of(|step| matches!(step, Step::Message { .. })), [None, None]);
        let inside = of(|step| matches!(step, Step::CallBegin { .. } | Step::CallEnd));
        assert_eq!(inside, [Some(4), Some(4)]);
    }

    #[test]
    fn what_each_call_left_last_is_told_with_its_meaning() {
        // oracle: hand (circles of radius 1 to 3 by the same call, then a 4th point that makes no circle with the
        // others)
        let text = "DEF INT FAULT\nDEF REAL P[13]\nFOR R1=1 TO 3\nP[0]=SET(3,R1,0,0,R1,-R1,0)\nCYCLE116(P,FAULT)\n\
            ENDFOR\n\
            P[0]=SET(3,0,0,1,0,2,0)\nCYCLE116(P,FAULT)\nM30\n";
        let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let outcome = run(&program, &setup, Limits::default());
        assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
        let left = outcome.left();
        let value = |call: usize, name: &str| {
            let found = left[call].results.iter().find(|(field, _)| field.name == name);
            found.map(|(field, value)| (field.key, *value))
        };
        assert_eq!([left[0].call.line, left[1].call.line], [4, 7]);
        let (key, radius) = value(0, "_DATE[11]").unwrap();
        assert!(key == "result-116-radius" && (radius - 3.0).abs() < 1e-9);
        assert_eq!(value(1, "_DATE[11]"), None);
        assert_eq!(value(1, "_ALM"), Some(("result-116-alarm", 61316.0)));
    }
}
