//! CYCLE961: inside and outside corner, with the direction of an edge (B:7816-8170).

mod checks;
mod corner;
mod help;
mod lines;
pub(crate) mod params;
mod picture;
mod propose;
mod results;
mod simulate;
#[cfg(test)]
mod tests;
mod touches;

pub(crate) use touches::edges;

use crate::catalogue::common::tasks::{ZERO, zero};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::help::{AGAIN, CALIBRATED, MEASURING, PROBE};
use crate::catalogue::{newer, older};

/// Measuring variants (B:7862-7869).
pub const VARIANTS: &[Variant] = &[
    Variant { number: 105, key: "cycle961-inside-rectangle", source: "B:7864;B:7917;A:8646" },
    Variant { number: 106, key: "cycle961-outside-rectangle", source: "B:7865;B:7918;A:8647" },
    Variant { number: 107, key: "cycle961-inside-any", source: "B:7866;B:7919;A:8648" },
    Variant { number: 108, key: "cycle961-outside-any", source: "B:7867;B:7920;A:8649" },
    Variant { number: 117, key: "cycle961-inside-points", source: "B:7868;B:8054;A:8650" },
    Variant { number: 118, key: "cycle961-outside-points", source: "B:7869;B:8055;A:8651" },
];

/// What the other control can do too, first those whose corner is one of a rectangle: there the zero may lie beside it.
const TASKS: &[Shared] = &[
    zero(Task::InnerCorner, 105, When::Variant(&[105]), BESIDE),
    zero(Task::OuterCorner, 106, When::Variant(&[106]), BESIDE),
    zero(Task::InnerCorner, 107, When::Variant(&[107, 117]), &[ZERO]),
    zero(Task::OuterCorner, 108, When::Variant(&[108, 118]), &[ZERO]),
];

const BESIDE: &[(Name, Meaning)] = &[
    (names::STA1, Meaning::EdgeAngle),
    (names::SETV4, Meaning::ZeroAtCorner),
    (names::SETV2, Meaning::ZeroAbscissa),
    (names::SETV3, Meaning::ZeroOrdinate),
    ZERO,
];

/// The entry. Example: the outside corner of B:7944-7972, A:8756-8793.
pub static CYCLE961: Cycle = Cycle {
    name: "CYCLE961",
    key: "cycle961",
    variants: VARIANTS,
    params: params::PARAMS,
    purpose: Purpose { tasks: TASKS, ..Purpose::MILLING },
    lists: &[older::CYCLE961_W, older::CYCLE961_P, newer::CYCLE961],
    // B:7834: on a lathe the length ends at the centre of the ball
    settings: &["_CBIT[14]"],
    results: results::RESULTS,
    alarms: &[
        common::EVERY_CYCLE,
        // A:15866, A:15868, A:15889-15890, A:15911-15913, A:15920; 61321 and 61412 for a _KNUM without a frame;
        // 61341 as B:13658 has it
        &common::alarms([61321, 61325, 61327, 61341, 61346, 61347, 61367, 61368, 61369, 61401, 61412]),
    ],
    checks: checks::checks,
    help: Help::new(&[help::LINES, PROBE, CALIBRATED, AGAIN, MEASURING]),
    picture: Drawing::staged(picture::stage, picture::marks),
    examples: &[
        (params::RECTANGLE, &[(names::INCA, "90"), (names::SETV4, "1")]),
        // the points of B:8090-8124
        (
            params::POINTS,
            &[
                (names::SETV0, "50"),
                (names::SETV1, "20"),
                (names::SETV2, "150"),
                (names::SETV3, "20"),
                (names::SETV4, "15"),
                (names::SETV5, "40"),
                (names::SETV6, "15"),
                (names::SETV7, "80"),
                (names::ID, "-60"),
            ],
        ),
    ],
    simulation: Some(Simulation::new(propose::propose, simulate::simulate)),
    aims: Aims {
        elements: &[(When::Always, Element::Corner)],
        corrects: common::ZERO_CORRECTED,
        options: &[
            (When::Variant(&[105, 107, 117]), "aim-side", "aim-inside"),
            (When::Variant(&[106, 108, 118]), "aim-side", "aim-outside"),
            (When::Variant(&[105, 106]), "aim-corner-points", "aim-corner-right"),
            (When::Variant(&[107, 108]), "aim-corner-points", "aim-corner-any"),
            (When::Variant(&[117, 118]), "aim-corner-points", "aim-corner-given"),
        ],
    },
    source: "B:7816-8170",
    ..common::CYCLE
};
