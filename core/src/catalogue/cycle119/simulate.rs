//! What CYCLE119 computes, corrects and hands back (B:8541-8592). It stops no program.

use super::checks::points;
use super::params::{LIMIT, MEASURED, SET, TARGET};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::correct;
use crate::control::variables::AXES;
use crate::evaluate::position::{NO_FRAME, Position, correctable, position};
use crate::evaluate::zero_offset;
use crate::evaluate::zero_offset::Target;
use crate::geometry::rigid::angles;

/// What is in `_RES` where no frame was computed (B:8582: below 0).
const NONE: f64 = -1.0;

/// Computes the frame between both triangles; where one is to be corrected and all is well, corrects it. The corrected
/// frame becomes active when the program calls it again, 9999 included (B:8592).
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let points = points(inputs, SET).zip(points(inputs, MEASURED));
    let found = points.ok_or(NO_FRAME).and_then(|(set, measured)| position(&set, &measured));
    // as its limit counts, whatever the program's units (B:8573, B:8583)
    let factor = machine.control().basic_factor();
    results::set(machine, "_RES", found.as_ref().map_or(NONE, |position| position.distortion / factor));
    if let Ok(position) = &found {
        frame(machine, position);
    }
    let outcome = found.and_then(|position| corrected(machine, inputs, &position));
    results::hand_back(machine, "_ALARM", outcome.err());
    Ok(())
}

/// Corrects the frame that `_COR` names, if the distortion is below its limit (B:8566-8576).
fn corrected(machine: &mut dyn Machine, inputs: &Inputs, position: &Position) -> Result<(), u32> {
    let control = machine.control();
    let Some(target) = zero_offset::target(control, inputs.integer(TARGET))? else { return Ok(()) };
    correctable(control, &target)?;
    position.within(inputs.number(LIMIT))?;
    let target = Target { activate: false, ..target };
    let set = SET[0].map(|name| inputs.number(name));
    let writes = zero_offset::moved(control, &target, &position.motion, set);
    correct::write(machine, &writes);
    Ok(())
}

/// The difference frame: chained to the active one, the measured points have the set coordinates (B:8584).
fn frame(machine: &mut dyn Machine, position: &Position) {
    let turn = angles(&position.motion.rotation);
    for (axis, letter) in AXES.into_iter().enumerate() {
        results::named_length(machine, &format!("_REFRAME[{letter},TR]"), position.motion.translation.vector[axis]);
        results::set(machine, &format!("_REFRAME[{letter},RT]"), turn[axis]);
    }
}
