//! What the SINUMERIK workpiece cycles have in common: the measuring block, results, tolerances, corrections.

pub mod calibrated_as;
pub mod calibration;
pub mod centred;
pub mod correct;
pub mod differential;
pub mod help;
pub mod measuring_block;
#[cfg(test)]
pub mod motion_testing;
pub mod one_point;
pub mod results;
pub mod state;
pub mod target;
#[cfg(test)]
pub mod testing;
pub mod tolerance;

use crate::catalogue::prelude::*;
use std::ops::RangeInclusive;

/// A correction done, or the measurement to be repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// The cycle is over.
    Done,
    /// Measure again (`_CBIT[0]`, B:13572-13574).
    Again,
}

/// Measures until nothing has to be measured again; `measure` is told how often it was repeated.
pub fn until_done(mut measure: impl FnMut(u32) -> Result<Next, Stop>) -> Result<(), Stop> {
    let mut repetition = 0;
    while measure(repetition)? == Next::Again {
        repetition += 1;
    }
    Ok(())
}

/// Measures as [`until_done`] does, in the workpiece system or, as what the data say are machine coordinates, without
/// frames.
pub fn carry_out(
    machine: &mut dyn Machine,
    workpiece: bool,
    measure: impl Fn(&mut dyn Machine, u32) -> Result<Next, Stop>,
) -> Result<(), Stop> {
    let frames = (!workpiece).then(|| machine.control().take_frames());
    let outcome = until_done(|repetition| measure(machine, repetition));
    if let Some(frames) = frames {
        machine.control().put_frames(frames);
    }
    outcome
}

/// The measuring axis, one of these numbers of `_MA`: 0 abscissa, 1 ordinate, 2 applicate; 61325 for another (A:15866).
pub fn axis(machine: &mut dyn Machine, inputs: &Inputs, numbers: RangeInclusive<i64>) -> Result<usize, Stop> {
    let number = inputs.integer(names::MA);
    if numbers.contains(&number) { Ok(number as usize - 1) } else { Err(alarm(machine, 61325)) }
}

/// Direction of `_MD`, +1 or -1; 61326 where it is none (A:15867).
pub fn direction(machine: &mut dyn Machine, inputs: &Inputs) -> Result<f64, Stop> {
    match inputs.integer(names::MD) {
        0 => Ok(1.0),
        1 => Ok(-1.0),
        _ => Err(alarm(machine, 61326)),
    }
}

/// Ends the cycle with an alarm, which also stays in `_OVI[9]` (B:5699).
pub fn alarm(machine: &mut dyn Machine, number: u32) -> Stop {
    results::set(machine, results::ALARM, f64::from(number));
    Stop::Alarm(Code::Alarm(number))
}
