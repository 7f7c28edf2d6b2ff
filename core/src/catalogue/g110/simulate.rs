//! What G110 does: four walls, centre and diameter, corrections, messages, print-out.
//!
//! The manual names neither the order of the walls nor the formulas (C:1036-1183). Here: first axis +, −; then, on the
//! centre line just found, second axis +, −. The first chord lies beside the centre by the distance then known, so
//! that its diameter follows from the circle of the ball centre; the mean of both diameters counts.

use super::{BOSS, depth};
use crate::catalogue::nct;
use crate::catalogue::nct::correct::{Found, Part};
use crate::catalogue::nct::touch::Calibration;
use crate::catalogue::nct::walls::{Chord, Outside, Walls, chord, home, travel};
use crate::catalogue::nct::{axis_name, correct, print};
use crate::entry::{Inputs, address};
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};

/// What was measured, mm.
struct Measured {
    centre: [f64; 2],
    shift: [f64; 2],
    diameter: f64,
    deviation: f64,
}

/// Carries out the macro.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    nct::ready_to_measure(machine)?;
    let walls = walls(machine, inputs);
    let first = chord(machine, &walls, 0)?;
    let middle = first.middle - Calibration::of(machine, 0).offset;
    travel(machine, walls.axes[0], middle)?;
    let second = chord(machine, &walls, 1)?;
    home(machine, Wcs(walls.start))?;
    let measured = evaluate(machine, &walls, &first, &second);
    correct::results(
        machine,
        &[
            ("DIAMETER", measured.diameter),
            ("DEVIATION", measured.deviation),
            ("CENTRE_1", measured.centre[0]),
            ("CENTRE_2", measured.centre[1]),
            ("SHIFT_1", measured.shift[0]),
            ("SHIFT_2", measured.shift[1]),
        ],
    );
    correct::correct(machine, inputs, &found(&walls, &measured));
    print::print(machine, inputs, &printed(&walls, &measured));
    Ok(())
}

fn walls(machine: &mut dyn Machine, inputs: &Inputs) -> Walls {
    let outside = depth(inputs).filter(|_| inputs.variant == BOSS);
    Walls {
        outside: outside.map(|depth| Outside { depth, clearance: inputs.number(address::R) }),
        size: inputs.number(address::D),
        overtravel: inputs.number(address::Q),
        start: machine.position().0,
        axes: machine.control().plane.axes(),
    }
}

fn evaluate(machine: &mut dyn Machine, walls: &Walls, first: &Chord, second: &Chord) -> Measured {
    let side = -walls.material();
    // the first chord was taken where the ball centre stood in the second axis at the start
    let beside = walls.start[walls.axes[1]] + Calibration::of(machine, 1).offset - second.middle;
    let one = 2.0 * (first.half.hypot(beside) + side * first.ball);
    let two = 2.0 * (second.half + side * second.ball);
    let diameter = (one + two) / 2.0;
    let centre = [first.middle, second.middle];
    let shift = [0, 1].map(|i| centre[i] - walls.start[walls.axes[i]]);
    Measured { centre, shift, diameter, deviation: diameter - walls.size }
}

fn found(walls: &Walls, measured: &Measured) -> Found {
    let excess = walls.material() * measured.deviation; // metal on is positive (C:1092-1095)
    let mut shift = [None; 3];
    for (i, value) in measured.shift.into_iter().enumerate() {
        shift[walls.axes[i]] = Some(value);
    }
    Found {
        deviation: measured.deviation,
        excess,
        at_surface: excess / 2.0,
        shift,
        part: Part::Radius,
        room: walls.outside.is_none().then_some(walls.size),
    }
}

fn printed(walls: &Walls, measured: &Measured) -> print::Values {
    let position = |i: usize| {
        let axis = walls.axes[i];
        (axis_name(axis).as_str(), walls.start[axis], measured.shift[i])
    };
    print::Values { dimension: Some((walls.size, measured.deviation)), positions: [0, 1].map(position).into() }
}
