//! CYCLE974 drawn: the turned part from the side for the axes of the plane, from its end for the applicate; with
//! reversal its end is drawn beside it.

use super::params::REVERSAL;
use crate::catalogue::lathe::figures::{self, BALL, ENDS, MEASURED, RADIUS, Touch};
use crate::catalogue::lathe::params::{DIAMETER, ZERO};
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arc, arrow, circle, dimension, line};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Centre of the end that is drawn beside the part.
const END_VIEW: [f64; 2] = [92.0, 0.0];

/// What is touched, mm.
struct Scene {
    touch: Touch,
    /// Ends of the touched face.
    face: [[f64; 2]; 2],
    /// The zero point that a ZO correction moves.
    zero: [f64; 2],
    /// Ends of the dimension of the setpoint.
    set: [[f64; 2]; 2],
    /// Part and axes.
    ground: Vec<PictureShape>,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let axis = inputs.integer(names::MA).clamp(1, 3);
    let scene = match axis {
        1 => end_face(inputs),
        3 => from_end(inputs),
        _ => from_side(inputs),
    };
    let path = figures::path(inputs);
    let start = scene.touch.start(path);
    let mut shapes = scene.ground;
    shapes.push(line(ShapeKind::Edge, scene.face.to_vec()).of(names::SETVAL));
    shapes.extend(figures::bands(inputs, MEASURED, scene.face, scene.touch.out));
    shapes.push(line(ShapeKind::Axis, vec![scene.touch.before(-14.0), start]).of(names::MA));
    shapes.extend(figures::touch(&scene.touch, path));
    shapes.push(figures::path_dimension(&scene.touch, path));
    if axis != 3 {
        shapes.extend(figures::probe(inputs, start));
    }
    shapes.push(dimension(names::SETVAL, scene.set[0], scene.set[1]));
    if ZERO.holds(inputs) {
        shapes.extend(zero_point(scene.zero, scene.touch.out));
    }
    if REVERSAL.holds(inputs) {
        shapes.extend(reversal(inputs));
    }
    Picture { view: if axis == 3 { View::Section } else { View::Plane }, shapes }
}

/// On which side of the zero point the setpoint lies.
fn side(inputs: &Inputs) -> f64 {
    if inputs.number(names::SETVAL) < 0.0 { -1.0 } else { 1.0 }
}

/// Ends of the dimension of a diameter or radius beside the axis of rotation.
fn across(inputs: &Inputs, side: f64, x: f64) -> [[f64; 2]; 2] {
    let from = if DIAMETER.holds(inputs) { -RADIUS } else { 0.0 };
    [[x, side * from], [x, side * RADIUS]]
}

/// A diameter, touched from outside.
fn from_side(inputs: &Inputs) -> Scene {
    let side = side(inputs);
    let [left, right] = ENDS;
    let mut ground = figures::part().to_vec();
    ground.extend(figures::axis(inputs, 0, [[left - 16.0, 0.0], [right + 12.0, 0.0]]));
    ground.extend(figures::axis(inputs, 1, [[left - 13.0, -12.0], [left - 13.0, 30.0]]));
    Scene {
        touch: Touch { at: [-14.0, side * RADIUS], out: [0.0, side], number: 1 },
        face: [[left, side * RADIUS], [right, side * RADIUS]],
        zero: [right, 0.0],
        set: across(inputs, side, -34.0),
        ground,
    }
}

/// The end face, with the zero point on the side that the sign of the setpoint tells.
fn end_face(inputs: &Inputs) -> Scene {
    let zero = if side(inputs) < 0.0 { 54.0 } else { ENDS[0] };
    let right = ENDS[1];
    let mut ground = figures::part().to_vec();
    ground.extend(figures::axis(inputs, 0, [[-66.0, 0.0], [64.0, 0.0]]));
    let line_of_zero = vec![[zero, RADIUS * 1.6], [zero, -RADIUS * 1.6]];
    ground.push(line(ShapeKind::Axis, line_of_zero).text("0"));
    Scene {
        touch: Touch { at: [right, RADIUS * 0.5], out: [1.0, 0.0], number: 1 },
        face: [[right, -RADIUS], [right, RADIUS]],
        zero: [zero, 0.0],
        set: [[zero, -RADIUS * 1.3], [right, -RADIUS * 1.3]],
        ground,
    }
}

/// The part from its end, touched in the applicate.
fn from_end(inputs: &Inputs) -> Scene {
    let side = side(inputs);
    let mut ground = vec![circle(ShapeKind::Material, [0.0; 2], RADIUS)];
    ground.extend(figures::axis(inputs, 1, [[-30.0, 0.0], [30.0, 0.0]]));
    ground.extend(figures::axis(inputs, 2, [[0.0, -28.0], [0.0, 44.0]]));
    Scene {
        touch: Touch { at: [0.0, side * RADIUS], out: [0.0, side], number: 1 },
        face: [[-BALL * 2.0, side * RADIUS], [BALL * 2.0, side * RADIUS]],
        zero: [0.0; 2],
        set: across(inputs, side, 36.0),
        ground,
    }
}

/// The zero point and the direction in which it is moved.
fn zero_point(zero: [f64; 2], out: [f64; 2]) -> [PictureShape; 2] {
    let tip = [zero[0] + out[0].abs() * 14.0, zero[1] + out[1].abs() * 14.0];
    [circle(ShapeKind::Axis, zero, 2.4).of(names::KNUM), arrow(ShapeKind::Axis, zero, tip, 4.0).of(names::KNUM)]
}

/// The end of the part: both points, the turn between them, and how far it is turned for the first one.
fn reversal(inputs: &Inputs) -> Vec<PictureShape> {
    let centre @ [x, y] = END_VIEW;
    let angle = inputs.number(names::STA1).rem_euclid(360.0);
    let (sin, cos) = (90.0 + angle).to_radians().sin_cos();
    let at = |radius: f64| [x + radius * cos, y + radius * sin];
    let mut shapes = vec![
        circle(ShapeKind::Material, centre, RADIUS),
        line(ShapeKind::Axis, vec![[x, y - 27.0], [x, y + 27.0]]),
        line(ShapeKind::Axis, vec![centre, at(RADIUS)]).of(names::STA1),
        line(ShapeKind::Axis, arc(centre, 9.0, 90.0, 90.0 + angle)).of(names::STA1),
        line(ShapeKind::Label, vec![at(RADIUS * 0.6)]).text(names::STA1).of(names::STA1),
    ];
    for (number, end) in [(1, 1.0), (2, -1.0)] {
        shapes
            .push(circle(ShapeKind::Touch, [x, y + end * RADIUS], BALL * 0.3).text(number.to_string()).of(names::NMSP));
    }
    let turn = arc(centre, RADIUS * 1.2, 110.0, 250.0);
    if let [.., from, tip] = turn[..] {
        shapes.push(arrow(ShapeKind::Axis, from, tip, 4.0).of(names::MVAR));
    }
    shapes.push(line(ShapeKind::Axis, turn).of(names::MVAR));
    let label = line(ShapeKind::Label, vec![[x - RADIUS * 1.45, y]]);
    shapes.push(label.text("180°").of(names::MVAR));
    shapes
}
