//! What the cycles with the workpiece probe of a turning machine share (CYCLE973, CYCLE974, CYCLE994).

pub mod checks;
pub mod figures;
pub mod params;
#[cfg(test)]
pub mod testing;

use super::common::alarms;
use crate::diagnostic::Code;

/// Alarms beside those of every cycle (A:15856, A:15866, A:15873).
pub const ALARMS: &[Code] = &alarms([61315, 61325, 61330]);
