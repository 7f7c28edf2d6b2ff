//! CYCLE977: hole, shaft, groove, web and rectangle, measured parallel to the axes (B:5600-6285).

mod checks;
mod element;
mod help;
pub(crate) mod params;
mod picture;
mod propose;
mod protection;
mod results;
pub(crate) mod simulate;
mod tasks;
#[cfg(test)]
mod tests;
mod variants;

pub use variants::VARIANTS;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, CORRECTION, MEASURING, PROBE};
use crate::catalogue::{common, newer, older};
use crate::entry::{Cycle, Drawing, Help, Purpose, Simulation};

/// The entry. Example: the hole of B:6050-6137.
pub static CYCLE977: Cycle = Cycle {
    name: "CYCLE977",
    key: "cycle977",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: tasks::TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE977_ROUND, older::CYCLE977_WIDTH, older::CYCLE977_RECTANGLE, newer::CYCLE977],
    settings: &["_CBIT[14]"], // B:5818: on a lathe the length ends at the centre of the ball
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        // A:15866-15882, A:15920-15921; 61412 for _KNUM = 1000 without a basic frame (A:15931)
        &common::alarms([61325, 61327, 61334, 61341, 61401, 61402, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[CORRECTION, help::LINES, BLOCK, PROBE, CALIBRATED, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: variants::EXAMPLES,
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    source: "B:5600-6285",
    ..common::CYCLE
};
