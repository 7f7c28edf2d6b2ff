//! The log of measurements (chapter 7.1: B:11172-11638): what CYCLE100, CYCLE105 and CYCLE106 share (B:11178). They
//! take what is printed and how from user data that a program writes before the call.

pub mod cells;
mod checks;
mod columns;
mod contents;
pub mod help;
mod keep;
pub mod line;
mod marks;
pub mod names;
pub mod params;
mod picture;
pub mod simulate;
mod state;
#[cfg(test)]
mod tests;

use crate::catalogue::prelude::*;
use checks::checks;
pub use contents::{Layout, Unmarked, is_log, layout};
pub use keep::{LOG_DELETED, LOG_FULL};
pub use picture::closed;
use picture::picture;
pub use state::ON;

use super::common::CYCLE;

/// All cycles of the log.
const PURPOSE: Purpose = Purpose { probe: ProbeUse::Log, machine: MachineSort::Any, ..Purpose::MILLING };

/// What they start from.
pub const LOG: Cycle = Cycle { purpose: PURPOSE, ..CYCLE };
/// What the cycles start from that print.
pub const PRINTS: Cycle = Cycle { settings: SETTINGS, checks, picture: Drawing::new(picture), ..LOG };

/// Data of the machine that decide over the log: name and variant left out (B:11336), header of the user (B:11338).
const SETTINGS: &[&str] = &[NAMELESS, OWN_HEADER, SIZE];

/// Size of a file, KB (B:13064).
const SIZE: &str = "MD11420";

/// 1: a block of values does not name cycle and variant (B:11336).
const NAMELESS: &str = "_CBIT[6]";

/// 1: the header is that of the user (B:11338).
pub const OWN_HEADER: &str = "_CBIT[11]";

/// What CYCLE105 raises about contents and format (A:15903-15948).
pub const CONTENT_ALARMS: &[Code] = &alarms([61361, 61363, 61370, 61371, 62307, 62308, 62309, 62310, 62311]);
/// What CYCLE106 raises about the file and about its job (A:15894-15902).
pub const FILE_ALARMS: &[Code] = &alarms([61352, 61353, 61354, 61355, 61356, 61357, 61358, 61359, 61360]);

/// Ends the call with an alarm. It is none of a measuring cycle, whose number `_OVI[9]` would have.
const fn refused(number: u32) -> Stop {
    Stop::Alarm(Code::Alarm(number))
}
