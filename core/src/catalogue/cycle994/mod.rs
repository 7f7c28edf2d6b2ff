//! CYCLE994: two opposite points of a turned part, for a tool offset (B:10873-11146).

mod checks;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::sinumerik::help::{AGAIN, BLOCK, CORRECTION, MEASURING};
use crate::catalogue::{common, lathe, newer, older};
use crate::entry::*;
use params::INSIDE_ZONE;

/// Measuring variants (B:10930-10933). What A:12201 says about the second is a slip: there the zone counts outside.
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle994-inside-zone", source: "B:10932;B:10981;A:12250" },
    Variant { number: 2, key: "cycle994-outside-inside", source: "B:10933;B:10982;A:12250" },
];

/// Outside, or inside without a zone: where the probe stands decides.
const EITHER: When = When::Variant(&[2]);

/// The entry. Example: the outside diameter of B:11015-11090.
pub static CYCLE994: Cycle = Cycle {
    name: "CYCLE994",
    key: "cycle994",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose::TURNING,
    lists: &[older::CYCLE994, newer::CYCLE994],
    // B:2314, B:13534-13584, B:13739-13773, B:13917-14027
    settings: &[
        "_CBIT[0]", "_CBIT[1]", "_CBIT[2]", "_CHBIT[2]", "_CHBIT[4]", "_CHBIT[5]", "_CHBIT[6]", "_CHBIT[7]",
        "_CHBIT[8]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]", "_CHBIT[19]", "_SPEED", "_EV", "_MV",
    ],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        common::TOLERANCE,
        lathe::ALARMS,
        // A:15868; 61401 as in the other cycles (A:15920); for a protection zone that leaves no way no number is named,
        // 61334 is the one of CYCLE977
        &common::alarms([61327, 61401, 61334]),
    ],
    checks: checks::checks,
    // B:10906-11170
    help: Help::new(&[
        CORRECTION,
        &[
            measures(When::Always, "help-cycle994-measures-diameter", "B:10886"),
            before(When::Always, "help-cycle994-before-plus-side", "B:10889;B:10933"),
            before(INSIDE_ZONE, "help-cycle994-before-inside", "B:10932"),
            before(EITHER, "help-cycle994-before-either", "B:10933;B:11122-11142"),
            order(When::Always, "help-cycle994-order-plus-first", "B:10889"),
            order(INSIDE_ZONE, "help-cycle994-order-round-inside", "B:10932;B:11122-11142"),
            order(EITHER, "help-cycle994-order-round-outside", "B:11122-11142"),
            corrects(When::Always, "help-cycle994-corrects-half", "B:11076-11090"),
            wrong(When::Always, "help-cycle994-wrong-zone", "B:10891"),
            wrong(When::Always, "help-cycle994-wrong-ball", "B:10903-10906"),
        ],
        BLOCK,
        lathe::help::PROBE,
        &[before(When::Always, "help-cycle994-before-calibrated", "B:10901-10906")],
        AGAIN,
        MEASURING,
    ]),
    picture: Drawing::staged(picture::stage, picture::marks),
    // inside the zone has to be smaller than the bore
    examples: &[(INSIDE_ZONE, &[(names::SZO, "30")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Turned)],
        corrects: &[(When::Always, Corrects::Tool, &[]), (When::Always, Corrects::Nothing, common::UNCORRECTED)],
        options: &[
            (When::Always, "aim-touches", "aim-touches-two"),
            (When::Variant(&[1]), "aim-where", "cycle994-inside-zone"),
            (When::Variant(&[2]), "aim-where", "cycle994-outside-inside"),
        ],
    },
    source: "B:10873-11146",
    ..common::CYCLE
};
