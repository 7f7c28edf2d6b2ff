//! What CYCLE982 does, and CYCLE972 with its two variants (B:8736-9090, B:9124-10126).

use super::cutters::SPINDLE_HAS_TO_STAY;
use super::params::{
    CALIBRATE, DRILL, DRILL_ALONG_APPLICATE, IN_WORKPIECE, INCREMENTAL, MILLING, TURNING, WITH_RADIUS,
};
use super::{cutter, drill, nose};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{Stand, correct, count, store};

/// Runs CYCLE982 from the present position, beside the probe.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    carried_out(machine, inputs, false)
}

/// Runs CYCLE972, which measures turning tools only (B:8954-8968), and in no turned system (A:15873).
pub fn turning_tools(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    carried_out(machine, inputs, true)
}

fn carried_out(machine: &mut dyn Machine, inputs: &Inputs, only_turning: bool) -> Result<(), Stop> {
    store::begin(machine, inputs);
    results::integer(machine, 12, 0);
    let block = Block::for_tool(machine, inputs)?;
    admitted(machine, inputs, only_turning)?;
    carry_out(machine, IN_WORKPIECE.holds(inputs), |machine, repetition| {
        let stand = Stand::of(machine, inputs, &block);
        task(machine, &stand, repetition)
    })
}

fn task(machine: &mut dyn Machine, stand: &Stand, repetition: u32) -> Result<Next, Stop> {
    let inputs = stand.inputs;
    if CALIBRATE.holds(inputs) {
        let found = nose::calibrate(machine, stand)?;
        return match INCREMENTAL.holds(inputs) {
            true => Ok(store::store_always(machine, &found)),
            false => store::store(machine, inputs, &[found], &[], repetition),
        };
    }
    let found = if TURNING.holds(inputs) {
        nose::measure(machine, stand)?
    } else if DRILL_ALONG_APPLICATE.holds(inputs) {
        drill::measure(machine, stand)?
    } else {
        cutter::measure(machine, stand)?
    };
    match INCREMENTAL.holds(inputs) {
        true => Ok(correct::finish_always(machine, inputs, &found)),
        false => correct::finish(machine, inputs, &found, repetition),
    }
}

/// What is refused before the first motion: the number of the probe (61313), a turned system (61330), a tool that the
/// task does not know (61314), and what `_CHBIT[20]` does not allow (61307, B:10088-10094).
fn admitted(machine: &mut dyn Machine, inputs: &Inputs, only_turning: bool) -> Result<(), Stop> {
    let probe = inputs.number(names::PRNUM);
    if probe < 1.0 || probe > machine.control().fields(count(inputs)) {
        return Err(alarm(machine, 61313));
    }
    // lengths lie along the axes of the machine, so that a turned system would take them for others
    if (only_turning || IN_WORKPIECE.holds(inputs)) && machine.control().rotated() {
        return Err(alarm(machine, 61330));
    }
    if only_turning || CALIBRATE.holds(inputs) || TURNING.holds(inputs) {
        return nose::nose(machine, inputs).map(|_| ());
    }
    let cutter = MILLING.holds(inputs) || DRILL.holds(inputs) && !WITH_RADIUS.holds(inputs);
    if !cutter {
        return Err(alarm(machine, 61314));
    }
    if SPINDLE_HAS_TO_STAY.holds(inputs) {
        return Err(alarm(machine, 61307));
    }
    Ok(())
}
