//! G107: internal corner of two walls along the axes of the plane (C:696-781).

use super::nct;
use super::nct::{corner, params};
use crate::dialect::Dialect;
use crate::entry::{
    Cycle, Drawing, Help, HelpLine, Param, Purpose, Simulation, Task, Variant, When, Work, address, before, corrects,
    measures, order, wrong,
};

/// The macro.
pub static G107: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G107",
    key: "g107",
    variants: &[Variant { number: 0, key: "g107-corner", source: "C:700" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::InnerCorner, &[0], 0, nct::tasks::CORNER)], ..Purpose::MILLING },
    lists: &[],
    settings: &[],
    params: &[
        Param { source: "C:723", ..corner::X },
        Param { source: "C:723", ..corner::Y },
        Param { source: "C:723", ..corner::Z },
        Param { source: "C:724", ..params::Q },
        Param { source: "C:725-733", ..corner::S },
    ],
    results: corner::RESULTS,
    alarms: &[nct::MEASURING],
    checks: |_, _, _| {},
    help: Help::new(&[HELP, nct::help::MEASURING]),
    picture: Drawing::staged(corner::stage, corner::marks),
    example: &[(address::X, "100"), (address::Y, "80"), (address::S, "1")],
    simulation: Some(Simulation::new(
        Work {
            propose: |inputs, control| corner::propose(inputs, control, false),
            simulate: |machine, inputs| corner::measure(machine, inputs, false),
        },
        &[],
    )),
    source: "C:696-781",
};

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Always, "help-g107-measures-corner", "C:700-720"),
    before(When::Always, "help-g107-before-inside", "C:700-720"),
    order(When::Always, "help-g107-order-walls", "C:700-766"),
    corrects(When::Always, "help-g107-corrects-offset", "C:700-720"),
    wrong(When::Always, "help-g107-wrong-turned", "C:700-720"),
];
