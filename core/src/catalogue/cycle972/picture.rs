//! CYCLE972 drawn: the probe between the axes of the plane, abscissa to the right, and the tool on the side that it
//! touches, as its cutting edge position says; where none is in use, one with position 3. Probe and tool stand for any
//! size; short distances are drawn longer than they are.

use super::params::{ABSCISSA, CALIBRATE};
use crate::catalogue::tool_probe::figures;
use crate::catalogue::tool_probe::figures::{LENGTH, bands};
use crate::entry::{Inputs, names};
use crate::picture::figures::{circle, dimension, line, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Half the edge length of the probe, mm.
const PROBE: f64 = 10.0;
/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let calibrate = CALIBRATE.holds(inputs);
    let radius = figures::nose_radius(calibrate);
    let path = inputs.given(names::FA).filter(|path| *path > 0.0).unwrap_or(2.0).clamp(5.0, 12.0);
    let across = usize::from(!ABSCISSA.holds(inputs));
    let sides = figures::sides(inputs);
    let number = inputs.integer(names::PRNUM).clamp(1, 99) - 1;
    let label = line(ShapeKind::Label, vec![[0.0, -PROBE - 8.0]]);
    let mut shapes = vec![label.text(format!("_TP[{number},0…3]")).of(names::PRNUM)];
    touch(inputs, across, path, radius, &mut shapes);
    let mut nose = [0.0; 2];
    nose[across] = PROBE + path + radius;
    shapes.extend(figures::nosed(inputs, calibrate, nose, [1.0; 2]));
    if !calibrate {
        shapes.push(length(across, nose, radius));
    }
    figures::mirror(&mut shapes, sides);
    let probe = rectangle(ShapeKind::Material, [0.0; 2], [2.0 * PROBE; 2]);
    shapes.splice(0..0, [probe, line(ShapeKind::Axis, axes(sides))]);
    Picture { view: View::Plane, shapes }
}

/// The axes of the machine, clear of the tool.
fn axes(sides: [f64; 2]) -> Vec<[f64; 2]> {
    let x = if sides == [-1.0; 2] { 14.0 } else { -24.0 };
    vec![[x, -12.0], [x, -24.0], [x + 12.0, -24.0]]
}

/// A point given along the measuring axis and across it.
fn at(across: usize, along: f64, beside: f64) -> [f64; 2] {
    let mut point = [beside; 2];
    point[across] = along;
    point
}

/// The touched side, the way to it, and its limits. The other axis is travelled first.
fn touch(inputs: &Inputs, across: usize, path: f64, radius: f64, shapes: &mut Vec<PictureShape>) {
    let start = PROBE + path + radius;
    let face = [at(across, PROBE, -PROBE), at(across, PROBE, PROBE)];
    let far = start + 14.0;
    let way = vec![at(across, far, 24.0), at(across, far, 0.0), at(across, PROBE + radius, 0.0)];
    shapes.extend(bands(inputs, face, at(across, 1.0, 0.0)));
    shapes.extend([
        line(ShapeKind::Edge, face.to_vec()).of(names::MA),
        line(ShapeKind::Path, way).of(names::FA),
        circle(ShapeKind::Touch, at(across, PROBE, 0.0), 0.8).of(names::NMSP),
        dimension(names::FA, at(across, start - radius, -PROBE - 3.0), at(across, PROBE, -PROBE - 3.0)),
    ]);
}

/// The length that is measured: L2 along the abscissa, L1 along the ordinate.
fn length(across: usize, nose: [f64; 2], radius: f64) -> PictureShape {
    let along = nose[across] - radius;
    let beside = nose[1 - across] + LENGTH + 5.0;
    let ends = [along, along + radius + LENGTH].map(|end| at(across, end, beside));
    let name = if across == 0 { "L2" } else { "L1" };
    let mark = line(ShapeKind::Dimension, ends.to_vec());
    mark.text(name).of(names::MA)
}
