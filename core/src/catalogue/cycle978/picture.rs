//! CYCLE978 drawn: from above for the axes of the plane, as a section for the applicate. The set position stands where
//! the drawing has room; short distances are drawn longer than they are.

use super::params::{DIFFERENTIAL, TOOL};
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{circle, dimension, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Half the length of the drawn face, mm.
const FACE: f64 = 30.0;
/// Thickness behind the face, mm.
const BEHIND: f64 = 24.0;
/// Ball radius, mm.
const BALL: f64 = 3.0;
/// Where the zero point of the axis is drawn, mm from the face.
const ZERO: f64 = -44.0;

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let axis = inputs.integer(names::MA).clamp(1, 3);
    let path = inputs.given(names::FA).filter(|path| *path > 0.0).unwrap_or(2.0).clamp(6.0, 24.0);
    let (view, material) = if axis == 3 { (View::Section, ShapeKind::Cut) } else { (View::Plane, ShapeKind::Material) };
    let mut shapes = lying(path, TOOL.holds(inputs), material);
    if DIFFERENTIAL.holds(inputs) {
        let turn = circle(ShapeKind::Axis, [-BALL - path, 0.0], BALL * 1.8);
        shapes.push(turn.text("180°/0°").of(names::MVAR));
    }
    for shape in &mut shapes {
        turn(shape, axis);
    }
    Picture { view, shapes }
}

/// The face at 0, touched along the first drawing axis.
fn lying(path: f64, tool: bool, material: ShapeKind) -> Vec<PictureShape> {
    let start = -BALL - path;
    let zero = line(ShapeKind::Axis, vec![[ZERO, -FACE], [ZERO, FACE]]).text("0");
    let mut shapes = vec![
        polygon(material, vec![[0.0, -FACE], [BEHIND, -FACE], [BEHIND, FACE], [0.0, FACE]]),
        line(ShapeKind::Edge, vec![[0.0, -FACE], [0.0, FACE]]).of(names::SETVAL),
        line(ShapeKind::Axis, vec![[ZERO, 0.0], [BEHIND * 1.3, 0.0]]).of(names::MA),
        if tool { zero } else { zero.of(names::KNUM) },
        line(ShapeKind::Path, vec![[start, 0.0], [-BALL, 0.0]]).of(names::FA),
        circle(ShapeKind::Probe, [start, 0.0], BALL).of(names::PRNUM),
        circle(ShapeKind::Touch, [0.0, 0.0], BALL * 0.3).text("1").of(names::NMSP),
        dimension(names::SETVAL, [ZERO, -FACE * 0.6], [0.0, -FACE * 0.6]),
        dimension(names::FA, [start, BALL * 2.5], [-BALL, BALL * 2.5]),
    ];
    let band = |from: f64, to: f64, field| {
        let corners = vec![[from, -FACE], [to, -FACE], [to, FACE], [from, FACE]];
        polygon(ShapeKind::Tolerance, corners).of(field)
    };
    shapes.push(band(-3.2, 3.2, names::TSA));
    if tool {
        shapes.extend([band(-2.2, 2.2, names::TDIF), band(0.0, 1.2, names::TUL), band(-1.2, 0.0, names::TLL)]);
    }
    shapes
}

/// Turns a figure so that it is touched along the measuring axis: ordinate upwards, applicate downwards from above.
fn turn(shape: &mut PictureShape, axis: i64) {
    let place = |[x, y]: [f64; 2]| match axis {
        2 => [-y, x],
        3 => [y, -x],
        _ => [x, y],
    };
    for point in &mut shape.points {
        *point = place(*point);
    }
    if let Some((centre, _)) = &mut shape.circle {
        *centre = place(*centre);
    }
}
