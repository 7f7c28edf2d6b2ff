//! What CYCLE982 does, and CYCLE972 with its two variants (B:8736-9090, B:9124-10126).

use super::params::{
    AUTOMATIC, BOTH, CALIBRATE, DRILL, DRILL_ALONG_APPLICATE, IN_WORKPIECE, INCREMENTAL, MILLING, REVERSAL,
    SPINDLE_AS_IT_IS, TURNING, UPPER, WITH_RADIUS, WORKPIECE,
};
use super::stand::Stand;
use super::{cutter, drill, nose};
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::catalogue::sinumerik::{Next, alarm, results};
use crate::catalogue::tool_probe::correct::Measured;
use crate::catalogue::tool_probe::{correct, store};
use crate::entry::{Inputs, names};
use crate::machine::{Machine, Stop};

/// Runs the cycle from the present position, beside the probe.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    run(machine, inputs, 982)
}

/// The same under the number of a cycle.
pub fn run(machine: &mut dyn Machine, inputs: &Inputs, number: i64) -> Result<(), Stop> {
    store::begin(machine, inputs, number);
    results::integer(machine, 12, 0);
    let block = Block::for_tool(machine, inputs)?;
    admitted(machine, inputs)?;
    if IN_WORKPIECE.holds(inputs) {
        return task(machine, inputs, &block);
    }
    // what stands in `_TP` are machine coordinates
    let frames = machine.control().take_frames();
    let outcome = task(machine, inputs, &block);
    machine.control().put_frames(frames);
    outcome
}

fn task(machine: &mut dyn Machine, inputs: &Inputs, block: &Block) -> Result<(), Stop> {
    let incremental = INCREMENTAL.holds(inputs);
    for repetition in 0.. {
        let stand = Stand::of(machine, inputs, block.clone());
        let next = if CALIBRATE.holds(inputs) {
            let found = [nose::calibrate(machine, inputs, &stand)?];
            if incremental {
                store::store_always(machine, &found);
                return Ok(());
            }
            store::store(machine, inputs, &found, &[], repetition)?
        } else {
            let found = measured(machine, inputs, &stand)?;
            if incremental {
                correct::finish_always(machine, inputs, &found);
                return Ok(());
            }
            correct::finish(machine, inputs, &found, repetition)?
        };
        if next == Next::Done {
            break;
        }
    }
    Ok(())
}

/// What the tool in use shows.
fn measured(machine: &mut dyn Machine, inputs: &Inputs, stand: &Stand) -> Result<Vec<Measured>, Stop> {
    if TURNING.holds(inputs) {
        nose::measure(machine, inputs, stand)
    } else if DRILL_ALONG_APPLICATE.holds(inputs) {
        drill::measure(machine, inputs, &stand.block)
    } else {
        cutter::measure(machine, inputs, stand)
    }
}

/// What is refused before the first motion: the number of the probe (61313), a turned system (61330), a tool that the
/// task does not know (61314), and what `_CHBIT[20]` does not allow (61307, B:10088-10094).
fn admitted(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let fields = match WORKPIECE.holds(inputs) {
        true => "_CVAL[3]",
        false => "_CVAL[0]",
    };
    let probe = inputs.number(names::PRNUM);
    if probe < 1.0 || probe > machine.control().number(fields) {
        return Err(alarm(machine, 61313));
    }
    // lengths lie along the axes of the machine, so that a turned system would take them for others
    if IN_WORKPIECE.holds(inputs) && machine.control().rotated() {
        return Err(alarm(machine, 61330));
    }
    if CALIBRATE.holds(inputs) || TURNING.holds(inputs) {
        return nose::nose(machine, inputs).map(|_| ());
    }
    let cutter = MILLING.holds(inputs) || DRILL.holds(inputs);
    let radius = DRILL.holds(inputs) && WITH_RADIUS.holds(inputs);
    if !cutter || radius {
        return Err(alarm(machine, 61314));
    }
    let turns = [AUTOMATIC, REVERSAL, BOTH, UPPER];
    if SPINDLE_AS_IT_IS.holds(inputs) && MILLING.holds(inputs) && turns.iter().any(|when| when.holds(inputs)) {
        return Err(alarm(machine, 61307));
    }
    Ok(())
}
