//! CYCLE976: calibrate a workpiece probe in a hole or on a surface (B:5029-5593).

mod checks;
mod directions;
mod help;
mod hole;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
mod tasks;
#[cfg(test)]
mod tests;
mod variants;

pub use variants::VARIANTS;

use crate::catalogue::sinumerik::help::{PROBE, STORED};
use crate::catalogue::{common, newer, older};
use crate::entry::{Cycle, Drawing, Help, Purpose, Simulation, When};

/// The entry. Example: the ring of B:5168-5188.
pub static CYCLE976: Cycle = Cycle {
    name: "CYCLE976",
    key: "cycle976",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { calibrates: When::Always, tasks: tasks::TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE976_HOLE, older::CYCLE976_SURFACE, newer::CYCLE976],
    // B:5471-5472, B:13656
    settings: &["_CBIT[14]", "_CBIT[15]"],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        // A:15866-15867, A:15920
        &common::alarms([61325, 61326, 61401]),
    ],
    checks: checks::checks,
    help: Help::new(&[STORED, help::LINES, PROBE]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: variants::EXAMPLES,
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    source: "B:5029-5593",
    ..common::CYCLE
};
