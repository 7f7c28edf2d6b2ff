//! G108: external corner of two walls along the axes of the plane (C:785-865).

use super::nct;
use super::nct::{corner, params};
use crate::dialect::Dialect;
use crate::entry::{
    Cycle, Drawing, Help, HelpLine, Param, Purpose, Simulation, Task, Variant, When, Work, address, before, corrects,
    measures, order, wrong,
};

/// The macro.
pub static G108: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G108",
    key: "g108",
    variants: &[Variant { number: 0, key: "g108-corner", source: "C:787" }],
    purpose: Purpose { tasks: &[nct::tasks::task(Task::OuterCorner, &[0], 0, nct::tasks::CORNER)], ..Purpose::MILLING },
    lists: &[],
    settings: &[],
    params: &[
        Param { source: "C:805", ..corner::X },
        Param { source: "C:805", ..corner::Y },
        Param { source: "C:805", ..corner::Z },
        Param { source: "C:806", ..params::Q },
        Param { source: "C:807-815", ..corner::S },
    ],
    results: corner::RESULTS,
    alarms: &[
        nct::MEASURING,
        &[nct::PATH_OBSTRUCTED], // the ways round the corner are protected like those of G101
    ],
    checks: |_, _, _| {},
    help: Help::new(&[HELP, nct::help::MEASURING]),
    picture: Drawing::staged(corner::stage, corner::marks),
    example: &[(address::X, "100"), (address::Y, "80"), (address::S, "1")],
    simulation: Some(Simulation::new(
        Work {
            propose: |inputs, control| corner::propose(inputs, control, true),
            simulate: |machine, inputs| corner::measure(machine, inputs, true),
        },
        &[],
    )),
    source: "C:785-865",
};

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Always, "help-g108-measures-corner", "C:787-800"),
    before(When::Always, "help-g108-before-before", "C:787-800"),
    order(When::Always, "help-g108-order-walls", "C:787-849"),
    corrects(When::Always, "help-g108-corrects-offset", "C:787-800"),
    wrong(When::Always, "help-g108-wrong-close", "C:787-849"),
];
