//! G106: surface across the tool axis (C:562-694).
//!
//! Touched downwards. The text of T and M is that of G105 (radius), but the example corrects a length (C:676-694):
//! here both are the length.

use super::nct;
use super::nct::{checks, correct, params, surface};
use crate::catalogue::prelude::*;

/// The macro.
pub static G106: Cycle = Cycle {
    name: "G106",
    key: "g106",
    variants: &[Variant { number: 0, key: "g106-surface", source: "C:583" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::Face, &[0], 0, nct::tasks::IN_AXIS)], ..Purpose::MILLING },
    params: &[
        Param { key: "g106-surface", source: "C:603", ..surface::X },
        Param { key: "g106-surface", source: "C:603", ..surface::Y },
        Param { key: "g106-surface", example: "0", source: "C:603", ..surface::Z },
        Param { source: "C:604", ..params::Q },
        Param { example: "1", source: "C:605", ..params::S },
        Param { key: "g106-t", source: "C:624", ..params::T },
        Param { source: "C:620", ..params::M },
        Param { example: "0.2", source: "C:626", ..params::H },
        Param { source: "C:627", ..params::U },
        Param { example: "2", source: "C:628", ..params::W },
    ],
    results: &[
        params::length("POSITION", "result-nct-position", "C:562-583"),
        params::length("DEVIATION", "result-nct-position-deviation", "C:562-583"),
    ],
    alarms: &[nct::MEASURING, nct::LIMITS],
    checks: |inputs, _, findings| checks::corrections(inputs, findings),
    help: Help::new(&[
        &[
            measures(When::Always, "help-g106-measures-surface", "C:583-600"),
            before(When::Always, "help-g106-before-above", "C:583-600"),
            order(When::Always, "help-g106-order-down", "C:583-600"),
            corrects(When::Always, "help-g106-corrects-length", "C:676-694"),
            wrong(When::Always, "help-g106-wrong-low", "C:583-600"),
        ],
        nct::help::MEASURING,
        nct::help::ONE_MACRO,
        nct::help::SHIFTS,
    ]),
    picture: Drawing::staged(surface::stage_axially, surface::marks_axially),
    simulation: Some(Simulation::new(surface::propose_axially, simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Edge)],
        corrects: nct::CORRECTED,
        options: &[(When::Always, "aim-across", "aim-across-tool")],
    },
    source: "C:562-694",
    ..nct::MACRO
};

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let place = surface::touch_axially(machine, inputs, inputs.number(address::Q))?;
    surface::corrected(machine, inputs, place, 1.0, correct::LENGTH);
    Ok(())
}
