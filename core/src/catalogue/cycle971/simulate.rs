//! What CYCLE971 does: calibrates the tool probe, or measures the tool in use (B:4157-5029).

use super::params::{AUTOMATIC, CALIBRATE, INCREMENTAL, WORKPIECE};
use super::{calibrate, measure};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::{Stand, correct, store};
use crate::control::probe::PROBE;

/// Runs the cycle from the present position, from which the probe can be reached.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    store::begin(machine, inputs);
    let block = Block::for_tool(machine, inputs)?;
    if matches!(machine.control().active_edge().map_or(0, |edge| edge.kind), 400..=599 | PROBE) {
        return Err(alarm(machine, 61314)); // B:4157-4175, A:15855
    }
    carry_out(machine, WORKPIECE.holds(inputs), |machine, repetition| {
        let stand = Stand::of(machine, inputs, &block);
        if CALIBRATE.holds(inputs) {
            return calibrated(machine, &stand, repetition);
        }
        let found = measure::measure(machine, &stand)?;
        correct::finish(machine, inputs, &[found], repetition)
    })
}

fn calibrated(machine: &mut dyn Machine, stand: &Stand, repetition: u32) -> Result<Next, Stop> {
    if INCREMENTAL.holds(stand.inputs) {
        let found = calibrate::incremental(machine, stand)?;
        return Ok(store::store_always(machine, &found));
    }
    let found = match AUTOMATIC.holds(stand.inputs) {
        true => calibrate::automatic(machine, stand)?,
        false => calibrate::one(machine, stand)?,
    };
    store::store(machine, stand.inputs, &found.triggers, &found.beside, repetition)
}
