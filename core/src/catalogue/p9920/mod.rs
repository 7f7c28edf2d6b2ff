//! G65 P9920: the tool probe of NCT controls: calibrating it with a reference tool, measuring length and diameter of
//! tools (C:1185-1258).

mod checks;
mod help;
mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;
mod touch;

use crate::control::MachineSort;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Drawing, Help, ProbeUse, Purpose, Simulation, Variant, When, Work, address};

/// A reference tool calibrates the probe: T0.
pub const CALIBRATE: i64 = 0;
/// The length is measured.
pub const LENGTH: i64 = 1;
/// Length and diameter are measured: K is given.
pub const DIAMETER: i64 = 2;

/// The probe does not say that it is ready (C:1204).
pub const MEASURING_DEVICE: Code = Code::Nct("MEASURING DEVICE?");
/// The probe is pressed before the measurement (C:1204).
pub const DEPRESSED: Code = Code::Nct("DEPRESSED?");
/// The tool hits the disk while it sinks beside it (C:1224, C:1245).
pub const TOO_SMALL: Code = Code::Nct("D TOO SMALL!");
/// The tool does not reach the disk (C:1224, C:1245).
pub const INCORRECT: Code = Code::Nct("INCORRECT PROBING!");

/// The macro. Example: a mill of 12 mm, as the block format has it (C:1234).
pub static P9920: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G65 P9920",
    key: "p9920",
    variants: &[
        Variant { number: CALIBRATE, key: "p9920-calibrate", source: "C:1208-1228" },
        Variant { number: LENGTH, key: "p9920-length", source: "C:1232-1258" },
        Variant { number: DIAMETER, key: "p9920-diameter", source: "C:1232-1258" },
    ],
    params: params::PARAMS,
    purpose: Purpose {
        probe: ProbeUse::Tool,
        machine: MachineSort::Milling,
        calibrates: When::Variant(&[CALIBRATE]),
        tasks: &[],
    },
    lists: &[],
    settings: &[],
    results: results::RESULTS,
    alarms: &[&[MEASURING_DEVICE, DEPRESSED, TOO_SMALL, INCORRECT]],
    checks: checks::checks,
    help: Help::new(&[help::LINES]),
    picture: Drawing::new(picture::picture),
    example: &[(address::Z, "-8"), (address::D, "12"), (address::T, "1")],
    simulation: Some(Simulation::new(Work { propose: propose::propose, simulate: simulate::simulate }, &[])),
    source: "C:1185-1258",
};
