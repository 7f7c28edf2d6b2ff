//! One measuring call on the machine, with its begin, its end and the alarm that stops it.

use crate::catalogue::sinumerik::results;
use crate::check::upkeep;
use crate::diagnostic::Code;
use crate::entry::{Inputs, ProbeUse};
use crate::machine::Stop;
use crate::machine::sim::Sim;
use crate::machine::trace::Step;
use crate::message::Message;

/// Carries out a checked call; its begin, its end and the alarm that stops it are recorded.
pub fn perform(sim: &mut Sim, inputs: &Inputs) -> Result<(), Stop> {
    sim.recode(inputs.recodes());
    sim.note(Step::CallBegin { cycle: inputs.cycle.name, variant: inputs.variant });
    upkeep::perform(sim, inputs.cycle);
    let Some(work) = inputs.cycle.work() else {
        let message = Message::new("run-no-simulation").text("word", inputs.cycle.name);
        return Err(Stop::Fault(message));
    };
    let purpose = &inputs.cycle.purpose;
    sim.measuring = (purpose.probe == ProbeUse::Workpiece).then_some(purpose.machine);
    sim.in_cycle = true;
    let outcome = (work.simulate)(sim, inputs);
    sim.in_cycle = false;
    sim.measuring = None;
    sim.recode(false);
    let outcome = outcome.and_then(|()| numbers(sim));
    if let Err(Stop::Alarm(code)) = outcome {
        return alarm(sim, code);
    }
    if outcome.is_ok() {
        results::screen(sim, inputs.cycle);
        sim.note(Step::CallEnd);
    }
    outcome
}

/// Whether the call has left numbers only.
fn numbers(sim: &Sim) -> Result<(), Stop> {
    let steps = sim.trace.entries.iter().rev().map(|entry| &entry.step);
    let mut own = steps.take_while(|step| !matches!(step, Step::CallBegin { .. }));
    match own.any(|step| matches!(step, Step::Set { after, .. } if !after.is_finite())) {
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
