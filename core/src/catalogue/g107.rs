//! G107: internal corner of two walls along the axes of the plane (C:696-781).

use super::nct;
use super::nct::{corner, params};
use crate::entry::*;

/// The macro.
pub static G107: Cycle = Cycle {
    name: "G107",
    key: "g107",
    variants: &[Variant { number: 0, key: "g107-corner", source: "C:700" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::InnerCorner, &[0], 0, nct::tasks::CORNER)], ..Purpose::MILLING },
    params: &[
        Param { source: "C:723", ..corner::X },
        Param { source: "C:723", ..corner::Y },
        Param { source: "C:723", ..corner::Z },
        Param { source: "C:724", ..params::Q },
        Param { source: "C:725-733", ..corner::S },
    ],
    help: Help::new(&[
        &[
            measures(When::Always, "help-g107-measures-corner", "C:700-720"),
            before(When::Always, "help-g107-before-inside", "C:700-720"),
            order(When::Always, "help-g107-order-walls", "C:700-766"),
            corrects(When::Always, "help-g107-corrects-offset", "C:700-720"),
            wrong(When::Always, "help-g107-wrong-turned", "C:700-720"),
        ],
        nct::help::MEASURING,
        nct::help::TWO_MACROS,
    ]),
    simulation: Some(Simulation::new(corner::propose::<false>, corner::measure::<false>)),
    aims: Aims {
        elements: &[(When::Always, Element::Corner)],
        corrects: &[(When::Always, Corrects::Zero, &[])],
        options: &[(When::Always, "aim-side", "aim-inside")],
    },
    source: "C:696-781",
    ..corner::CORNER
};
