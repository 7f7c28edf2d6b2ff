//! CYCLE972: tool probe on turning machines: calibrating it, measuring the lengths of turning tools (B:8736-9090).
//! CYCLE982 with its variants 0 and 1 does the same (B:8752-8760).

mod checks;
mod help;
mod lists;
pub(crate) mod params;
mod results;
#[cfg(test)]
mod tests;

use crate::catalogue::common::alarms;
use crate::catalogue::cycle982::{picture, propose, simulate as measuring};
use crate::catalogue::sinumerik::alarm;
use crate::catalogue::tool_probe;
use crate::control::MachineSort;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Drawing, Help, Inputs, ProbeUse, Purpose, Simulation, Variant, Work, names};
use crate::machine::{Machine, Stop};

/// Measuring variants (B:8766-8771).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 0, key: "cycle972-calibrate", source: "B:8770;B:8816;A:9685" },
    Variant { number: 1, key: "cycle972-measure", source: "B:8771;B:8964;A:9686" },
];

/// The entry. Example: the turning tool T3 of B:9044-9053, length L1.
pub static CYCLE972: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "CYCLE972",
    key: "cycle972",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose {
        probe: ProbeUse::Tool,
        machine: MachineSort::Turning,
        calibrates: params::CALIBRATE,
        tasks: &[],
    },
    lists: lists::LISTS,
    settings: &[
        "_TP", "_CVAL[0]", "_SPEED", "_EVMVNUM[0]", "_CBIT[0]", "_CBIT[1]", "_CHBIT[2]", "_CHBIT[3]", "_CHBIT[5]",
        "_CHBIT[15]", "_CHBIT[16]", "_CHBIT[17]",
    ],
    results: results::RESULTS,
    // A:15856, A:15873
    alarms: &[tool_probe::ALARMS, &alarms([61315, 61330])],
    checks: checks::checks,
    help: Help::new(&[help::LINES, tool_probe::help::ALL]),
    picture: Drawing::staged(picture::stage, picture::marks),
    example: &[
        (names::MVAR, "1"),
        (names::MA, "2"),
        (names::PRNUM, "1"),
        (names::FA, "1"),
        (names::TSA, "1"),
        (names::VMS, "0"),
        (names::NMSP, "1"),
        (names::EVNUM, "0"),
        (names::TZL, "0.001"),
        (names::TDIF, "0.8"),
    ],
    simulation: Some(Simulation::new(Work { propose: propose::propose, simulate }, &[]).with_tool(propose::tool)),
    source: "B:8736-9090",
};

/// What CYCLE982 does with these variants; where the coordinate system is turned it is 61330 (A:15873).
fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    if machine.control().rotated() {
        return Err(alarm(machine, 61330));
    }
    measuring::run(machine, inputs, 972)
}
