//! The log of measurements (chapter 7.1: B:11172-11638): what CYCLE100, CYCLE105 and CYCLE106 share. They take what is
//! printed and how from user data that a program writes before the call.

pub mod cells;
mod checks;
pub mod help;
mod line;
pub mod names;
pub mod params;
mod picture;
#[cfg(test)]
mod tests;

use checks::checks;
pub use picture::closed;
use picture::picture;

use super::common::{CYCLE, alarms};
use crate::control::MachineSort;
use crate::diagnostic::Code;
use crate::entry::*;

/// All cycles of the log.
const PURPOSE: Purpose = Purpose { probe: ProbeUse::Log, machine: MachineSort::Any, calibrates: NEVER, tasks: &[] };

/// What they start from.
pub const LOG: Cycle = Cycle { purpose: PURPOSE, ..CYCLE };
/// The same of those that print.
pub const PRINTS: Cycle = Cycle { settings: SETTINGS, checks, picture: Drawing::new(picture), ..LOG };

/// The call with arguments in brackets.
pub const fn call(name: &'static str, args: &'static [Arg], source: &'static str) -> ArgumentList {
    ArgumentList { style: Style::Direct, name, when: When::Always, base: 0, args, source }
}

/// Data of the machine that decide over the log: name and variant left out (B:11336), header of the user (B:11338).
const SETTINGS: &[&str] = &["_CBIT[6]", OWN_HEADER];

/// 1: the header is that of the user (B:11338).
pub const OWN_HEADER: &str = "_CBIT[11]";

/// What CYCLE105 raises about contents and format (A:15903-15948).
pub const CONTENT_ALARMS: &[Code] = &alarms([61361, 61363, 61370, 61371, 62307, 62308, 62309, 62310, 62311]);
/// What CYCLE106 raises about the file and about its job (A:15894-15902).
pub const FILE_ALARMS: &[Code] = &alarms([61352, 61353, 61354, 61355, 61356, 61357, 61358, 61359, 61360]);

/// A log of one line of values below a header, as in the sample of the manual (B:11513-11600), behind values of the
/// cycle's own.
macro_rules! log_example {
    ($($own:expr),*) => {
        &[
            $($own,)*
            (names::PROGRAM, "MEASPROGRAM_1"),
            (names::HEADLINES[0], "Part number: 123456789"),
            (names::HEADLINES[1], "Job number: 6878"),
            (names::HEADLINES[2], "Supervisor: Müller Phone: 1234"),
            (names::SEPARATOR, ","),
            (names::MARK, "*"),
            (names::HEAD_LINES, "3"),
            (names::VALUE_LINES, "1"),
            (names::COLUMN, "12"),
            (names::TITLES[0], "Meas.,Axis,Set,Act. value,Difference,Time"),
            (names::TITLES[1], "point,,value"),
            (names::VALUES[0], "_TXT[0],_AXIS,_OVR[0],_OVR[4],_OVR[16],_TIME"),
        ]
    };
}
pub(in crate::catalogue) use log_example;
