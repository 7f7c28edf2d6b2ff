//! G104: length of the stylus at a surface of known height (C:351-427).
//!
//! The formula is not printed: the length becomes the one with which the surface shows its given coordinate. That is
//! right for both meanings of a length offset (C:355-379), the part of the tool outside the spindle and the axial
//! coordinate of a work offset, because either is subtracted from where the spindle stands.

use super::nct;
use super::nct::{REGISTER, correct, overtravel, params, surface};
use crate::catalogue::prelude::*;

/// Height of the surface in the tool axis; T is the register of the stylus itself.
const LENGTH_VALUES: &[(Name, Meaning)] =
    &[(address::X, Meaning::NominalInAxis), (address::Y, Meaning::NominalInAxis), (address::Z, Meaning::NominalInAxis)];

/// The macro.
pub static G104: Cycle = Cycle {
    name: "G104",
    key: "g104",
    variants: &[Variant { number: 0, key: "g104-length", source: "C:383" }],
    purpose: Purpose {
        calibrates: When::Always,
        tasks: &[nct::tasks::task(Task::Length, &[0], 0, LENGTH_VALUES)],
        ..Purpose::MILLING
    },
    params: &[
        Param { key: "g104-surface", source: "C:391-393", ..surface::X },
        Param { key: "g104-surface", source: "C:391-393", ..surface::Y },
        Param { key: "g104-surface", example: "0", source: "C:391-393", ..surface::Z },
        Param { name: address::T, key: "g104-t", needs: ALWAYS_REQUIRED, example: "98", source: "C:393", ..REGISTER },
    ],
    results: &[
        params::length("LENGTH", "result-g104-length", "C:383-393"),
        params::length("DEVIATION", "result-g104-deviation", "C:383-393"),
    ],
    help: Help::new(&[
        &[
            measures(When::Always, "help-g104-measures-length", "C:383-393"),
            before(When::Always, "help-g104-before-above", "C:383-393"),
            order(When::Always, "help-g104-order-down", "C:383-419"),
            corrects(When::Always, "help-g104-corrects-register", "C:355-393"),
            wrong(When::Always, "help-g104-wrong-coordinate", "C:355-393"),
        ],
        nct::help::MEASURING,
        nct::help::ONE_MACRO,
        nct::help::CALIBRATING,
    ]),
    picture: Drawing::staged(surface::stage_axially, surface::marks_axially),
    simulation: Some(Simulation::new(surface::propose_axially, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Probe)],
        corrects: &[(When::Always, Corrects::Probe, &[])],
        options: &[(When::Always, "aim-measured", "g104-length")],
    },
    source: "C:351-427",
    ..nct::MACRO
};

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let limit = overtravel(machine.control());
    let found = surface::touch_axially(machine, inputs, limit)?;
    let length = machine.control().active_length()[found.axis] + found.deviation;
    correct::results(machine, &[("LENGTH", length), ("DEVIATION", found.deviation)]);
    let register = inputs.integer(address::T);
    let wear = machine.control().register(register).length_wear[0];
    machine.write_correction(format!("H{register}"), length - wear);
    Ok(())
}
