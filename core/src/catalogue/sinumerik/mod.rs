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

/// Ends the cycle with an alarm, which also stays in `_OVI[9]` (B:5699).
pub fn alarm(machine: &mut dyn Machine, number: u32) -> Stop {
    results::set(machine, results::ALARM, f64::from(number));
    Stop::Alarm(Code::Alarm(number))
}
