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
#[cfg(test)]
mod tests;

use crate::catalogue::common::tasks::{
    AXIS, DOWN, FIRST, LOWER, MOST, REACH, SAFE, SECOND, SET, TOOL, UPPER, ZERO, tool, zero,
};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, CORRECTION, MEASURING, PROBE};
use crate::catalogue::{newer, older};

/// Measuring variants (B:5641-5667; 1106 is in B:6192 only).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle977-hole-tool", source: "B:5645;B:5989;A:6491" },
    Variant { number: 2, key: "cycle977-shaft-tool", source: "B:5646;B:5990;A:6492" },
    Variant { number: 3, key: "cycle977-groove-tool", source: "B:5647;B:5991;A:6493" },
    Variant { number: 4, key: "cycle977-web-tool", source: "B:5648;B:5992;A:6494" },
    Variant { number: 5, key: "cycle977-pocket-tool", source: "B:5649;B:5993;A:6495" },
    Variant { number: 6, key: "cycle977-island-tool", source: "B:5650;B:5994;A:6496" },
    Variant { number: 101, key: "cycle977-hole-zero", source: "B:5651;B:6181;A:6497" },
    Variant { number: 102, key: "cycle977-shaft-zero", source: "B:5652;B:6182;A:6498" },
    Variant { number: 103, key: "cycle977-groove-zero", source: "B:5653;B:6183;A:6499" },
    Variant { number: 104, key: "cycle977-web-zero", source: "B:5654;B:6184;A:6500" },
    Variant { number: 105, key: "cycle977-pocket-zero", source: "B:5655;B:6185;A:6501" },
    Variant { number: 106, key: "cycle977-island-zero", source: "B:5656;B:6186;A:6502" },
    Variant { number: 1001, key: "cycle977-hole-zone-tool", source: "B:5657;B:5995;A:6503" },
    Variant { number: 1002, key: "cycle977-shaft-zone-tool", source: "B:5658;B:5996;A:6504" },
    Variant { number: 1003, key: "cycle977-groove-zone-tool", source: "B:5659;B:5997;A:6505" },
    Variant { number: 1004, key: "cycle977-web-zone-tool", source: "B:5660;B:5998;A:6506" },
    Variant { number: 1005, key: "cycle977-pocket-zone-tool", source: "B:5661;B:5999;A:6507" },
    Variant { number: 1006, key: "cycle977-island-zone-tool", source: "B:5662;B:6000;A:6508" },
    Variant { number: 1101, key: "cycle977-hole-zone-zero", source: "B:5663;B:6187;A:6509" },
    Variant { number: 1102, key: "cycle977-shaft-zone-zero", source: "B:5664;B:6188;A:6510" },
    Variant { number: 1103, key: "cycle977-groove-zone-zero", source: "B:5665;B:6189;A:6511" },
    Variant { number: 1104, key: "cycle977-web-zone-zero", source: "B:5666;B:6190;A:6512" },
    Variant { number: 1105, key: "cycle977-pocket-zone-zero", source: "B:5667;B:6191;A:6513" },
    Variant { number: 1106, key: "cycle977-island-zone-zero", source: "B:6192;A:6514" },
];

/// What the other control can do too, first those that correct a zero offset.
const TASKS: &[Shared] = &[
    zero(Task::Bore, 101, When::Variant(&[101, 1101]), &[SET, REACH, SAFE, ZERO]),
    zero(Task::Boss, 102, When::Variant(&[102, 1102]), &[SET, DOWN, REACH, SAFE, ZERO]),
    zero(Task::Pocket, 103, When::Variant(&[103, 1103]), &[SET, AXIS, REACH, SAFE, ZERO]),
    zero(Task::Web, 104, When::Variant(&[104, 1104]), &[SET, AXIS, DOWN, REACH, SAFE, ZERO]),
    zero(Task::Rectangle, 105, When::Variant(&[105, 1105]), &[FIRST, SECOND, REACH, SAFE, ZERO]),
    zero(Task::Island, 106, When::Variant(&[106, 1106]), &[FIRST, SECOND, DOWN, REACH, SAFE, ZERO]),
    tool(Task::Bore, 1, When::Variant(&[1, 1001]), &[SET, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Boss, 2, When::Variant(&[2, 1002]), &[SET, DOWN, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Pocket, 3, When::Variant(&[3, 1003]), &[SET, AXIS, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Web, 4, When::Variant(&[4, 1004]), &[SET, AXIS, DOWN, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Rectangle, 5, When::Variant(&[5, 1005]), &[FIRST, SECOND, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Island, 6, When::Variant(&[6, 1006]), &[FIRST, SECOND, DOWN, REACH, UPPER, LOWER, MOST, TOOL]),
];

/// The entry. Example: the hole of B:6050-6137.
pub static CYCLE977: Cycle = Cycle {
    name: "CYCLE977",
    key: "cycle977",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: TASKS, ..Purpose::MILLING },
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
    examples: params::EXAMPLES,
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[
            (mvar(1, &[1]), Element::Hole),
            (mvar(1, &[2]), Element::Shaft),
            (mvar(1, &[3]), Element::Groove),
            (mvar(1, &[4]), Element::Web),
            (mvar(1, &[5]), Element::Pocket),
            (mvar(1, &[6]), Element::Boss),
        ],
        corrects: common::CORRECTED,
        options: &[(When::Always, "aim-alignment", "aim-paraxial")],
    },
    source: "B:5600-6285",
    ..common::CYCLE
};
