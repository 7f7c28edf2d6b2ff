//! One measuring call on the machine, with its begin, its end and the alarm that stops it; and what it would do.

use super::{Outcome, outcome::set};
use crate::catalogue::log;
use crate::check::upkeep;
use crate::diagnostic::Code;
use crate::entry::{Cycle, Inputs, ProbeUse};
use crate::machine::{Setup, Sim, Step, Stop};
use crate::message::Message;

/// A difference exceeds `_TSA`.
const SAFE_AREA: Code = Code::Alarm(61303);
/// Entries of a trace after which a call of a form is given up, asked at every keystroke; scans need a third of them.
const STEPS: usize = 5000;

/// What one call would do, without a program, from where the machine stands.
pub fn predict(cycle: &'static Cycle, inputs: &Inputs, setup: &Setup) -> Outcome {
    let mut sim = Sim::new(setup);
    sim.trace_limit = STEPS;
    let stop = perform(&mut sim, &Inputs { cycle, ..inputs.clone() }).err();
    Outcome::left_by(sim, setup, stop)
}

/// Carries out a checked call; its begin, its end and the alarm that stops it are recorded.
pub fn perform(sim: &mut Sim, inputs: &Inputs) -> Result<(), Stop> {
    sim.in_cycle = true;
    let outcome = within(sim, inputs);
    sim.in_cycle = false;
    outcome
}

fn within(sim: &mut Sim, inputs: &Inputs) -> Result<(), Stop> {
    sim.recode(inputs.recodes());
    sim.note(Step::CallBegin { cycle: inputs.cycle.name, variant: inputs.variant });
    upkeep::perform(sim, inputs.cycle);
    let Some(work) = inputs.cycle.work() else {
        return Err(Stop::Fault(Message::new("run-no-simulation").text("word", inputs.cycle.name)));
    };
    let purpose = &inputs.cycle.purpose;
    sim.measuring = (purpose.probe == ProbeUse::Workpiece).then_some(purpose.machine);
    let outcome = (work.simulate)(sim, inputs);
    sim.measuring = None;
    sim.recode(false);
    let outcome = logged(sim, inputs, outcome.and_then(|()| numbers(sim)));
    if let Err(Stop::Alarm(code)) = outcome {
        return alarm(sim, code);
    }
    if outcome.is_ok() {
        upkeep::screen(sim, inputs.cycle);
        sim.note(Step::CallEnd);
    }
    outcome
}

/// The call's block of values in the log, where that is on. What exceeds the safe area is logged before it stops the
/// program: else the mark that `_TSA` has there (B:11439) could never be seen.
fn logged(sim: &mut Sim, inputs: &Inputs, outcome: Result<(), Stop>) -> Result<(), Stop> {
    match outcome {
        Ok(()) | Err(Stop::Alarm(SAFE_AREA)) => log::measured(sim, inputs).and(outcome),
        _ => outcome,
    }
}

/// Whether the call has left numbers only.
fn numbers(sim: &Sim) -> Result<(), Stop> {
    let steps = sim.trace.entries.others().rev().map(|other| other.step);
    let mut own = steps.take_while(|step| !matches!(step, Step::CallBegin { .. })).filter_map(set);
    match own.any(|(_, after)| !after.is_finite()) {
        true => Err(Stop::Fault(Message::new("run-no-value"))),
        false => Ok(()),
    }
}

/// Stops with an alarm; it is recorded unless it was the last thing that was.
pub fn alarm(sim: &mut Sim, code: Code) -> Result<(), Stop> {
    if sim.trace.entries.last().is_none_or(|entry| entry.step != Step::Alarm(code)) {
        sim.note(Step::Alarm(code));
    }
    Err(Stop::Alarm(code))
}
