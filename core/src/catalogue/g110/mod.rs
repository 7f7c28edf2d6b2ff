//! G110: bore or boss (C:1036-1183).

mod addresses;
mod checks;
mod picture;
mod simulate;
#[cfg(test)]
mod tests;

use super::nct;
use super::nct::{params, part};
use crate::control::Control;
use crate::dialect::Dialect;
use crate::entry::{
    Cycle, Drawing, Help, HelpLine, Inputs, Proposal, Purpose, ResultField, Simulation, Task, Variant, When, Work,
    address, before, corrects, measures, order, wrong,
};
use crate::geometry::Wcs;
use crate::workpiece::{Shape, Workpiece};

/// The stylus stands in the bore.
pub const BORE: i64 = 0;
/// The stylus stands above the boss; the address of the tool axis says how deep to measure.
pub const BOSS: i64 = 1;

/// The macro.
pub static G110: Cycle = Cycle {
    dialect: Dialect::Nct,
    name: "G110",
    key: "g110",
    variants: &[
        Variant { number: BORE, key: "g110-bore", source: "C:1076" },
        Variant { number: BOSS, key: "g110-boss", source: "C:1076" },
    ],
    params: addresses::PARAMS,
    purpose: Purpose {
        tasks: &[
            nct::tasks::task(Task::Bore, &[BORE], BORE, nct::tasks::ROUND),
            nct::tasks::task(Task::Boss, &[BOSS], BOSS, nct::tasks::OUTSIDE),
        ],
        ..Purpose::MILLING
    },
    lists: &[],
    settings: &[],
    results: &[
        length("DIAMETER", "result-nct-diameter"),
        length("DEVIATION", "result-nct-deviation"),
        length("CENTRE_1", "result-nct-centre-1"),
        length("CENTRE_2", "result-nct-centre-2"),
        length("SHIFT_1", "result-nct-shift-1"),
        length("SHIFT_2", "result-nct-shift-2"),
    ],
    alarms: &[
        nct::MEASURING,
        &[
            nct::PATH_OBSTRUCTED, // the ways between the touches are protected like those of G101
            nct::OUT_OF_TOLERANCE,
            nct::UPPER_TOLERANCE,
            nct::TOOL_TOO_LARGE,
        ],
    ],
    checks: checks::checks,
    help: Help::new(&[HELP, nct::help::MEASURING, nct::help::SHIFTS]),
    picture: Drawing::staged(picture::stage, picture::marks),
    example: &[(address::D, "50"), (address::S, "1"), (address::H, "0.02"), (address::V, "2"), (address::W, "2")],
    simulation: Some(Simulation::new(Work { propose, simulate: simulate::simulate }, &[])),
    source: "C:1036-1183",
};

const fn length(name: &'static str, key: &'static str) -> ResultField {
    params::length(name, key, "C:1036-1046")
}

/// Coordinate of the tool axis to which a boss is measured, mm.
fn depth(inputs: &Inputs) -> Option<f64> {
    let [.., applicate] = inputs.plane.axes();
    inputs.given(nct::axis_name(applicate))
}

/// A bore whose upper face is the zero of the WCS, the stylus inside it; or a boss, the stylus above it.
fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let [.., applicate] = control.plane.axes();
    let diameter = inputs.positive(address::D, 50.0);
    let (mut top, mut start) = ([0.0; 3], [0.0; 3]);
    let shape = match depth(inputs) {
        Some(depth) if inputs.variant == BOSS => {
            top[applicate] = (depth + 10.0).max(0.0);
            start[applicate] = top[applicate] + 20.0;
            Shape::Shaft { diameter, height: top[applicate] - depth + 20.0 }
        }
        _ => {
            start[applicate] = -10.0;
            Shape::Hole { diameter, depth: 30.0 }
        }
    };
    Proposal {
        workpiece: Workpiece { solids: vec![part::in_plane(shape, top, control)] },
        start: Wcs(start),
        ..Proposal::default()
    }
}

/// The lines of the help page.
const HELP: &[HelpLine] = &[
    measures(When::Variant(&[BORE]), "help-g110-measures-bore", "C:1048-1076"),
    measures(When::Variant(&[BOSS]), "help-g110-measures-boss", "C:1048-1076"),
    before(When::Variant(&[BORE]), "help-g110-before-inside", "C:1048-1076"),
    before(When::Variant(&[BOSS]), "help-g110-before-above", "C:1048-1076"),
    order(When::Variant(&[BORE]), "help-g110-order-outwards", "C:1048-1157"),
    order(When::Variant(&[BOSS]), "help-g110-order-inwards", "C:1048-1157"),
    corrects(When::Always, "help-g110-corrects-half", "C:1089-1144"),
    wrong(When::Always, "help-g110-wrong-room", "C:1144"),
];
