//! CYCLE971: tool probe on milling machines: calibrating it, measuring length and radius of milling tools and drills
//! (B:4157-5029).

mod calibrate;
mod checks;
mod help;
mod measure;
pub(crate) mod params;
mod picture;
mod place;
mod propose;
mod results;
mod rotating;
mod simulate;
mod spindle;
#[cfg(test)]
mod tests;

use crate::catalogue::common::{CYCLE, alarms};
use crate::catalogue::{newer, older, tool_probe};
use crate::entry::{
    Aims, Corrects, Cycle, Drawing, Element, Help, ProbeUse, Purpose, Simulation, Variant, When, names,
};
use crate::support::FORMS;
use params::SPEEDS_IN_FORM;

/// Measuring variants (B:4186-4196, B:4621-4628).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle971-calibrate", source: "B:4188;B:4415;A:4821" },
    Variant { number: 10, key: "cycle971-calibrate-workpiece", source: "B:4192;B:4416;A:4825" },
    Variant { number: 1, key: "cycle971-still", source: "B:4189;B:4836;A:4822" },
    Variant { number: 2, key: "cycle971-rotating", source: "B:4190;B:4837;A:4823" },
    Variant { number: 11, key: "cycle971-still-workpiece", source: "B:4193;B:4838;A:4826" },
    Variant { number: 12, key: "cycle971-rotating-workpiece", source: "B:4194;B:4839;A:4827" },
    Variant { number: 10_000, key: "cycle971-incremental", source: "B:4191;B:4417;A:4824" },
    Variant { number: 10_010, key: "cycle971-incremental-workpiece", source: "B:4195;B:4418;A:4828" },
    Variant { number: 100_000, key: "cycle971-automatic", source: "B:4621;B:4648;A:5255" },
    Variant { number: 100_010, key: "cycle971-automatic-workpiece", source: "B:4622;B:4649;A:5257" },
];

/// The entry. Example: the milling cutter T3 of B:4865-4941, length with motionless spindle.
pub static CYCLE971: Cycle = Cycle {
    name: "CYCLE971",
    key: "cycle971",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose {
        probe: ProbeUse::Tool,
        calibrates: params::CALIBRATE,
        in_workpiece: tool_probe::params::WORKPIECE,
        ..Purpose::MILLING
    },
    lists: &[older::CYCLE971_CALIBRATION, older::CYCLE971, newer::CYCLE971],
    settings: &[
        "_TP", "_TPW", "_CVAL[0]", "_CVAL[3]", "_TP_CF", "_MT_COMP", "_MT_EC_R", "_MT_EC_L", "_CM", "_MFS", "_SPEED",
        "_EVMVNUM[0]", "_CBIT[0]", "_CBIT[1]", "_CBIT[12]", "_CHBIT[2]", "_CHBIT[3]", "_CHBIT[5]", "_CHBIT[15]",
        "_CHBIT[16]", "_CHBIT[17]", "_CHBIT[22]", FORMS, SPEEDS_IN_FORM,
    ],
    results: results::RESULTS,
    alarms: &[
        tool_probe::ALARMS,
        // A:15848, A:15891-15893, A:15910, A:15920, A:15934
        &alarms([61309, 61349, 61350, 61351, 61366, 61401, 61415]),
    ],
    checks: checks::checks,
    help: Help::new(&[help::LINES, help::SHARED]),
    picture: Drawing::staged(picture::stage, picture::marks),
    // a side, as every variant but the automatic one can touch it
    examples: &[(params::CALIBRATE, &[(names::MA, "1")]), (params::INCREMENTAL, &[(names::FA, "-3")])],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(params::CALIBRATE, Element::Probe), (When::Always, Element::Tool)],
        corrects: &[(params::CALIBRATE, Corrects::Setter, &[]), (When::Not(&params::CALIBRATE), Corrects::Tool, &[])],
        options: &[],
    },
    source: "B:4157-5029",
    ..CYCLE
};
