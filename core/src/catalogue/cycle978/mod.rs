//! CYCLE978: one point on a surface parallel to an axis (B:6287-6735).

mod checks;
mod help;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
pub(crate) mod simulate;
mod tasks;
#[cfg(test)]
mod tests;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CORRECTION, DIFFERENTIAL, MEASURING, PROBE};
use crate::catalogue::{common, newer, older};
use crate::entry::{Cycle, Drawing, Help, Purpose, Simulation, Variant, names};

/// Measuring variants (B:6323-6328).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle978-tool", source: "B:6325;B:6596;A:7189" },
    Variant { number: 100, key: "cycle978-zero", source: "B:6326;B:6456;A:7190" },
    Variant { number: 1000, key: "cycle978-differential-tool", source: "B:6327;B:6597;A:7191" },
    Variant { number: 1100, key: "cycle978-differential-zero", source: "B:6328;B:6457;A:7192" },
];

/// The entry. Example: the surface of B:6632-6704.
pub static CYCLE978: Cycle = Cycle {
    name: "CYCLE978",
    key: "cycle978",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: tasks::TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE978, newer::CYCLE978],
    settings: &["_CBIT[14]"], // B:6400: on a lathe the length ends at the centre of the ball
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        // A:15866-15882, A:15920; 61412 for _KNUM = 1000 without a basic frame (A:15931)
        &common::alarms([61325, 61327, 61341, 61401, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[CORRECTION, DIFFERENTIAL, help::LINES, BLOCK, PROBE, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[(params::ZERO, &[(names::KNUM, "1")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    source: "B:6287-6735",
    ..common::CYCLE
};
