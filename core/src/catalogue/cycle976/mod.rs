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
#[cfg(test)]
mod tests;

use crate::catalogue::common::tasks::{AXIS, SET, zero};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{PROBE, STORED};
use crate::catalogue::{newer, older};

/// Where holes with a known centre stand.
const KNOWN: &str = "B:5066-5084;B:5124-5162;A:5773-5792";
/// Where holes with an unknown centre stand.
const CENTRE: &str = "B:5222-5256;A:5977-5998";

/// Holes with a known centre, holes with an unknown one, surfaces (B:5060-5084; A:5796-5799 and B:15595); in each the
/// digits count up.
pub const VARIANTS: &[Variant] = &[
    Variant { number: 1, key: "cycle976-known-four", source: KNOWN },
    Variant { number: 101, key: "cycle976-known-four-ball", source: KNOWN },
    Variant { number: 1001, key: "cycle976-known-one", source: KNOWN },
    Variant { number: 2001, key: "cycle976-known-two", source: KNOWN },
    Variant { number: 2101, key: "cycle976-known-two-ball", source: KNOWN },
    Variant { number: 10_001, key: "cycle976-known-four-skew", source: KNOWN },
    Variant { number: 10_101, key: "cycle976-known-four-skew-ball", source: KNOWN },
    Variant { number: 12_001, key: "cycle976-known-two-skew", source: KNOWN },
    Variant { number: 12_101, key: "cycle976-known-two-skew-ball", source: KNOWN },
    Variant { number: 100_001, key: "cycle976-known-angle-four", source: KNOWN },
    Variant { number: 100_101, key: "cycle976-known-angle-four-ball", source: KNOWN },
    Variant { number: 101_001, key: "cycle976-known-angle-one", source: KNOWN },
    Variant { number: 102_001, key: "cycle976-known-angle-two", source: KNOWN },
    Variant { number: 102_101, key: "cycle976-known-angle-two-ball", source: KNOWN },
    Variant { number: 110_001, key: "cycle976-known-angle-four-skew", source: KNOWN },
    Variant { number: 110_101, key: "cycle976-known-angle-four-skew-ball", source: KNOWN },
    Variant { number: 112_001, key: "cycle976-known-angle-two-skew", source: KNOWN },
    Variant { number: 112_101, key: "cycle976-known-angle-two-skew-ball", source: KNOWN },
    Variant { number: 8, key: "cycle976-unknown-four", source: CENTRE },
    Variant { number: 108, key: "cycle976-unknown-four-ball", source: CENTRE },
    Variant { number: 10_008, key: "cycle976-unknown-four-skew", source: CENTRE },
    Variant { number: 10_108, key: "cycle976-unknown-four-skew-ball", source: CENTRE },
    Variant { number: 100_008, key: "cycle976-unknown-angle-four", source: CENTRE },
    Variant { number: 100_108, key: "cycle976-unknown-angle-four-ball", source: CENTRE },
    Variant { number: 110_008, key: "cycle976-unknown-angle-four-skew", source: CENTRE },
    Variant { number: 110_108, key: "cycle976-unknown-angle-four-skew-ball", source: CENTRE },
    Variant { number: 0, key: "cycle976-surface", source: "B:5348-5369;A:5796-5798" },
    Variant { number: 10_000, key: "cycle976-length", source: "B:5463-5501;A:5799" },
];

/// What the other control can do too.
const TASKS: &[Shared] = &[
    Shared { tool: None, ..zero(Task::Ball, 8, RING, &[SET]) },
    Shared { tool: None, ..zero(Task::Length, 10_000, When::Variant(&[10_000]), &[SET, AXIS]) },
];

const RING: When = When::Variant(&[8, 108, 10_008, 10_108, 1, 101, 10_001, 10_101]);

/// The entry. Example: the ring of B:5168-5188.
pub static CYCLE976: Cycle = Cycle {
    name: "CYCLE976",
    key: "cycle976",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { calibrates: When::Always, tasks: TASKS, ..Purpose::MILLING },
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
    examples: params::EXAMPLES,
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Probe)],
        corrects: &[(When::Always, Corrects::Probe, &[])],
        options: &[],
    },
    source: "B:5029-5593",
    ..common::CYCLE
};
