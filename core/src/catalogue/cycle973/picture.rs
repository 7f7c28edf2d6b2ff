//! CYCLE973 drawn: the surface, or the section through the reference groove, touched along the measuring axis; beside
//! the groove the stylus with what is determined about it. The groove is drawn for the cutting edge position of the
//! probe in use: of 7 the walls lie in the ordinate, of 8 in the abscissa (B:13473-13482).

use super::params::{BALL as DIAMETER, SKEW, SURFACE, TWO};
use crate::catalogue::lathe::figures::{self, BALL, Bands, Touch};
use crate::catalogue::lathe::params::DIAMETER as ACROSS;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arrow, circle, dimension, line, polygon, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Bands of the trigger value.
const BANDS: Bands = &[(names::TSA, -2.6, 2.6), (names::TZL, -1.2, 1.2)];
/// Half the width of the drawn groove, mm.
const HALF: f64 = 16.0;
/// Where its base and its opening lie, and how deep the ball goes for the walls, mm.
const BASE: f64 = -10.0;
const OPEN: f64 = 26.0;
const DEEP: f64 = 8.0;
/// Half the length of the drawn surface, mm.
const FACE: f64 = 30.0;

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    if SURFACE.holds(inputs) {
        return surface(inputs);
    }
    let mut shapes = groove(inputs);
    shapes.extend(stylus(inputs));
    Picture { view: View::Plane, shapes }
}

/// Direction of touching: plus 1, minus -1.
fn direction(inputs: &Inputs) -> f64 {
    if inputs.given(names::MD) == Some(0.0) { 1.0 } else { -1.0 }
}

/// Way and arrow of one touch, with its ball.
fn touched(touch: &Touch, path: f64) -> Vec<PictureShape> {
    let mut shapes = figures::touch(touch, path).to_vec();
    let (start, end) = (touch.start(path), touch.before(BALL));
    shapes.push(arrow(ShapeKind::Path, start, end, 3.0).of(names::MD));
    shapes
}

/// A surface across the measuring axis.
fn surface(inputs: &Inputs) -> Picture {
    let axis = inputs.integer(names::MA).clamp(1, 3);
    let along: [f64; 2] = if axis == 1 { [1.0, 0.0] } else { [0.0, 1.0] };
    let away = -direction(inputs);
    let touch = Touch { at: [0.0; 2], out: along.map(|part| part * away), number: 1 };
    let path = figures::path(inputs);
    let place =
        |forward: f64, beside: f64| [along[0] * forward + along[1] * beside, along[1] * forward + along[0] * beside];
    let size = place(24.0, 2.0 * FACE);
    let block = rectangle(ShapeKind::Material, place(-away * 12.0, 0.0), size);
    let face = [place(0.0, -FACE), place(0.0, FACE)];
    let mut shapes = vec![block, line(ShapeKind::Edge, face.to_vec()).of(names::SETVAL)];
    shapes.extend(figures::bands(inputs, BANDS, face, touch.out));
    let ends = [place(-48.0, 0.0), place(48.0, 0.0)];
    let [measured, letter] = figures::axis(inputs, axis as usize - 1, ends);
    shapes.extend([measured.of(names::MA), letter]);
    shapes.extend(set_position(inputs, place));
    shapes.extend(touched(&touch, path));
    shapes.push(figures::path_dimension(&touch, path));
    if axis != 3 {
        shapes.extend(figures::probe(inputs, touch.start(path)));
    }
    Picture { view: if axis == 3 { View::Section } else { View::Plane }, shapes }
}

/// The zero point on its side of the surface, and the distance from it; a diameter counts from beyond it.
fn set_position(inputs: &Inputs, place: impl Fn(f64, f64) -> [f64; 2]) -> [PictureShape; 2] {
    let side = if inputs.number(names::SETVAL) < 0.0 { 1.0 } else { -1.0 };
    let zero = side * 40.0;
    let from = if ACROSS.holds(inputs) { 2.0 * zero } else { zero };
    let line_of_zero = vec![place(zero, FACE), place(zero, -FACE * 1.3)];
    [
        line(ShapeKind::Axis, line_of_zero).text("0"),
        dimension(names::SETVAL, place(from, -FACE * 1.15), place(0.0, -FACE * 1.15)),
    ]
}

/// Whether the groove is that of cutting edge position 8: the axis of both walls says it, else the probe in use.
fn lies_along_ordinate(inputs: &Inputs) -> bool {
    if TWO.holds(inputs) {
        return inputs.integer(names::MA) == 1;
    }
    inputs.body.is_some_and(|[abscissa, _]| abscissa == 0.0)
}

/// The groove with its touches.
fn groove(inputs: &Inputs) -> Vec<PictureShape> {
    let two = TWO.holds(inputs);
    let turned = lies_along_ordinate(inputs);
    let walls = two || inputs.integer(names::MA) == if turned { 1 } else { 2 };
    let path = figures::path(inputs).min(8.0);
    let touches = touches(inputs, walls, two);
    let mut shapes = walls_and_base(inputs);
    shapes.extend(axes(inputs, turned));
    for touch in &touches {
        let face = if walls { [[BASE, touch.at[1]], [OPEN, touch.at[1]]] } else { [[BASE, -HALF], [BASE, HALF]] };
        shapes.extend(figures::bands(inputs, BANDS, face, touch.out));
        shapes.extend(touched(touch, path));
    }
    if let Some(first) = touches.first() {
        let start = first.start(path);
        shapes.push(figures::path_dimension(first, path));
        shapes.extend(figures::stylus(start, [1.0, 0.0]));
        let way_in = vec![[58.0, 0.0], [start[0], 0.0], start];
        shapes.push(line(ShapeKind::Path, way_in).of(names::MVAR));
    }
    let tip = if turned { "SL 8" } else { "SL 7" };
    let label = line(ShapeKind::Label, vec![[50.0, 16.0]]);
    shapes.push(label.text(tip).of(names::PRNUM));
    if turned {
        shapes.iter_mut().for_each(exchange_axes);
    }
    shapes
}

/// What is touched: both walls, plus first, or one of them; or the base.
fn touches(inputs: &Inputs, walls: bool, two: bool) -> Vec<Touch> {
    let wall = |number, side: f64| Touch { at: [DEEP, side * HALF], out: [0.0, -side], number };
    match (walls, two) {
        (true, true) => vec![wall(1, 1.0), wall(2, -1.0)],
        (true, false) => vec![wall(1, direction(inputs))],
        (false, _) => vec![Touch { at: [BASE, 0.0], out: [1.0, 0.0], number: 1 }],
    }
}

/// The block that is cut, and the faces that `_KB` describes.
fn walls_and_base(inputs: &Inputs) -> Vec<PictureShape> {
    let faces = vec![[OPEN, HALF], [BASE, HALF], [BASE, -HALF], [OPEN, -HALF]];
    let mut block = vec![[OPEN, -34.0], [-32.0, -34.0], [-32.0, 34.0], [OPEN, 34.0]];
    block.extend(&faces);
    let pair = (inputs.number(names::CALNUM) - 1.0).max(0.0);
    let label = line(ShapeKind::Label, vec![[-21.0, 24.0]]);
    vec![
        polygon(ShapeKind::Cut, block),
        line(ShapeKind::Edge, faces).of(names::CALNUM),
        label.text(format!("_KB[{pair}]")).of(names::CALNUM),
    ]
}

/// Both axes of the plane; that of the measurement belongs to its field.
fn axes(inputs: &Inputs, turned: bool) -> Vec<PictureShape> {
    let lines = [[[-42.0, 0.0], [62.0, 0.0]], [[DEEP, -42.0], [DEEP, 42.0]]];
    let mut shapes = Vec::new();
    for (index, ends) in lines.into_iter().enumerate() {
        let axis = if turned { 1 - index } else { index };
        let [mut drawn, letter] = figures::axis(inputs, axis, ends);
        if inputs.integer(names::MA) == axis as i64 + 1 {
            drawn = drawn.of(names::MA);
        }
        shapes.extend([drawn, letter]);
    }
    shapes
}

/// Lays a figure so that the walls of the groove lie in the abscissa.
fn exchange_axes(shape: &mut PictureShape) {
    for [x, y] in &mut shape.points {
        std::mem::swap(x, y);
    }
    if let Some(([x, y], _)) = &mut shape.circle {
        std::mem::swap(x, y);
    }
}

/// The stylus by itself, where something is determined about it: ball diameter, and the place of the ball beside the
/// middle of the probe.
fn stylus(inputs: &Inputs) -> Vec<PictureShape> {
    let (skewed, diameter) = (SKEW.holds(inputs), DIAMETER.holds(inputs));
    if !skewed && !diameter {
        return Vec::new();
    }
    let (middle, radius) = (104.0, 8.0);
    let centre = [middle + if skewed { 7.0 } else { 0.0 }, -16.0];
    let mut shapes = vec![
        rectangle(ShapeKind::Probe, [middle, 30.0], [22.0, 12.0]).of(names::PRNUM),
        line(ShapeKind::Probe, vec![[middle, 24.0], centre]).of(names::PRNUM),
        circle(ShapeKind::Probe, centre, radius).of(names::PRNUM),
        line(ShapeKind::Axis, vec![[middle, 40.0], [middle, -38.0]]).of(names::MVAR),
    ];
    if skewed {
        let ends = vec![[middle, -34.0], [centre[0], -34.0]];
        shapes.push(line(ShapeKind::Dimension, ends).text("s").of(names::MVAR));
        let drop = vec![centre, [centre[0], -38.0]];
        shapes.push(line(ShapeKind::Axis, drop).of(names::MVAR));
    }
    if diameter {
        let ends = vec![[centre[0] - radius, -3.0], [centre[0] + radius, -3.0]];
        shapes.push(line(ShapeKind::Dimension, ends).text("Ø").of(names::MVAR));
    }
    shapes
}
