//! Bore or boss from above, with clearance, overtravel and tolerance.

use crate::catalogue::nct::figures::{address, limits, stage as macro_stage};
use crate::entry::stage::{Look, Seen, Staging};
use crate::entry::{Inputs, address};
use crate::picture::PictureShape;

/// Depth at which a boss is measured, mm.
const DEPTH: f64 = -20.0;

/// The element in the size of the picture.
pub fn stage(inputs: &Inputs) -> Staging {
    macro_stage(inputs, Look::ABOVE, &[address::D]).sized(inputs, &[address::D]).with(address(inputs, 2), DEPTH)
}

/// Size and limits.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above] = looks else {
        return Vec::new();
    };
    let mut shapes = above.axes(above.middle(), [None; 2]).to_vec();
    shapes.extend(limits(inputs, above));
    shapes.push(above.size(address::D, 0));
    shapes
}
