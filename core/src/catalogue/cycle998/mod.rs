//! CYCLE998: angle of a surface in one or two directions, for a rotation or a rotary axis (B:7252-7812).

mod angles;
mod checks;
mod correction;
mod help;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;

use crate::catalogue::common::tasks::{ZERO, zero};
use crate::catalogue::sinumerik::help::{AGAIN, DIFFERENTIAL, MEASURING, PROBE};
use crate::catalogue::{common, newer, older};
use crate::entry::{Aims, Cycle, Drawing, Element, Help, Purpose, Shared, Simulation, Task, Variant, When, names};

/// Measuring variants (B:7318-7324).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 105, key: "cycle998-one", source: "B:7320;B:7397;A:8091" },
    Variant { number: 1105, key: "cycle998-one-differential", source: "B:7321;B:7398;A:8092" },
    Variant { number: 100_105, key: "cycle998-one-paraxial", source: "B:7322;A:8093" },
    Variant { number: 106, key: "cycle998-two", source: "B:7323;B:7604;A:8094" },
    Variant { number: 100_106, key: "cycle998-two-paraxial", source: "B:7324;A:8095" },
];

/// What another control can do too: the angle of one edge.
const TASKS: &[Shared] = &[zero(Task::Angle, 105, When::Variant(&[105, 1105, 100_105]), &[ZERO])];

/// The entry. Example: the part on a rotary table of B:7428-7494.
pub static CYCLE998: Cycle = Cycle {
    name: "CYCLE998",
    key: "cycle998",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE998, newer::CYCLE998],
    // B:7526-7527: on a lathe the length ends at the centre of the ball
    settings: &["_CBIT[14]"],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        common::CORRECTION,
        // A:15866, A:15868, A:15872, A:15874, A:15908, A:15920; 61341 as B:13658 has it; 61412 for _KNUM = 1000
        // without a basic frame (A:15931)
        &common::alarms([61325, 61327, 61329, 61331, 61341, 61364, 61401, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[DIFFERENTIAL, help::LINES, PROBE, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[
        (params::PARAXIAL, &[(names::MD, "0")]),
        // the oblique plane of B:7624-7694
        (
            params::TWO,
            &[
                (names::SETVAL, "30"),
                (names::MD, "1"),
                (names::SETV0, "30"),
                (names::STA1, "8"),
                (names::INCA, "12"),
                (names::FA, "10"),
            ],
        ),
    ],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims { elements: &[(When::Always, Element::Angle)], corrects: common::ZERO_CORRECTED, options: &[] },
    source: "B:7252-7812",
    ..common::CYCLE
};
