//! G65 P9920 drawn: at the left the disk from above, at the right from the side. Disk and tool stand for any size.

use super::{CALIBRATE, DIAMETER};
use crate::entry::{Inputs, address};
use crate::name::Name;
use crate::picture::figures::{arrow, circle, dimension, line, rectangle, swept};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Radius of the disk, mm.
const DISK: f64 = 13.0;
/// Thickness of the disk, mm.
const THICK: f64 = 7.0;
/// Where the view from the side stands, mm.
const SIDE: f64 = 74.0;
/// Length of the drawn tool, mm.
const TOOL: f64 = 26.0;
/// Height of the end of the tool above the disk at the start, mm.
const START: f64 = 16.0;

/// What is drawn, mm.
struct Scene {
    /// Radius of the tool.
    radius: f64,
    /// Way of the tool axis from the centre where it sinks beside the disk.
    beside: f64,
    /// Distance of the tool axis from the centre above the disk.
    above: f64,
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let given = inputs.given(address::D).filter(|diameter| *diameter > 0.0);
    let radius = given.map_or(6.0, |diameter| (diameter / 2.0).clamp(3.0, 8.0));
    let clearance = inputs.number(address::E).clamp(2.0, 6.0);
    let scene = Scene {
        radius,
        beside: DISK + radius + clearance,
        above: match inputs.variant {
            CALIBRATE => 0.0,
            _ if inputs.given(address::D) == Some(0.0) => 0.0,
            _ => radius,
        },
    };
    let mut shapes = probe();
    from_above(inputs, &scene, &mut shapes);
    from_the_side(inputs, &scene, &mut shapes);
    Picture { view: View::Plane, shapes }
}

/// The disk in both views, with the stem at the side.
fn probe() -> Vec<PictureShape> {
    vec![
        circle(ShapeKind::Material, [0.0; 2], DISK),
        rectangle(ShapeKind::Material, [SIDE, -THICK / 2.0], [2.0 * DISK, THICK]),
        rectangle(ShapeKind::Material, [SIDE, -THICK - 8.0], [6.0, 16.0]),
        line(ShapeKind::Axis, vec![[-DISK * 1.3, 0.0], [DISK * 1.3, 0.0]]),
        line(ShapeKind::Axis, vec![[0.0, -DISK * 1.3], [0.0, DISK * 1.3]]),
    ]
}

/// Where the tool touches the edge of the disk.
fn from_above(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let sides: &[[f64; 2]] = match inputs.variant {
        CALIBRATE => &[[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]],
        DIAMETER => &[[1.0, 0.0]],
        _ => &[],
    };
    for [x, y] in sides {
        let at = |distance: f64| [x * distance, y * distance];
        shapes.push(circle(ShapeKind::Probe, at(scene.beside), scene.radius));
        shapes.push(line(ShapeKind::Path, vec![at(scene.beside), at(DISK + scene.radius)]));
        shapes.push(circle(ShapeKind::Touch, at(DISK), 1.2));
    }
    shapes.push(circle(ShapeKind::Probe, [scene.above, 0.0], scene.radius).of(address::T));
    let (near, far) = (scene.beside - scene.radius, scene.beside + scene.radius);
    match sides.is_empty() {
        true => shapes.push(dimension(
            address::D,
            [scene.above - scene.radius, -DISK * 0.7],
            [scene.above + scene.radius, -DISK * 0.7],
        )),
        false => {
            let below = -scene.radius * 1.5;
            shapes.push(dimension(address::D, [near, below], [far, below]));
            shapes.push(dimension(address::E, [DISK, below * 1.6], [near, below * 1.6]));
        }
    }
    if inputs.given(address::M).is_some_and(|turning| turning != 5.0) {
        let turn = if matches!(inputs.integer(address::M), 3 | 13) { -250.0 } else { 250.0 };
        let [band, arc] = swept(address::M, scene.radius * 1.25, 90.0, 90.0 + turn);
        shapes.extend([band, arc].map(|shape| moved(shape, scene.above)));
    }
}

/// A figure moved along the abscissa.
fn moved(mut shape: PictureShape, by: f64) -> PictureShape {
    for point in &mut shape.points {
        point[0] += by;
    }
    shape
}

/// How deep the tool goes, above the disk and beside it.
fn from_the_side(inputs: &Inputs, scene: &Scene, shapes: &mut Vec<PictureShape>) {
    let x = SIDE + scene.above;
    tool(shapes, x, START, scene.radius, address::T);
    let z = [x - scene.radius - 4.0, START];
    let calibration = inputs.variant == CALIBRATE;
    let depth = if calibration { -THICK * 0.6 } else { -3.0 };
    shapes.push(dimension(address::Z, z, [z[0], depth]));
    let beside = SIDE + scene.beside;
    if calibration {
        tool(shapes, beside, depth, scene.radius, address::D);
        let right = beside + scene.radius + 5.0;
        shapes.push(dimension(address::H, [right, depth + TOOL], [right, depth]));
        let way = vec![[x, START], [beside, START], [beside, depth]];
        shapes.push(line(ShapeKind::Path, way));
        shapes.push(circle(ShapeKind::Touch, [SIDE + DISK, depth], 1.2));
    } else {
        shapes.push(arrow(ShapeKind::Path, [x, START], [x, 0.0], 2.5));
        shapes.push(circle(ShapeKind::Touch, [x, 0.0], 1.2));
    }
    if inputs.variant == DIAMETER {
        let lift = inputs.number(address::K).clamp(3.0, THICK * 0.9);
        tool(shapes, beside, -lift, scene.radius, address::D);
        let way = vec![[x, 0.0], [x, lift], [beside, lift], [beside, -lift]];
        shapes.push(line(ShapeKind::Path, way));
        let right = beside + scene.radius + 5.0;
        shapes.push(dimension(address::K, [right, lift], [right, 0.0]));
        shapes.push(dimension(address::K, [right, 0.0], [right, -lift]));
        shapes.push(circle(ShapeKind::Touch, [SIDE + DISK, -lift * 0.5], 1.2));
    }
}

/// A tool from the side with its end at this height.
fn tool(shapes: &mut Vec<PictureShape>, x: f64, end: f64, radius: f64, field: Name) {
    let size = [2.0 * radius, TOOL];
    shapes.push(rectangle(ShapeKind::Probe, [x, end + TOOL / 2.0], size).of(field));
}
