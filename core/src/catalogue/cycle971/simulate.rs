//! What CYCLE971 does: calibrates the tool probe, or measures the tool in use (B:4157-5029).

use super::params::{AUTOMATIC, CALIBRATE, INCREMENTAL, WORKPIECE};
use super::place::Task;
use super::{calibrate, measure};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::Next;
use crate::catalogue::tool_probe::{carry_out, correct, store};

/// Runs the cycle from the present position, from which the probe can be reached.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    store::begin(machine, inputs, 971);
    let task = Task::prepare(machine, inputs)?;
    carry_out(machine, WORKPIECE.holds(inputs), |machine, repetition| {
        if CALIBRATE.holds(inputs) {
            return calibrated(machine, &task, repetition);
        }
        let found = measure::measure(machine, &task)?;
        correct::finish(machine, inputs, &[found], repetition)
    })
}

fn calibrated(machine: &mut dyn Machine, task: &Task, repetition: u32) -> Result<Next, Stop> {
    if INCREMENTAL.holds(task.inputs) {
        let found = calibrate::incremental(machine, task)?;
        store::store_always(machine, &[found]);
        return Ok(Next::Done);
    }
    let found = match AUTOMATIC.holds(task.inputs) {
        true => calibrate::automatic(machine, task)?,
        false => calibrate::one(machine, task)?,
    };
    store::store(machine, task.inputs, &found.triggers, &found.beside, repetition)
}
