//! G104: length of the stylus at a surface of known height (C:351-427).
//!
//! The formula is not printed: the length becomes the one with which the surface shows its given coordinate. That is
//! right for both meanings of a length offset (C:355-379), the part of the tool outside the spindle and the axial
//! coordinate of a work offset, because either is subtracted from where the spindle stands.

use super::common::ALWAYS_REQUIRED;
use super::nct;
use super::nct::walls::home;
use super::nct::{REGISTER, axis_name, correct, overtravel, params, surface};
use crate::dialect::Dialect;
use crate::entry::{
    Cycle, Drawing, Help, HelpLine, Inputs, Meaning, Param, Purpose, Simulation, Task, Variant, When, Work, address,
    before, corrects, measures, order, wrong,
};
use crate::machine::{Machine, Stop};
use crate::name::Name;

/// Height of the surface in the tool axis; T is the register of the stylus itself.
const LENGTH_VALUES: &[(Name, Meaning)] =
    &[(address::X, Meaning::NominalInAxis), (address::Y, Meaning::NominalInAxis), (address::Z, Meaning::NominalInAxis)];

/// The macro.
pub static G104: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G104",
    key: "g104",
    variants: &[Variant { number: 0, key: "g104-length", source: "C:383" }],
    purpose: Purpose {
        calibrates: When::Always,
        tasks: &[nct::tasks::task(Task::Length, &[0], 0, LENGTH_VALUES)],
        ..Purpose::MILLING
    },
    lists: &[],
    settings: &[],
    params: &[
        Param { key: "g104-surface", source: "C:391-393", ..surface::X },
        Param { key: "g104-surface", source: "C:391-393", ..surface::Y },
        Param { key: "g104-surface", source: "C:391-393", ..surface::Z },
        Param { name: address::T, key: "g104-t", needs: ALWAYS_REQUIRED, source: "C:393", ..REGISTER },
    ],
    results: &[
        params::length("LENGTH", "result-g104-length", "C:383-393"),
        params::length("DEVIATION", "result-g104-deviation", "C:383-393"),
    ],
    alarms: &[nct::MEASURING],
    checks: |_, _, _| {},
    help: Help::new(&[HELP, nct::help::MEASURING, nct::help::CALIBRATING]),
    picture: Drawing::staged(surface::stage_axially, surface::marks_axially),
    example: &[(address::Z, "0"), (address::T, "98")],
    simulation: Some(Simulation::new(Work { propose: surface::propose_axially, simulate }, &[])),
    source: "C:351-427",
};

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let start = machine.position();
    let [.., applicate] = machine.control().plane.axes();
    let nominal = inputs.number(axis_name(applicate));
    let limit = overtravel(machine.control());
    let found = surface::touch_axially(machine, applicate, nominal, limit)?;
    home(machine, start)?;
    let length = machine.control().active_length()[applicate] + found - nominal;
    correct::results(machine, &[("LENGTH", length), ("DEVIATION", found - nominal)]);
    let register = inputs.integer(address::T);
    let wear = machine.control().register(register).length_wear[0];
    correct::write(machine, format!("H{register}"), length - wear);
    Ok(())
}

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Always, "help-g104-measures-length", "C:383-393"),
    before(When::Always, "help-g104-before-above", "C:383-393"),
    order(When::Always, "help-g104-order-down", "C:383-419"),
    corrects(When::Always, "help-g104-corrects-register", "C:355-393"),
    wrong(When::Always, "help-g104-wrong-coordinate", "C:355-393"),
];
