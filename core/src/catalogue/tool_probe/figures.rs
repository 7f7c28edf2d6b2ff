//! What the pictures of the cycles at a tool probe share. A turning tool is drawn as with cutting edge position 3,
//! which touches the plus sides; at the end the figures are mirrored to the position of the tool in use.

use crate::entry::stage::Seen;
use crate::entry::{Inputs, names};
use crate::name::Name;
use crate::picture::figures::{circle, polygon};
use crate::picture::{PictureShape, ShapeKind};

/// Half the edge length of a drawn probe, mm.
pub const HALF: f64 = 10.0;
/// Its data: a cube about the zero point, touched on all sides; how deep a tool is measured beside it.
pub const CUBE: [(&str, f64); 18] = [
    ("_TP[0,0]", HALF),
    ("_TP[0,1]", -HALF),
    ("_TP[0,2]", HALF),
    ("_TP[0,3]", -HALF),
    ("_TP[0,4]", HALF),
    ("_TP[0,5]", -HALF),
    ("_TP[0,6]", 2.0 * HALF),
    ("_TP[0,7]", 333.0),
    ("_TP[0,9]", 4.0),
    ("_TPW[0,0]", HALF),
    ("_TPW[0,1]", -HALF),
    ("_TPW[0,2]", HALF),
    ("_TPW[0,3]", -HALF),
    ("_TPW[0,4]", HALF),
    ("_TPW[0,5]", -HALF),
    ("_TPW[0,6]", 2.0 * HALF),
    ("_TPW[0,7]", 333.0),
    ("_TPW[0,9]", 4.0),
];

/// Index of the data of the probe.
pub fn number(inputs: &Inputs) -> i64 {
    inputs.integer(names::PRNUM).clamp(1, 99) - 1
}

/// Limits of the difference, and half the widths of their bands, mm.
const WIDTHS: [(Name, f64); 3] = [(names::TSA, 3.0), (names::TDIF, 1.8), (names::TZL, 0.8)];

/// The limits of the difference that the call uses about the touched sides, wide ones first, wider than they are.
pub fn limits(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let used = WIDTHS.into_iter().filter(|(name, _)| inputs.uses(*name));
    let used: Vec<_> = used.map(|(name, width)| (name, -width, width)).collect();
    seen.bands(ShapeKind::Tolerance, &used)
}

/// The limits of the difference that the call uses, as bands on both sides of a touched face, wide ones first. `out`:
/// direction in which the face is left, of length 1. Much wider than they are, so that they can be seen.
pub fn bands(inputs: &Inputs, face: [[f64; 2]; 2], out: [f64; 2]) -> Vec<PictureShape> {
    let band = |(name, width): (Name, f64)| {
        let [a, b] = face;
        let beside = |[x, y]: [f64; 2], side: f64| [x + side * width * out[0], y + side * width * out[1]];
        let corners = vec![beside(a, -1.0), beside(b, -1.0), beside(b, 1.0), beside(a, 1.0)];
        polygon(ShapeKind::Tolerance, corners).of(name)
    };
    let used = WIDTHS.into_iter().filter(|(name, _)| inputs.uses(*name));
    used.map(band).collect()
}

/// Radius of the calibration tool, mm.
const BALL: f64 = 5.0;
/// Radius of the nose of a turning tool, mm.
const NOSE: f64 = 1.5;
/// From the nose to the tool carrier, mm.
pub const LENGTH: f64 = 30.0;

/// An outline from the centre of the nose, mm.
type Outline = &'static [[f64; 2]];

const BALL_SHANK: Outline = &[[1.5, 4.0], [4.0, 1.5], [LENGTH, 16.0], [LENGTH, LENGTH], [16.0, LENGTH]];
/// Cuts along both axes.
const CORNERED: Outline =
    &[[-1.5, 0.3], [0.3, -1.5], [12.0, 2.0], [LENGTH, 14.0], [LENGTH, LENGTH], [14.0, LENGTH], [2.0, 12.0]];
/// Lies along the abscissa, and has no tip across it.
const POINTED: Outline =
    &[[0.3, -1.5], [12.0, -5.0], [16.0, -9.0], [LENGTH, -9.0], [LENGTH, 9.0], [16.0, 9.0], [12.0, 5.0], [0.3, 1.5]];

/// Radius of the nose of the calibration tool or of a turning tool, mm.
pub fn nose_radius(calibrates: bool) -> f64 {
    if calibrates { BALL } else { NOSE }
}

/// The calibration tool or a turning tool, `centre`: of its nose; `away`: 1, or -1 in an axis in which its shank is
/// bent to the other side.
pub fn nosed(inputs: &Inputs, calibrates: bool, centre: [f64; 2], away: [f64; 2]) -> [PictureShape; 2] {
    let outline = match inputs.nose {
        _ if calibrates => BALL_SHANK,
        Some([abscissa, ordinate]) if abscissa == 0.0 || ordinate == 0.0 => POINTED,
        _ => CORNERED,
    };
    let across = inputs.nose.is_some_and(|[abscissa, _]| abscissa == 0.0);
    let place = |[x, y]: &[f64; 2]| {
        let point = if across { [*y, *x] } else { [*x, *y] };
        [0, 1].map(|axis| centre[axis] + away[axis] * point[axis])
    };
    [
        polygon(ShapeKind::Probe, outline.iter().map(place).collect()).of(names::MVAR),
        circle(ShapeKind::Probe, centre, nose_radius(calibrates)).of(names::MVAR),
    ]
}

/// 1 in an axis in which the turning tool in use touches the plus side, as one with cutting edge position 3 does; else
/// -1.
pub fn sides(inputs: &Inputs) -> [f64; 2] {
    let nose = inputs.nose.unwrap_or([-1.0; 2]);
    nose.map(|side| if side > 0.0 { -1.0 } else { 1.0 })
}

/// Lays figures so that they show the tool in use. `sides`: see [`sides`].
pub fn mirror(shapes: &mut [PictureShape], sides: [f64; 2]) {
    let turn = |point: &mut [f64; 2]| {
        let [x, y] = *point;
        *point = [x * sides[0], y * sides[1]];
    };
    for shape in shapes {
        shape.points.iter_mut().for_each(turn);
        if let Some((centre, _)) = &mut shape.circle {
            turn(centre);
        }
    }
}
