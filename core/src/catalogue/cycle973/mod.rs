//! CYCLE973: calibrate the workpiece probe of a turning machine in a reference groove or on a surface (B:10128-10407).

mod checks;
mod groove;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::sinumerik::help::{BLOCK, STORED};
use crate::catalogue::{common, lathe, newer, older};
use crate::entry::*;
use params::{BALL, GROOVE, ONE, SKEW, SURFACE, TWO};

/// Measuring variants (B:10163-10177). 13 is in the programs only, with axis and direction: it is 1013 (A:11504).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle973-surface", source: "B:10166;B:10349;A:11361" },
    Variant { number: 13, key: "cycle973-groove-short", source: "B:10292;A:11504" },
    Variant { number: 1013, key: "cycle973-groove-one", source: "B:10170;B:10245;A:11365" },
    Variant { number: 2013, key: "cycle973-groove-two", source: "B:10171;B:10295;A:11366" },
    Variant { number: 2113, key: "cycle973-groove-two-ball", source: "B:10171-10173;A:11366-11368" },
    Variant { number: 12_013, key: "cycle973-groove-two-skew", source: "B:10169-10171;A:11364-11366" },
    Variant { number: 12_113, key: "cycle973-groove-two-skew-ball", source: "B:10169-10173;A:11364-11368" },
];

/// The entry. Example: the surface of B:10366-10399.
pub static CYCLE973: Cycle = Cycle {
    name: "CYCLE973",
    key: "cycle973",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { calibrates: When::Always, ..Purpose::TURNING },
    lists: &[older::CYCLE973_SURFACE, older::CYCLE973_GROOVE, newer::CYCLE973],
    // B:13442-13482, B:13534-13572, B:13739-13773, B:13999-14014
    settings: &[
        "_WP", "_KB", "_CVAL[2]", "_CBIT[0]", "_CBIT[1]", "_CHBIT[2]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]",
        "_SPEED",
    ],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        lathe::ALARMS,
        // A:15867, A:15876; 61401 as in the other cycles (A:15920)
        &common::alarms([61326, 61333, 61401]),
    ],
    checks: checks::checks,
    // B:10127-10451
    help: Help::new(&[
        STORED,
        &[
            measures(SURFACE, "help-cycle973-measures-surface", "B:10331-10333"),
            measures(ONE, "help-cycle973-measures-groove-one", "B:10216"),
            measures(TWO, "help-cycle973-measures-groove-two", "B:10216"),
            before(SURFACE, "help-cycle973-before-surface", "B:10331;B:10411"),
            before(GROOVE, "help-cycle973-before-groove", "B:10213;B:10317;B:13470-13482"),
            before(When::Always, "help-cycle973-before-centre", "B:10275"),
            order(SURFACE, "help-cycle973-order-surface", "B:10403-10415"),
            order(GROOVE, "help-cycle973-order-into-groove", "B:10205-10230"),
            order(ONE, "help-cycle973-order-one", "B:10205-10230"),
            order(TWO, "help-cycle973-order-two", "B:10205-10230"),
            order(GROOVE, "help-cycle973-order-end-groove", "B:10323"),
            corrects(BALL, "help-cycle973-corrects-ball", "B:10163-10173"),
            corrects(SKEW, "help-cycle973-corrects-skew", "B:10163-10173"),
            wrong(GROOVE, "help-cycle973-wrong-groove-data", "B:13473-13482"),
            wrong(GROOVE, "help-cycle973-wrong-position", "B:10145;B:10213"),
            wrong(SURFACE, "help-cycle973-wrong-shank", "B:10331"),
        ],
        BLOCK,
        lathe::help::PROBE,
    ]),
    picture: Drawing::staged(picture::stage, picture::marks),
    // across the groove of position 7
    examples: &[(GROOVE, &[(names::CALNUM, "1"), (names::MA, "2")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Probe)],
        corrects: &[(When::Always, Corrects::Probe, &[])],
        options: &[],
    },
    source: "B:10128-10407",
    ..common::CYCLE
};
