//! What the pictures of the cycles at a tool probe share.

use crate::catalogue::names;
use crate::check::Inputs;
use crate::form::figures::polygon;
use crate::form::picture::{PictureShape, ShapeKind};

/// The limits of the difference that the call uses, as bands on both sides of a touched face, wide ones first. `out`:
/// direction in which the face is left, of length 1. Much wider than they are, so that they can be seen.
pub fn bands(inputs: &Inputs, face: [[f64; 2]; 2], out: [f64; 2]) -> Vec<PictureShape> {
    let widths = [(names::TSA, 3.0), (names::TDIF, 1.8), (names::TZL, 0.8)];
    let band = |(name, width): (&'static str, f64)| {
        let [a, b] = face;
        let beside =
            |[x, y]: [f64; 2], side: f64| [x + side * width * out[0], y + side * width * out[1]];
        let corners = vec![
            beside(a, -1.0),
            beside(b, -1.0),
            beside(b, 1.0),
            beside(a, 1.0),
        ];
        polygon(ShapeKind::Tolerance, corners).of(name)
    };
    let used = widths.into_iter().filter(|(name, _)| inputs.uses(name));
    used.map(band).collect()
}
