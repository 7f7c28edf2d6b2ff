//! G110: bore or boss (C:1036-1183).
//!
//! The manual names neither the order of the walls nor the formulas (C:1036-1183). Here: first axis +, −; then, on the
//! centre line just found, second axis +, −. The first chord lies beside the centre by the distance then known, so
//! that its diameter follows from the circle of the ball centre; the mean of both diameters counts.

#[cfg(test)]
mod tests;

use super::nct;
use super::nct::correct::Place;
use super::nct::params::{ALONG_X, ALONG_Y, ALONG_Z};
use super::nct::ring::D;
use super::nct::touch::Calibration;
use super::nct::walls::{Walls, chord, from_outside, home, travel};
use super::nct::{axis_of, checks, correct, figures, params, walls};
use crate::catalogue::prelude::*;

/// The stylus is in the bore.
pub const BORE: i64 = walls::INSIDE;
/// The stylus stands above the boss; the address of the tool axis says how deep to measure.
pub const BOSS: i64 = walls::OUTSIDE;

/// The address of the tool axis makes it a boss, whatever its value (C:1076).
const AXIS: Param = Param { key: "g110-axis", unit: Unit::ActiveLength, source: "C:1076", ..PARAM };

const fn deep(along_tool: When) -> Need {
    optional(along_tool, "need-g110-boss")
}

/// The macro.
pub static G110: Cycle = Cycle {
    name: "G110",
    key: "g110",
    variants: &[
        Variant { number: BORE, key: "g110-bore", source: "C:1076" },
        Variant { number: BOSS, key: "g110-boss", source: "C:1076" },
    ],
    params: &[
        Param { key: "g110-d", usual: Range::closed(1.0, 1000.0), example: "50", source: "C:1075", ..D },
        Param { name: address::X, needs: &[deep(ALONG_X)], chooses: &[from_outside(ALONG_X)], ..AXIS },
        Param { name: address::Y, needs: &[deep(ALONG_Y)], chooses: &[from_outside(ALONG_Y)], ..AXIS },
        Param { name: address::Z, needs: &[deep(ALONG_Z)], chooses: &[from_outside(ALONG_Z)], ..AXIS },
        Param { needs: &[optional(When::Variant(&[BOSS]), "need-nct-optional")], source: "C:1077", ..params::R },
        Param { source: "C:1078", ..params::Q },
        Param { example: "1", source: "C:1079", ..params::S },
        Param { key: "nct-t-size", source: "C:1097", ..params::T },
        Param { source: "C:1091", ..params::M },
        Param { example: "0.02", source: "C:1098", ..params::H },
        Param { source: "C:1099", ..params::U },
        Param { example: "2", source: "C:1100", ..params::V },
        Param { example: "2", source: "C:1101", ..params::W },
    ],
    purpose: Purpose {
        tasks: &[
            nct::tasks::task(Task::Bore, &[BORE], BORE, nct::tasks::ROUND),
            nct::tasks::task(Task::Boss, &[BOSS], BOSS, nct::tasks::OUTSIDE),
        ],
        ..Purpose::MILLING
    },
    results: &[
        length("DIAMETER", "result-nct-diameter"),
        length("DEVIATION", "result-nct-deviation"),
        length("CENTRE_1", "result-nct-centre-1"),
        length("CENTRE_2", "result-nct-centre-2"),
        length("SHIFT_1", "result-nct-shift-1"),
        length("SHIFT_2", "result-nct-shift-2"),
    ],
    alarms: &[nct::MEASURING, nct::PROTECTED, nct::LIMITS, &[nct::TOOL_TOO_LARGE]],
    checks,
    help: Help::new(&[
        &[
            measures(When::Variant(&[BORE]), "help-g110-measures-bore", "C:1048-1076"),
            measures(When::Variant(&[BOSS]), "help-g110-measures-boss", "C:1048-1076"),
            before(When::Variant(&[BORE]), "help-g110-before-inside", "C:1048-1076"),
            before(When::Variant(&[BOSS]), "help-g110-before-above", "C:1048-1076"),
            order(When::Variant(&[BORE]), "help-g110-order-outwards", "C:1048-1157"),
            order(When::Variant(&[BOSS]), "help-g110-order-inwards", "C:1048-1157"),
            corrects(When::Always, "help-g110-corrects-half", "C:1089-1144"),
            wrong(When::Variant(&[BORE]), "help-g110-wrong-room", "C:1144"),
        ],
        nct::help::MEASURING,
        nct::help::TWO_MACROS,
        nct::help::SHIFTS,
    ]),
    picture: Drawing::staged(stage, marks),
    simulation: Some(Simulation::new(propose, simulate)),
    aims: Aims {
        elements: &[(When::Variant(&[BORE]), Element::Hole), (When::Variant(&[BOSS]), Element::Shaft)],
        corrects: nct::CORRECTED,
        options: &[],
    },
    source: "C:1036-1183",
    ..nct::MACRO
};

const fn length(name: &'static str, key: &'static str) -> ResultField {
    params::length(name, key, "C:1036-1046")
}

/// What goes wrong with the corrections, and a ball without a way to the wall of a bore.
fn checks(inputs: &Inputs, control: &Control, findings: &mut Vec<Diagnostic>) {
    checks::corrections(inputs, findings);
    if inputs.variant == BORE {
        checks::room(inputs, address::D, control, findings);
    }
}

fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let walls = Walls::of(machine, inputs, inputs.number(address::D));
    let first = chord(machine, &walls, 0)?;
    let middle = first.middle - Calibration::of(machine, 0).offset;
    travel(machine, walls.axes[0], middle)?;
    let second = chord(machine, &walls, 1)?;
    home(machine, Wcs(walls.start))?;
    let side = -walls.material();
    // the first chord was taken where the ball centre was in the second axis at the start
    let beside = walls.start[walls.axes[1]] + Calibration::of(machine, 1).offset - second.middle;
    let one = 2.0 * (first.half.hypot(beside) + side * first.ball);
    let two = 2.0 * (second.half + side * second.ball);
    let diameter = (one + two) / 2.0;
    let deviation = diameter - walls.size;
    let centre = [first.middle, second.middle];
    let places = [0, 1].map(|index| {
        let axis = walls.axes[index];
        Place { axis, nominal: walls.start[axis], deviation: centre[index] - walls.start[axis] }
    });
    let values = [
        ("DIAMETER", diameter),
        ("DEVIATION", deviation),
        ("CENTRE_1", centre[0]),
        ("CENTRE_2", centre[1]),
        ("SHIFT_1", places[0].deviation),
        ("SHIFT_2", places[1].deviation),
    ];
    correct::finish(machine, inputs, &values, &walls.found(deviation, &places));
    Ok(())
}

fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let diameter = inputs.positive(address::D, 50.0);
    walls::propose(inputs, control, |outside, height| match outside {
        true => Shape::Shaft { diameter, height },
        false => Shape::Hole { diameter, depth: height },
    })
}

/// Depth at which a drawn boss is measured, mm.
const DEPTH: f64 = -20.0;

/// The element from above, in the size of the picture.
fn stage(inputs: &Inputs) -> Staging {
    figures::stage(inputs, Look::ABOVE, &[address::D]).sized(inputs, &[address::D]).with(axis_of(inputs, 2), DEPTH)
}

/// Size and limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let size = |above: &Seen| vec![above.size(address::D, 0)];
    let all = |above: &Seen| [figures::axes(above), figures::limits(inputs, above), size(above)].concat();
    looks.iter().flat_map(all).collect()
}
