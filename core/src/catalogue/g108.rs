//! G108: external corner of two walls along the axes of the plane (C:785-865).

use super::nct::{self, corner, params};
use super::{Cycle, Dialect, Drawing, Param, Purpose, Simulation, Variant, Work};

/// The macro.
pub static G108: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G108",
    key: "g108",
    variants: &[Variant {
        number: 0,
        key: "g108-corner",
        source: "C:787",
    }],
    purpose: Purpose::MILLING,
    lists: &[],
    settings: &[],
    params: &[
        Param {
            source: "C:805",
            ..corner::X
        },
        Param {
            source: "C:805",
            ..corner::Y
        },
        Param {
            source: "C:805",
            ..corner::Z
        },
        Param {
            source: "C:806",
            ..params::Q
        },
        Param {
            source: "C:807-815",
            ..corner::S
        },
    ],
    results: corner::RESULTS,
    alarms: &[
        nct::MEASURING,
        &[nct::PATH_OBSTRUCTED], // the ways round the corner are protected like those of G101
    ],
    checks: |_, _, _| {},
    picture: Drawing::new(|inputs| corner::picture(inputs, true)),
    example: &[("X", "100"), ("Y", "80"), ("S", "1")],
    simulation: Some(Simulation::new(
        Work {
            propose: |inputs, control| corner::propose(inputs, control, true),
            simulate: |machine, inputs| {
                nct::ready_to_measure(machine)?;
                corner::measure(machine, inputs, true)
            },
        },
        &[],
    )),
    source: "C:785-865",
};
