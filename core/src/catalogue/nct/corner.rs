//! A corner of two walls that lie along the axes of the plane: G107 inside, G108 outside (C:696-865).
//!
//! Order and way are not printed. First the wall across the first axis, then that across the second, each from the
//! start and back to it. Outside, the stylus goes along a wall past the corner as far as it stood before it: where the
//! start is put decides where the walls are touched.

use super::correct::{move_offset, results};
use super::surface::{Wall, direction, touch_wall};
use super::walls::{home, travel};
use super::{FORMAT_ERROR, axis_name, figures, part, ready_to_measure};
use crate::catalogue::common::{PARAM, required};
use crate::control::{Control, Plane};
use crate::entry::stage::{Look, Seen, Staging};
use crate::entry::{Inputs, Need, Param, Proposal, ResultField, Unit, When, address};
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};
use crate::picture::PictureShape;
use crate::workpiece::{Shape, Workpiece};

const fn in_planes(planes: &'static [When]) -> [Need; 1] {
    [required(When::Any(planes), "need-nct-corner")]
}

/// Nominal coordinate of the corner; both axes of the plane are needed (C:723).
const AXIS: Param = Param { key: "nct-corner", unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), ..PARAM };
/// X, in G17 and G18.
pub const X: Param =
    Param { name: address::X, needs: &in_planes(&[When::Plane(Plane::G17), When::Plane(Plane::G18)]), ..AXIS };
/// Y, in G17 and G19.
pub const Y: Param =
    Param { name: address::Y, needs: &in_planes(&[When::Plane(Plane::G17), When::Plane(Plane::G19)]), ..AXIS };
/// Z, in G18 and G19.
pub const Z: Param =
    Param { name: address::Z, needs: &in_planes(&[When::Plane(Plane::G18), When::Plane(Plane::G19)]), ..AXIS };
/// Work offset; the one in use where it is not given (C:733).
pub const S: Param = Param { key: "nct-s-corner", ..super::params::S };

/// What is found.
pub const RESULTS: &[ResultField] = &[
    super::params::length("CORNER_1", "result-nct-corner-1", "C:696-723"),
    super::params::length("CORNER_2", "result-nct-corner-2", "C:696-723"),
    super::params::length("SHIFT_1", "result-nct-corner-shift-1", "C:696-723"),
    super::params::length("SHIFT_2", "result-nct-corner-shift-2", "C:696-723"),
];

/// Nominal coordinates in the first and second axis, mm.
fn nominal(inputs: &Inputs) -> [f64; 2] {
    let [first, second, _] = inputs.plane.axes();
    [first, second].map(|axis| inputs.number(axis_name(axis)))
}

/// Touches both walls, goes back and moves the work offset.
pub fn measure(machine: &mut dyn Machine, inputs: &Inputs, outside: bool) -> Result<(), Stop> {
    ready_to_measure(machine)?;
    let start = machine.position();
    let nominal = nominal(inputs);
    let axes = machine.control().plane.axes();
    for (index, axis) in axes.into_iter().take(2).enumerate() {
        direction(machine, axis, index, nominal[index])?; // before anything moves
    }
    let mut corner = [0.0; 2];
    for (index, found) in corner.iter_mut().enumerate() {
        let other = axes[1 - index];
        if outside {
            travel(machine, other, 2.0 * nominal[1 - index] - start[other])?;
        }
        let Wall { position, .. } = touch_wall(machine, index, nominal[index], inputs.number(address::Q))?;
        *found = position;
        travel(machine, axes[index], start[axes[index]])?;
        travel(machine, other, start[other])?;
    }
    home(machine, start)?;
    let shift = [0, 1].map(|index| corner[index] - nominal[index]);
    let mut moved = [None; 3];
    (moved[axes[0]], moved[axes[1]]) = (Some(shift[0]), Some(shift[1]));
    results(machine, &[("CORNER_1", corner[0]), ("CORNER_2", corner[1]), ("SHIFT_1", shift[0]), ("SHIFT_2", shift[1])]);
    let active = machine.control().settable;
    let offset = inputs.given(address::S).map_or(active, |number| number as usize);
    move_offset(machine, offset, moved);
    Ok(())
}

/// A pocket or an island with the corner, its upper face at 0, and the stylus 10 mm deep before it.
pub fn propose(inputs: &Inputs, control: &Control, outside: bool) -> Proposal {
    const SIDE: f64 = 80.0;
    let axes = control.plane.axes();
    let nominal = nominal(inputs);
    let (mut at, mut start) = ([0.0; 3], [0.0; 3]);
    for index in [0, 1] {
        let into = if outside { 1.0 } else { -1.0 };
        at[axes[index]] = nominal[index] + into * SIDE / 2.0;
        start[axes[index]] = nominal[index] - 20.0;
    }
    start[axes[2]] = -10.0;
    let length = [SIDE; 2];
    let shape = if outside { Shape::Island { length, height: 30.0 } } else { Shape::Pocket { length, depth: 30.0 } };
    Proposal {
        workpiece: Workpiece { solids: vec![part::in_plane(shape, at, control)] },
        start: Wcs(start),
        ..Proposal::default()
    }
}

/// From the zero point to the drawn corner in both axes, mm.
const SET: f64 = 50.0;

/// The corner from above, with the ways to its walls.
pub fn stage(inputs: &Inputs) -> Staging {
    let stage = figures::stage(inputs, Look::ABOVE.ways(address::Q), &[]);
    [0, 1].into_iter().fold(stage, |stage, axis| {
        let name = figures::address(inputs, axis);
        stage.with(name, SET.copysign(inputs.number(name)))
    })
}

/// Its coordinates and the limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above] = looks else {
        return Vec::new();
    };
    let fields = [0, 1].map(|axis| figures::address(inputs, axis));
    let mut shapes = figures::limits(inputs, above);
    if let [first, second] = above.touches[..] {
        shapes.extend(above.centre([first.at[0], second.at[1]], fields, None));
    }
    shapes
}
