//! The rectangle from above with its lines, and below it one step over the surface from the side. Sizes are drawn in
//! proportion where they can be seen, never as they are.

use super::addresses::{letter, spacing};
use crate::catalogue::nct::axis_name;
use crate::entry::{Inputs, address};
use crate::name::Name;
use crate::picture::figures::{circle, dimension, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Longer side of the drawn rectangle, mm.
const LONG: f64 = 64.0;
/// Shortest side.
const SHORT: f64 = 24.0;
/// Drawn lines.
const LINES: usize = 6;
/// Height of the drawn surface in the section below the rectangle.
const GROUND: f64 = -52.0;
/// Ball radius.
const BALL: f64 = 3.0;

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    let mut shapes = above(inputs);
    shapes.extend(beside(inputs));
    Picture { view: View::Plane, shapes }
}

/// Rectangle from the start, which is the zero here, with the way of the stylus.
fn above(inputs: &Inputs) -> Vec<PictureShape> {
    let [first, second, _] = inputs.plane.axes();
    let ends = [first, second].map(|axis| inputs.number(axis_name(axis)).abs().max(1e-6));
    let longest = ends[0].max(ends[1]);
    let [width, height] = ends.map(|end| (end / longest * LONG).max(SHORT));
    let (step_axis, along_first) = match spacing(inputs) {
        Some((_, along, across)) => (across, along == first),
        None => (second, true),
    };
    let swap = |[u, v]: [f64; 2]| if along_first { [u, v] } else { [v, u] };
    let (length, across) = if along_first { (width, height) } else { (height, width) };
    let apart = across / (LINES - 1) as f64;
    let way = (0..LINES).flat_map(|number| {
        let at = number as f64 * apart;
        let ends = if number % 2 == 0 { [0.0, length] } else { [length, 0.0] };
        ends.map(|u| swap([u, at]))
    });
    let outline = vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
    vec![
        polygon(ShapeKind::Material, outline.clone()),
        polygon(ShapeKind::Edge, outline),
        line(ShapeKind::Path, way.collect()),
        circle(ShapeKind::Probe, [0.0; 2], BALL),
        dimension(axis_name(first), [0.0, -12.0], [width, -12.0]),
        dimension(axis_name(second), [-28.0, 0.0], [-28.0, height]),
        dimension(letter(step_axis), swap([length + 8.0, 0.0]), swap([length + 8.0, apart])),
    ]
}

/// A step: up by Q, on by R, down; and how deep is looked for the surface.
fn beside(inputs: &Inputs) -> Vec<PictureShape> {
    let [.., axial] = inputs.plane.axes();
    let drawn = |name: Name| inputs.given(name).unwrap_or(1.0).abs();
    let (raster, retract) = (drawn(address::R), drawn(address::Q));
    let larger = raster.max(retract).max(1e-9);
    let [raster, retract] = [raster, retract].map(|size| (size / larger * 14.0).max(6.0));
    let surface = |x: f64| GROUND + 4.0 * (x / 14.0).sin();
    let deepest = GROUND - 14.0;
    let ground = (0..=32).map(|part| f64::from(part) * LONG / 32.0);
    let mut material: Vec<[f64; 2]> = ground.map(|x| [x, surface(x)]).collect();
    let edge = material.clone();
    material.extend([[LONG, deepest - 4.0], [0.0, deepest - 4.0]]);
    let (from, to) = (18.0, 18.0 + raster);
    let above = surface(from) + BALL;
    let top = above + retract;
    let step = vec![[from, above], [from, top], [to, top], [to, surface(to) + BALL]];
    vec![
        polygon(ShapeKind::Cut, material),
        line(ShapeKind::Edge, edge),
        line(ShapeKind::Axis, vec![[-4.0, deepest], [LONG + 4.0, deepest]]).of(axis_name(axial)),
        dimension(axis_name(axial), [LONG + 6.0, GROUND + 18.0], [LONG + 6.0, deepest]),
        circle(ShapeKind::Probe, [from, above], BALL),
        circle(ShapeKind::Touch, [from, surface(from)], BALL * 0.3),
        circle(ShapeKind::Touch, [to, surface(to)], BALL * 0.3),
        line(ShapeKind::Path, step).of(address::F),
        dimension(address::Q, [from - 7.0, above], [from - 7.0, top]),
        dimension(address::R, [from, top + 5.0], [to, top + 5.0]),
    ]
}
