//! CYCLE982: tool probe on turning machines: calibrating it, measuring turning tools, milling tools and drills
//! (B:9124-10126).

mod checks;
mod cutter;
mod cutters;
mod drill;
mod edges;
mod help;
mod nose;
pub(crate) mod params;
pub(crate) mod picture;
pub(crate) mod propose;
mod results;
pub(crate) mod simulate;
mod stand;
#[cfg(test)]
mod tests;
mod variants;

use crate::catalogue::common::{CYCLE, alarms};
use crate::catalogue::{newer, tool_probe};
use crate::control::machine_data::TOOL_LENGTH_TYPE;
use crate::entry::{
    Aims, Corrects, Cycle, Drawing, Element, Examples, Help, ProbeUse, Purpose, Simulation, When, names,
};

/// What the worked measurement of a variant has beside the example.
const EXAMPLES: Examples = &[
    (params::REVERSAL, &[(names::CORA, "0")]),
    (params::INCREMENTAL, &[(names::MD, "1")]),
    (params::CALIBRATE, &[(names::MA, "2")]),
    (When::All(&[When::Any(&[params::RADIUS, params::BOTH]), When::Not(&params::RADIAL)]), &[(names::MA, "2")]),
];

/// The entry. Example: the milling cutter T3 in radial position of B:9526-9580, length L2 and radius.
pub static CYCLE982: Cycle = Cycle {
    name: "CYCLE982",
    key: "cycle982",
    variants: variants::VARIANTS,
    params: params::PARAMS,
    purpose: Purpose {
        probe: ProbeUse::Tool,
        calibrates: params::CALIBRATE,
        in_workpiece: tool_probe::params::WORKPIECE,
        ..Purpose::TURNING
    },
    // The call for calibrating tool probes knows CYCLE971 and CYCLE972 only (B:11768, although B:11708 names CYCLE982
    // beside it), and the list of newer controls is not known to us.
    lists: &[newer::CYCLE982],
    settings: &[
        "_TP", "_TPW", "_CVAL[0]", "_CVAL[3]", "_SPEED", "_EVMVNUM[0]", TOOL_LENGTH_TYPE, "_CBIT[0]", "_CBIT[1]",
        "_CBIT[5]", "_CHBIT[2]", "_CHBIT[3]", "_CHBIT[5]", "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]", "_CHBIT[20]",
        "_CHBIT[23]",
    ],
    results: results::RESULTS,
    // A:15856; 61326, 61330 and 61351 are ours, for what the manual refuses without a number (B:9208, B:9838), and as
    // in CYCLE972 (A:15873)
    alarms: &[tool_probe::ALARMS, &alarms([61315, 61326, 61330, 61351])],
    checks: checks::checks,
    help: Help::new(&[help::LINES, help::SHARED]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: EXAMPLES,
    simulation: Some(Simulation::new(propose::propose, simulate::simulate).with_tool(propose::tool)),
    aims: Aims {
        elements: &[(params::CALIBRATE, Element::Probe), (When::Always, Element::Tool)],
        corrects: &[(params::CALIBRATE, Corrects::Setter, &[]), (When::Not(&params::CALIBRATE), Corrects::Tool, &[])],
        options: &[(When::Always, "aim-tools", "aim-tools-all")],
    },
    source: "B:9124-10126",
    ..CYCLE
};
