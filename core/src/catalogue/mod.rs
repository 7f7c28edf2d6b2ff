//! What can be measured. A folder a cycle, or a file where it is small: its entry (plain data) beside its simulation.
//! A new cycle is that and one line here, in the group behind which it is offered. CONTRIBUTING.md has the steps.
//! Which there are for milling and turning is listed at B:4089, B:4102, B:8650, B:8656 and B:8667.

// Cycles, in the order in which they are offered: `ALL` is made of these lines.
pub mod cycle961;
pub mod cycle971;
pub mod cycle972;
pub mod cycle973;
pub mod cycle974;
pub mod cycle976;
pub mod cycle977;
pub mod cycle978;
pub mod cycle979;
pub mod cycle982;
pub mod cycle994;
pub mod cycle997;
pub mod cycle998;

pub mod cycle116;
pub mod cycle119;

pub mod cycle100;
pub mod cycle101;
pub mod cycle105;
pub mod cycle106;
pub mod cycle113;
pub mod cycle118;

pub mod g101;
pub mod g102;
pub mod g103;
pub mod g104;
pub mod g105;
pub mod g106;
pub mod g107;
pub mod g108;
pub mod g109;
pub mod g110;
pub mod p9920;
pub mod p9969;

// What they share.
pub mod alarms;
pub(crate) mod calibration;
pub(crate) mod circle;
pub(crate) mod common;
pub mod example;
pub mod functions;
pub mod help;
pub mod in_jog;
pub(crate) mod lathe;
pub(crate) mod list;
pub(crate) mod logging;
pub(crate) mod mean_value;
pub mod nct;
pub(crate) mod newer;
pub(crate) mod older;
pub mod operator_messages;
pub(crate) mod place;
pub(crate) mod prelude;
pub mod r_parameters;
pub(crate) mod shared_checks;
pub(crate) mod shown_with;
pub(crate) mod sinumerik;
pub mod softkeys;
pub(crate) mod spread;
pub mod subroutines;
mod suit;
pub(crate) mod tool_probe;
pub mod twin;
pub mod twin_place;

/// What a run has to know of the log: every measuring cycle writes into it at its end, while it is on.
pub(crate) mod log {
    pub use super::logging::names::FILE;
    pub use super::logging::simulate::measured;
    pub use super::logging::{LOG_DELETED, LOG_FULL, Layout, ON, Unmarked, is_log, layout};
}

use crate::dialect::Dialect;
use crate::entry::Cycle;
pub use functions::{Functions, by_program};
pub use newer::arguments::Argument;

/// Every cycle that Probewright knows, in the order in which they are offered, as the build script finds them.
pub static CYCLES: &[&Cycle] = ALL;

const ALL: &[&Cycle] = include!(concat!(env!("OUT_DIR"), "/cycles.rs"));

const _: () = {
    let mut index = 0;
    while index < ALL.len() {
        ALL[index].names_its_own();
        index += 1;
    }
};

/// Names of the calls that switch the log on and off.
pub fn log_switches() -> [&'static str; 2] {
    [cycle100::CYCLE100.name, cycle101::CYCLE101.name]
}

/// The entry with this name on this control (`CYCLE977`, `G110`; case does not matter).
pub fn find(dialect: Dialect, name: &str) -> Option<&'static Cycle> {
    CYCLES.iter().copied().find(|cycle| cycle.dialect == dialect && cycle.name.eq_ignore_ascii_case(name))
}

#[cfg(all(test, feature = "cli"))]
mod help_tests;
#[cfg(test)]
mod picture_tests;
#[cfg(test)]
mod table_tests;
#[cfg(test)]
mod twin_tests;
#[cfg(test)]
mod word_tests;

#[cfg(test)]
mod proposal_tests;
#[cfg(test)]
mod result_tests;
