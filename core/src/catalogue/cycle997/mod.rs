//! CYCLE997: centre of one sphere, or position in space by three (B:8178-8539).

mod checks;
mod help;
pub(crate) mod params;
mod picture;
mod points;
mod propose;
mod results;
mod simulate;
mod sphere;
#[cfg(test)]
mod tests;
mod variants;

pub use variants::VARIANTS;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, MEASURING, PROBE};
use crate::catalogue::{common, newer};
use crate::entry::{Cycle, Drawing, Help, Simulation, names};

/// The entry. Example: the three spheres of B:8480-8529. Its program writes `_KNUM` = 99999, which does not exist;
/// meant is the active frame, there G54, which a form without a program has to name.
pub static CYCLE997: Cycle = Cycle {
    name: "CYCLE997",
    key: "cycle997",
    variants: VARIANTS,
    params: params::PARAMS,
    // no parameterizing call (B:11640-12133); the list of newer controls is not known to us
    lists: &[newer::CYCLE997],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        // A:15930-15933; 61316 of CYCLE116, which computes the circle (B:8361); 61321 for a frame that takes no
        // rotation; 61341 as B:13658 has it; 61401 as in the other cycles (A:15920)
        &common::alarms([61316, 61321, 61325, 61327, 61341, 61401, 61411, 61412, 61413, 61414]),
    ],
    checks: checks::checks,
    help: Help::new(&[help::LINES, BLOCK, PROBE, CALIBRATED, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[(params::ANGLE, &[(names::STA1, "0"), (names::INCA, "90"), (names::RF, "1000")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    source: "B:8178-8539",
    ..common::CYCLE
};
