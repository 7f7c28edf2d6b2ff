//! CYCLE976: calibrate a workpiece probe in a hole or on a surface (B:5029-5593).

mod checks;
mod lists;
pub mod params;
mod picture;
mod results;
#[cfg(test)]
mod tests;
mod variants;

pub use results::RESULTS;
pub use variants::VARIANTS;

use crate::catalogue::common;
use crate::catalogue::{Cycle, Dialect, Drawing, Purpose, When};

/// The entry. Example: the ring of B:5168-5188.
pub static CYCLE976: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE976",
    key: "cycle976",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose {
        calibrates: When::Always,
        ..Purpose::MILLING
    },
    lists: lists::LISTS,
    // B:5471-5472, B:13656
    settings: &["_CBIT[14]", "_CBIT[15]"],
    results: RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        // A:15866-15867, A:15920
        &common::alarms([61325, 61326, 61401]),
    ],
    checks: checks::checks,
    picture: Drawing::new(picture::picture),
    example: &[
        ("_MVAR", "10101"),
        ("_SETVAL", "110.246"),
        ("_PRNUM", "3"),
        ("_FA", "1"),
        ("_TSA", "1"),
        ("_VMS", "0"),
        ("_NMSP", "1"),
        ("_TZL", "0"),
    ],
    simulation: None,
    source: "B:5029-5593",
};
