//! What the pictures of the cycles at a tool probe share.

use crate::catalogue::prelude::*;

/// Half the edge length of a drawn probe, mm.
pub const HALF: f64 = 10.0;
/// Data of a cube about the zero point, touched on all sides; how deep a tool is measured beside it.
const CUBE: [(usize, f64); 9] =
    [(0, HALF), (1, -HALF), (2, HALF), (3, -HALF), (4, HALF), (5, -HALF), (6, 2.0 * HALF), (7, 333.0), (9, 4.0)];

/// Data of the cube by their names, of the machine and of the workpiece.
pub fn cube() -> Vec<(String, f64)> {
    let of = |array: &'static str| CUBE.map(|(index, value)| (format!("{array}[0,{index}]"), value));
    [of("_TP"), of("_TPW")].concat()
}

/// The data of the probe that the call names; `last`: index of the last one that counts.
pub fn label(inputs: &Inputs, at: [f64; 2], last: usize) -> PictureShape {
    let number = inputs.integer(names::PRNUM).clamp(1, 99) - 1;
    let array = inputs.cycle.purpose.probe_array(inputs);
    line(ShapeKind::Label, vec![at]).text(format!("{array}[{number},0…{last}]")).of(names::PRNUM)
}

/// Limits of the difference with the ends of their bands, mm.
const BANDS: [(Name, f64, f64); 3] = [(names::TSA, -3.0, 3.0), (names::TDIF, -1.8, 1.8), (names::TZL, -0.8, 0.8)];

/// The limits of the difference that the call uses about the touched sides, wide ones first, wider than they are.
pub fn limits(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let used: Vec<_> = BANDS.into_iter().filter(|(name, ..)| inputs.uses(*name)).collect();
    seen.bands(ShapeKind::Tolerance, &used)
}
