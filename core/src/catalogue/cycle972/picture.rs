//! CYCLE972 drawn: the probe between the axes of the plane, abscissa to the right, and the tool (cutting edge position 3)
//! on the side that it touches. Probe and tool stand for any size; short distances are drawn longer than they are.

use super::params::{ABSCISSA, CALIBRATE};
use crate::catalogue::names;
use crate::catalogue::tool_probe::figures::bands;
use crate::check::Inputs;
use crate::form::figures::{circle, dimension, line, polygon, rectangle};
use crate::form::picture::{Picture, PictureShape, ShapeKind, View};

/// Half the edge length of the probe, mm.
const PROBE: f64 = 10.0;
/// Radius of the calibration tool, mm.
const BALL: f64 = 5.0;
/// Radius of the nose of a turning tool, mm.
const NOSE: f64 = 1.5;
/// From the tip to the tool carrier's reference, mm.
const LENGTH: f64 = 26.0;

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let calibrate = CALIBRATE.holds(inputs);
    let radius = if calibrate { BALL } else { NOSE };
    let path = inputs
        .given(names::FA)
        .filter(|path| *path > 0.0)
        .unwrap_or(2.0)
        .clamp(5.0, 12.0);
    let across = usize::from(!ABSCISSA.holds(inputs));
    let mut shapes = vec![
        rectangle(ShapeKind::Material, [0.0; 2], [2.0 * PROBE; 2]),
        line(
            ShapeKind::Axis,
            vec![[-24.0, -12.0], [-24.0, -24.0], [-12.0, -24.0]],
        ),
    ];
    let number = inputs.integer(names::PRNUM).clamp(1, 99) - 1;
    let label = line(ShapeKind::Label, vec![[0.0, -PROBE - 8.0]]);
    shapes.push(label.text(format!("_TP[{number},0…3]")).of(names::PRNUM));
    touch(inputs, across, path, radius, &mut shapes);
    let mut nose = [0.0; 2];
    nose[across] = PROBE + path + radius;
    tool(calibrate, nose, radius, &mut shapes);
    if !calibrate {
        length(across, nose, &mut shapes);
    }
    Picture {
        view: View::Plane,
        shapes,
    }
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
    let way = vec![
        at(across, far, 24.0),
        at(across, far, 0.0),
        at(across, PROBE + radius, 0.0),
    ];
    shapes.extend(bands(inputs, face, at(across, 1.0, 0.0)));
    shapes.extend([
        line(ShapeKind::Edge, face.to_vec()).of(names::MA),
        line(ShapeKind::Path, way).of(names::FA),
        circle(ShapeKind::Touch, at(across, PROBE, 0.0), 0.8).of(names::NMSP),
        dimension(
            names::FA,
            at(across, start - radius, -PROBE - 3.0),
            at(across, PROBE, -PROBE - 3.0),
        ),
    ]);
}

/// A ball on a shank, or an insert; both reach from their nose to the upper right, where the tool carrier is.
fn tool(calibrate: bool, [x, y]: [f64; 2], radius: f64, shapes: &mut Vec<PictureShape>) {
    let outline: &[[f64; 2]] = if calibrate {
        &[
            [1.5, 4.0],
            [4.0, 1.5],
            [LENGTH, 16.0],
            [LENGTH, LENGTH],
            [16.0, LENGTH],
        ]
    } else {
        &[
            [-1.5, 0.3],
            [0.3, -1.5],
            [12.0, 2.0],
            [LENGTH, 14.0],
            [LENGTH, LENGTH],
            [14.0, LENGTH],
            [2.0, 12.0],
        ]
    };
    let body = outline.iter().map(|[dx, dy]| [x + dx, y + dy]).collect();
    shapes.push(polygon(ShapeKind::Probe, body).of(names::MVAR));
    shapes.push(circle(ShapeKind::Probe, [x, y], radius).of(names::MVAR));
}

/// The length that is measured: L2 along the abscissa, L1 along the ordinate.
fn length(across: usize, nose: [f64; 2], shapes: &mut Vec<PictureShape>) {
    let along = nose.get(across).copied().unwrap_or_default() - NOSE;
    let beside = nose.get(1 - across).copied().unwrap_or_default() + LENGTH + 5.0;
    let ends = [along, along + NOSE + LENGTH].map(|end| at(across, end, beside));
    let name = if across == 0 { "L2" } else { "L1" };
    let mark = line(ShapeKind::Dimension, ends.to_vec());
    shapes.push(mark.text(name).of(names::MA));
}
