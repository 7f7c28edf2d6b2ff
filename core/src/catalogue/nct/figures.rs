//! What the pictures of the macros share. Clearance and overtravel are drawn longer than they are, limits wider.

use crate::catalogue::prelude::*;

/// Shortest and longest clearance or overtravel that is drawn, mm.
const SHORT: [f64; 2] = [10.0, 20.0];

/// The call with its short lengths so long that they can be seen.
pub fn stage(inputs: &Inputs, look: Look, edges: &'static [Name]) -> Staging {
    let fields = Fields { edges, ..Fields::MACRO };
    Staging::new(look, fields).short(inputs, address::R, SHORT).short(inputs, address::Q, SHORT)
}

/// The axes through the middle of what is touched.
pub fn axes(above: &Seen) -> Vec<PictureShape> {
    above.axes(above.middle(), [None; 2]).to_vec()
}

/// Overtravel, clearance, tolerance and upper limit, as far as they are given.
pub fn limits(inputs: &Inputs, seen: &Seen) -> Vec<PictureShape> {
    let mut shapes = Vec::new();
    if let Some(past) = inputs.any(address::Q).map(|past| past.abs().clamp(SHORT[0], SHORT[1])) {
        shapes.extend(seen.bands(ShapeKind::Zone, &[(address::Q, -past, 0.0)]));
        shapes.extend(seen.behind(address::Q, 0, past));
    }
    if inputs.any(address::R).is_some() && seen.outside() {
        shapes.extend(seen.path(address::R, 0, 2.2));
    }
    let limits = [(address::U, 3.2), (address::H, 1.6)].into_iter().filter(|(name, _)| inputs.any(*name).is_some());
    let limits: Vec<_> = limits.map(|(name, half)| (name, -half, half)).collect();
    shapes.extend(seen.bands(ShapeKind::Tolerance, &limits));
    shapes
}
