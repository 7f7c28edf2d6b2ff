//! Both triangles, seen from above at a slant: X to the right, Y upwards, Z half as long to the upper right.

use super::params::{LIMIT, MEASURED, Names, SET, TARGET};
use crate::catalogue::prelude::*;
use crate::picture::figures::polygon;

/// How far a length along Z leads to the right and up.
const SLANT: f64 = 0.35;

/// The set triangle in full, the measured one beside it; each coordinate is one leg of the way from the zero point.
pub fn picture(inputs: &Inputs) -> Picture {
    let (set, measured) = (corners(inputs, SET), corners(inputs, MEASURED));
    let size = set.iter().chain(&measured).flatten().fold(1.0_f64, |most, value| most.max(value.abs()));
    let mut shapes = vec![
        polygon(ShapeKind::Material, set.map(seen).to_vec()).of(TARGET),
        polygon(ShapeKind::Path, measured.map(seen).to_vec()).of(LIMIT),
        circle(ShapeKind::Axis, [0.0; 2], size / 50.0),
    ];
    for (names, corners, kind) in [(SET, set, ShapeKind::Probe), (MEASURED, measured, ShapeKind::Touch)] {
        for (names, corner) in names.into_iter().zip(corners) {
            shapes.extend(legs(names, corner));
            shapes.push(circle(kind, seen(corner), size / 50.0));
        }
    }
    for (number, corner) in ["1", "2", "3"].into_iter().zip(set) {
        let [x, y] = seen(corner);
        let beside = [x - size / 15.0, y + size / 15.0];
        shapes.push(line(ShapeKind::Label, vec![beside]).text(number));
    }
    Picture { view: View::Plane, shapes }
}

fn corners(inputs: &Inputs, names: Names) -> [[f64; 3]; 3] {
    names.map(|point| point.map(|name| inputs.number(name)))
}

fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    [x + SLANT * z, y + SLANT * z]
}

/// The way from the zero point along X, then Y, then Z, a leg each.
fn legs(names: [Name; 3], [x, y, z]: [f64; 3]) -> [PictureShape; 3] {
    let places = [[0.0; 3], [x, 0.0, 0.0], [x, y, 0.0], [x, y, z]].map(seen);
    [0, 1, 2].map(|leg| line(ShapeKind::Axis, vec![places[leg], places[leg + 1]]).of(names[leg]))
}
