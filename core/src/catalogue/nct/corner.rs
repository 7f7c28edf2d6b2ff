//! A corner of two walls that lie along the axes of the plane: G107 inside, G108 outside (C:696-865).
//!
//! Order and way are not printed. First the wall across the first axis, then that across the second, each from the
//! start and back to it. Outside, the stylus goes along a wall past the corner as far as it stood before it: where the
//! start is put decides where the walls are touched.

use super::correct::{move_offset, results};
use super::surface::{BALL, FACE, Wall, direction, touch_wall};
use super::walls::{home, travel};
use super::{FORMAT_ERROR, axis_name, part, ready_to_measure};
use crate::catalogue::common::{PARAM, required};
use crate::control::{Control, Plane};
use crate::entry::Inputs;
use crate::entry::{Need, Param, Proposal, ResultField, Unit, When};
use crate::machine::{Machine, Stop};
use crate::picture::figures::{circle, dimension, line, polygon};
use crate::picture::{Picture, ShapeKind, View};
use crate::workpiece::{Shape, Workpiece};

const fn in_planes(planes: &'static [When]) -> [Need; 1] {
    [required(When::Any(planes), "need-nct-corner")]
}

/// Nominal coordinate of the corner; both axes of the plane are needed (C:723).
const AXIS: Param = Param { key: "nct-corner", unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), ..PARAM };
/// X, in G17 and G18.
pub const X: Param =
    Param { name: "X", needs: &in_planes(&[When::Plane(Plane::G17), When::Plane(Plane::G18)]), ..AXIS };
/// Y, in G17 and G19.
pub const Y: Param =
    Param { name: "Y", needs: &in_planes(&[When::Plane(Plane::G17), When::Plane(Plane::G19)]), ..AXIS };
/// Z, in G18 and G19.
pub const Z: Param =
    Param { name: "Z", needs: &in_planes(&[When::Plane(Plane::G18), When::Plane(Plane::G19)]), ..AXIS };
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
        let Wall { position, .. } = touch_wall(machine, index, nominal[index], inputs.number("Q"))?;
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
    let offset = inputs.given("S").map_or(active, |number| number as usize);
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
    Proposal { workpiece: Workpiece { solids: vec![part::in_plane(shape, at, control)] }, start, ..Proposal::default() }
}

/// The corner from above, with the ways to its walls.
pub fn picture(inputs: &Inputs, outside: bool) -> Picture {
    let [first, second, _] = inputs.plane.axes().map(axis_name);
    let (near, zero) = (-FACE * 0.6, -FACE * 1.5);
    let past = super::surface::drawn(inputs.number("Q"));
    let material = if outside {
        vec![[0.0, 0.0], [FACE, 0.0], [FACE, FACE], [0.0, FACE]]
    } else {
        let (low, high) = (-FACE, FACE * 0.6);
        vec![[0.0, low], [high, low], [high, high], [low, high], [low, 0.0], [0.0, 0.0]]
    };
    let end = if outside { FACE } else { -FACE };
    let beyond = if outside { -near } else { near };
    let mut shapes = vec![
        polygon(ShapeKind::Material, material),
        line(ShapeKind::Edge, vec![[0.0, 0.0], [0.0, end]]).of(first),
        line(ShapeKind::Edge, vec![[0.0, 0.0], [end, 0.0]]).of(second),
        line(ShapeKind::Axis, vec![[zero, zero], [FACE, zero]]),
        line(ShapeKind::Axis, vec![[zero, zero], [zero, FACE]]),
        dimension(first, [zero, zero], [0.0, zero]),
        dimension(second, [zero, zero], [zero, 0.0]),
        dimension("Q", [0.0, end * 0.85], [past, end * 0.85]),
    ];
    let mirrored = |[x, y]: [f64; 2]| [y, x];
    let way = vec![[near, near], [near, beyond], [-BALL, beyond]];
    shapes.push(line(ShapeKind::Path, way.iter().copied().map(mirrored).collect()));
    shapes.push(line(ShapeKind::Path, way));
    for touch in [[0.0, beyond], [beyond, 0.0]] {
        shapes.push(circle(ShapeKind::Touch, touch, BALL * 0.3));
    }
    shapes.push(circle(ShapeKind::Probe, [near, near], BALL));
    Picture { view: View::Plane, shapes }
}
