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

use crate::catalogue::newer;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CALIBRATED, MEASURING, PROBE};

/// Where the variants stand (B:8242-8259). Four points at an angle with the diameter follow from the digits; the text
/// names the digits of three points only (B:8371).
const SOURCE: &str = "B:8246-8259;B:15850";

const fn variant(number: i64, key: &'static str) -> Variant {
    Variant { number, key, source: SOURCE }
}

/// One sphere, three spheres; in each parallel to the axes, then at an angle with three and with four points.
pub const VARIANTS: &[Variant] = &[
    variant(109, "cycle997-one"),
    variant(119, "cycle997-one-repeat"),
    variant(1_000_109, "cycle997-one-diameter"),
    variant(1_000_119, "cycle997-one-diameter-repeat"),
    variant(1109, "cycle997-one-angle"),
    variant(1119, "cycle997-one-angle-repeat"),
    variant(1_001_109, "cycle997-one-angle-diameter"),
    variant(1_001_119, "cycle997-one-angle-diameter-repeat"),
    variant(101_109, "cycle997-one-angle-four"),
    variant(101_119, "cycle997-one-angle-four-repeat"),
    variant(1_101_109, "cycle997-one-angle-four-diameter"),
    variant(1_101_119, "cycle997-one-angle-four-diameter-repeat"),
    variant(10_109, "cycle997-three"),
    variant(10_119, "cycle997-three-repeat"),
    variant(1_010_109, "cycle997-three-diameter"),
    variant(1_010_119, "cycle997-three-diameter-repeat"),
    variant(11_109, "cycle997-three-angle"),
    variant(11_119, "cycle997-three-angle-repeat"),
    variant(1_011_109, "cycle997-three-angle-diameter"),
    variant(1_011_119, "cycle997-three-angle-diameter-repeat"),
    variant(111_109, "cycle997-three-angle-four"),
    variant(111_119, "cycle997-three-angle-four-repeat"),
    variant(1_111_109, "cycle997-three-angle-four-diameter"),
    variant(1_111_119, "cycle997-three-angle-four-diameter-repeat"),
];

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
    aims: Aims { elements: &[(When::Always, Element::Sphere)], corrects: common::ZERO_CORRECTED, options: &[] },
    source: "B:8178-8539",
    ..common::CYCLE
};
