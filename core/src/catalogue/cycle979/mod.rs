//! CYCLE979: hole, shaft, groove and web, measured at an angle (B:6736-7250).

mod checks;
mod help;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, CORRECTION, MEASURING, PROBE};
use crate::catalogue::{common, newer, older};
use crate::entry::{Aims, Cycle, Drawing, Element, Help, Simulation, Variant, When, mvar, names};

/// Measuring variants (B:6764-6773).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle979-hole-tool", source: "B:6766;B:6975;A:7613" },
    Variant { number: 2, key: "cycle979-shaft-tool", source: "B:6767;B:6976;A:7614" },
    Variant { number: 3, key: "cycle979-groove-tool", source: "B:6768;B:6977;A:7615" },
    Variant { number: 4, key: "cycle979-web-tool", source: "B:6769;B:6978;A:7616" },
    Variant { number: 101, key: "cycle979-hole-zero", source: "B:6770;B:7157;A:7617" },
    Variant { number: 102, key: "cycle979-shaft-zero", source: "B:6771;B:7158;A:7618" },
    Variant { number: 103, key: "cycle979-groove-zero", source: "B:6772;B:7159;A:7619" },
    Variant { number: 104, key: "cycle979-web-zero", source: "B:6773;B:7160;A:7620" },
];

/// The entry. Example: the segment of a hole of B:7013-7103.
pub static CYCLE979: Cycle = Cycle {
    name: "CYCLE979",
    key: "cycle979",
    variants: VARIANTS,
    params: params::PARAMS,
    lists: &[older::CYCLE979_ROUND, older::CYCLE979_WIDTH, newer::CYCLE979],
    // B:6929: whether the length ends at the centre of the ball
    settings: &["_CBIT[14]"],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        // A:15857-15858, A:15868, A:15882, A:15909; 61401 as in the other cycles (A:15920); 61412 for _KNUM = 1000
        // without a basic frame (A:15931)
        &common::alarms([61316, 61317, 61327, 61341, 61365, 61401, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[CORRECTION, help::LINES, BLOCK, PROBE, CALIBRATED, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    // B:7205-7246 for the groove; a web is crossed 20 mm above the measuring height
    examples: &[
        (params::ZERO, &[(names::KNUM, "2")]),
        (params::WIDTH, &[(names::STA1, "70")]),
        (params::WEB, &[(names::ID, "20")]),
    ],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[
            (mvar(1, &[1]), Element::Hole),
            (mvar(1, &[2]), Element::Shaft),
            (mvar(1, &[3]), Element::Groove),
            (mvar(1, &[4]), Element::Web),
        ],
        corrects: common::CORRECTED,
        options: &[(When::Always, "aim-alignment", "aim-at-angle")],
    },
    source: "B:6736-7250",
    ..common::CYCLE
};
