//! A corner of two walls that lie along the axes of the plane: G107 inside, G108 outside (C:696-865).
//!
//! Order and way are not printed. First the wall across the first axis, then that across the second, each from the
//! start and back to it. Outside, the stylus goes along a wall past the corner as far as it stood before it: where the
//! start is put decides where the walls are touched.

use super::correct::{Place, move_offset, results};
use super::params::{ALONG_X, ALONG_Y, ALONG_Z, COORDINATE};
use super::surface::{direction, touch_wall};
use super::walls::{home, travel};
use super::{MACRO, axis_of, figures, part, ready_to_measure};
use crate::catalogue::prelude::*;

/// A macro that measures a corner.
pub const CORNER: Cycle = Cycle { results: RESULTS, picture: Drawing::staged(stage, marks), ..MACRO };

const fn needed(planes: &'static [When]) -> Need {
    required(When::Any(planes), "need-nct-corner")
}

/// Nominal coordinate of the corner; both axes of the plane are needed (C:723).
const AXIS: Param = Param { key: "nct-corner", ..COORDINATE };
/// X, in G17 and G18.
pub const X: Param = Param { name: address::X, needs: &[needed(&[ALONG_Z, ALONG_Y])], example: "100", ..AXIS };
/// Y, in G17 and G19.
pub const Y: Param = Param { name: address::Y, needs: &[needed(&[ALONG_Z, ALONG_X])], example: "80", ..AXIS };
/// Z, in G18 and G19.
pub const Z: Param = Param { name: address::Z, needs: &[needed(&[ALONG_Y, ALONG_X])], ..AXIS };
/// Work offset; the one in use where it is not given (C:733).
pub const S: Param = Param { key: "nct-s-corner", example: "1", ..super::params::S };

/// What is found.
const RESULTS: &[ResultField] = &[
    super::params::length("CORNER_1", "result-nct-corner-1", "C:696-723"),
    super::params::length("CORNER_2", "result-nct-corner-2", "C:696-723"),
    super::params::length("SHIFT_1", "result-nct-corner-shift-1", "C:696-723"),
    super::params::length("SHIFT_2", "result-nct-corner-shift-2", "C:696-723"),
];

/// Nominal coordinates in the first and second axis, mm.
fn nominal(inputs: &Inputs) -> [f64; 2] {
    [0, 1].map(|index| inputs.number(axis_of(inputs, index)))
}

/// Touches both walls, goes back and moves the work offset.
pub fn measure<const OUTSIDE: bool>(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    ready_to_measure(machine)?;
    let start = machine.position();
    let nominal = nominal(inputs);
    let axes = machine.control().plane.axes();
    for index in [0, 1] {
        direction(machine, axes[index], index, nominal[index])?; // before anything moves
    }
    let mut corner = [0.0; 2];
    for (index, found) in corner.iter_mut().enumerate() {
        let other = axes[1 - index];
        if OUTSIDE {
            travel(machine, other, 2.0 * nominal[1 - index] - start[other])?;
        }
        (*found, _) = touch_wall(machine, index, nominal[index], inputs.number(address::Q))?;
        travel(machine, axes[index], start[axes[index]])?;
        travel(machine, other, start[other])?;
    }
    home(machine, start)?;
    let shift = [0, 1].map(|index| corner[index] - nominal[index]);
    results(machine, &[("CORNER_1", corner[0]), ("CORNER_2", corner[1]), ("SHIFT_1", shift[0]), ("SHIFT_2", shift[1])]);
    let places = [0, 1].map(|i| Place { axis: axes[i], nominal: nominal[i], deviation: shift[i] });
    let active = machine.control().settable;
    move_offset(machine, inputs.given(address::S).map_or(active, |number| number as usize), &places);
    Ok(())
}

/// A pocket or an island with the corner, its upper face at 0, and the stylus 10 mm deep before it.
pub fn propose<const OUTSIDE: bool>(inputs: &Inputs, control: &Control) -> Proposal {
    const SIDE: f64 = 80.0;
    let into = if OUTSIDE { 1.0 } else { -1.0 };
    let [x, y] = nominal(inputs);
    let middle = [x, y].map(|corner| corner + into * SIDE / 2.0);
    let shape = part::rectangle(OUTSIDE, [SIDE; 2], 30.0);
    part::propose(shape, [middle[0], middle[1], 0.0], [x - 20.0, y - 20.0, -10.0], control)
}

/// From the zero point to the drawn corner in both axes, mm.
const SET: f64 = 50.0;

/// The corner from above, with the ways to its walls.
fn stage(inputs: &Inputs) -> Staging {
    let stage = figures::stage(inputs, Look::ABOVE.ways(address::Q), &[]);
    [0, 1].into_iter().fold(stage, |stage, axis| {
        let name = axis_of(inputs, axis);
        stage.with(name, SET.copysign(inputs.number(name)))
    })
}

/// Coordinates of the corner and limits.
fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let fields = [0, 1].map(|axis| axis_of(inputs, axis));
    let corner = |above: &Seen| match above.touches[..] {
        [first, second] => above.centre([first.at[0], second.at[1]], fields, None),
        _ => Vec::new(),
    };
    looks.iter().flat_map(|above| [figures::limits(inputs, above), corner(above)].concat()).collect()
}
