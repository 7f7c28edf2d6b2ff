//! What the cycles with the workpiece probe of a turning machine share (CYCLE973, CYCLE974, CYCLE994).

pub mod checks;
pub mod figures;
pub mod help;
pub mod measure;
pub mod params;
pub mod place;
#[cfg(test)]
pub mod testing;

use crate::catalogue::prelude::*;
use std::ops::RangeInclusive;

/// Alarms beside those of every cycle (A:15856, A:15866, A:15873).
pub const ALARMS: &[Code] = &alarms([61315, 61325, 61330]);
/// Cutting edge positions of a probe (B:8708).
pub const TIPS: RangeInclusive<i64> = 5..=8;
