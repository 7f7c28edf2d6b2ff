//! A program that never ends, where that can be proved: at a jump back everything that decides over what comes next is
//! as it was at an earlier one, so that the same comes again and again.
//!
//! One state is kept, and after twice as many jumps back the present one instead of it (Brent): so states of any period
//! are found, for one comparison a jump.

use super::{Interpreter, Level, Locals, Modal, of_machine};
use crate::geometry::{Mcs, Wcs};
use crate::machine::sim::state::State;
use std::collections::BTreeMap;

/// What was kept of a run, and when something is kept again.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    kept: Option<Box<Kept>>,
    jumps: usize,
    next: usize,
}

/// Everything that decides over what comes next, but the clock.
#[derive(Clone, Debug)]
struct Kept {
    at: usize,
    modal: Modal,
    levels: Vec<Level>,
    shared: Locals,
    measured: BTreeMap<String, f64>,
    programmed: (Mcs, Wcs),
    tangent: Option<[f64; 3]>,
    machine: State,
}

/// Whether a run that has just jumped back stands where it stood before, in every respect. Nothing is said of a program
/// that looks at the clock, nor while the tool follows a contour whose next block is not known.
pub fn again(run: &mut Interpreter) -> bool {
    if run.clock_asked.get() || run.contour.is_some() {
        return false;
    }
    if run.endless.kept.as_ref().is_some_and(|kept| is(run, kept)) {
        return true;
    }
    run.endless.jumps += 1;
    if run.endless.jumps > run.endless.next {
        run.endless.next = 2 * run.endless.jumps;
        run.endless.kept = Some(Box::new(keep(run)));
        of_machine::watch(run);
    }
    false
}

/// Begins anew: something decides otherwise from here.
pub fn forget(run: &mut Interpreter) {
    run.endless = Watch::default();
}

/// What differs most often is compared first.
fn is(run: &Interpreter, kept: &Kept) -> bool {
    run.at == kept.at
        && run.levels == kept.levels
        && run.shared == kept.shared
        && run.sim.is(&kept.machine)
        && run.modal == kept.modal
        && run.measured == kept.measured
        && run.programmed == kept.programmed
        && run.tangent == kept.tangent
}

fn keep(run: &Interpreter) -> Kept {
    Kept {
        at: run.at,
        modal: run.modal,
        levels: run.levels.clone(),
        shared: run.shared.clone(),
        measured: run.measured.clone(),
        programmed: run.programmed,
        tangent: run.tangent,
        machine: run.sim.state(),
    }
}
