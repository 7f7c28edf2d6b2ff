//! G108: external corner of two walls along the axes of the plane (C:785-865).

use super::nct;
use super::nct::{corner, params};
use crate::entry::*;

/// The macro.
pub static G108: Cycle = Cycle {
    name: "G108",
    key: "g108",
    variants: &[Variant { number: 0, key: "g108-corner", source: "C:787" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::OuterCorner, &[0], 0, nct::tasks::CORNER)], ..Purpose::MILLING },
    params: &[
        Param { source: "C:805", ..corner::X },
        Param { source: "C:805", ..corner::Y },
        Param { source: "C:805", ..corner::Z },
        Param { source: "C:806", ..params::Q },
        Param { source: "C:807-815", ..corner::S },
    ],
    alarms: &[nct::MEASURING, nct::PROTECTED],
    help: Help::new(&[
        &[
            measures(When::Always, "help-g108-measures-corner", "C:787-800"),
            before(When::Always, "help-g108-before-before", "C:787-800"),
            order(When::Always, "help-g108-order-walls", "C:787-849"),
            corrects(When::Always, "help-g108-corrects-offset", "C:787-800"),
            wrong(When::Always, "help-g108-wrong-close", "C:787-849"),
        ],
        nct::help::MEASURING,
        nct::help::TWO_MACROS,
    ]),
    simulation: Some(Simulation::new(corner::propose::<true>, corner::measure::<true>)),
    aims: Aims {
        elements: &[(When::Always, Element::Corner)],
        corrects: &[(When::Always, Corrects::Zero, &[])],
        options: &[(When::Always, "aim-side", "aim-outside")],
    },
    source: "C:785-865",
    ..corner::CORNER
};
