//! What would it do? One call, without a program, from where the machine stands.

use super::{Outcome, call};
use crate::entry::{Cycle, Inputs};
use crate::machine::Setup;
use crate::machine::sim::Sim;

/// Entries of a trace after which a call of a form is given up: what it does is asked at every keystroke. The longest
/// scan that a form follows has a third of them.
const STEPS: usize = 5000;

/// Carries out one call on a copy of the setup. `inputs.cycle` is the cycle; naming it again keeps callers honest.
pub fn predict(cycle: &'static Cycle, inputs: &Inputs, setup: &Setup) -> Outcome {
    let mut outcome = Outcome::new(setup);
    let mut sim = Sim::new(setup);
    sim.trace_limit = STEPS;
    let inputs = Inputs { cycle, ..inputs.clone() };
    outcome.stop = call::perform(&mut sim, &inputs).err();
    outcome.control = sim.control;
    outcome.position = sim.position;
    outcome.trace = sim.trace;
    outcome.scans = sim.scans;
    outcome
}
