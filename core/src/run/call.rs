//! One measuring call on the machine: the state that every cycle asks for, then the cycle itself.

use super::Stop;
use super::machine::Sim;
use super::trace::Step;
use crate::catalogue::Dialect;
use crate::check::Inputs;
use crate::control::Control;
use crate::diagnostic::Code;
use crate::message::Message;

/// The alarm with which a cycle refuses a control in this state: without a D number 61311, with a tool that is no
/// workpiece probe 61309 (B:4147-4152). NCT macros look at the state of the control themselves.
pub fn refusal(control: &Control) -> Option<Code> {
    if control.dialect != Dialect::Sinumerik {
        return None;
    }
    match control.active_edge() {
        None => Some(Code::Alarm(61311)),
        Some(edge) if !edge.is_milling_probe() => Some(Code::Alarm(61309)),
        Some(_) => None,
    }
}

/// Carries out a checked call; its begin, its end and the alarm that stops it are recorded.
pub fn perform(sim: &mut Sim, inputs: &Inputs) -> Result<(), Stop> {
    sim.note(Step::CallBegin {
        cycle: inputs.cycle.name,
        variant: inputs.variant,
    });
    if let Some(code) = refusal(&sim.control) {
        return alarm(sim, code);
    }
    let Some(simulation) = &inputs.cycle.simulation else {
        let message = Message::new("run-no-simulation").text("word", inputs.cycle.name);
        return Err(Stop::Fault(message));
    };
    sim.measuring = true;
    let outcome = (simulation.simulate)(sim, inputs);
    sim.measuring = false;
    if let Err(Stop::Alarm(code)) = outcome {
        return alarm(sim, code);
    }
    if outcome.is_ok() {
        sim.note(Step::CallEnd);
    }
    outcome
}

/// Stops with an alarm; it is recorded unless it was the last thing that was.
pub fn alarm(sim: &mut Sim, code: Code) -> Result<(), Stop> {
    if sim
        .trace
        .entries
        .last()
        .is_none_or(|entry| entry.step != Step::Alarm(code))
    {
        sim.note(Step::Alarm(code));
    }
    Err(Stop::Alarm(code))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::Plane;
    use crate::run::Setup;

    #[test]
    fn a_cycle_wants_a_probe() {
        let mut control = Setup::calibrated(Dialect::Sinumerik, Plane::G17).control;
        // oracle: manual B:4147-4152
        assert_eq!(refusal(&control), None);
        control.set_variable("$TC_DP1[9,1]", 500.0);
        assert_eq!(refusal(&control), Some(Code::Alarm(61309)));
        control.edge = 0;
        assert_eq!(refusal(&control), Some(Code::Alarm(61311)));
    }
}
