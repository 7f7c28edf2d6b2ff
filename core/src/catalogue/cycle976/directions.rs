//! In which directions a hole is touched, and how the axes of calibration lie (B:5202-5210, B:5316-5326).

use super::params::{ANGLE, FOUR, ONE};
use crate::catalogue::prelude::*;

/// One direction: an axis of calibration (0 the first, 1 the second) and +1 or -1 along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Axis of calibration.
    pub axis: usize,
    /// +1 or -1.
    pub sign: f64,
}

impl Direction {
    /// Angle from the first axis of calibration.
    pub fn degrees(self) -> Degrees {
        Degrees(90.0 * self.axis as f64 + if self.sign < 0.0 { 180.0 } else { 0.0 })
    }
}

/// In their order: plus before minus, abscissa before ordinate.
pub fn directions(inputs: &Inputs) -> Vec<Direction> {
    let axes: &[usize] = match (FOUR.holds(inputs), inputs.integer(names::MA)) {
        (true, _) => &[0, 1],
        (false, 2) => &[1],
        (false, _) => &[0],
    };
    let signs: &[f64] = match (ONE.holds(inputs), inputs.integer(names::MD)) {
        (false, _) => &[1.0, -1.0],
        (true, 1) => &[-1.0],
        (true, _) => &[1.0],
    };
    axes.iter().flat_map(|axis| signs.iter().map(move |sign| Direction { axis: *axis, sign: *sign })).collect()
}

/// Angle of the first axis of calibration from the abscissa: `_STA1`, or 0 where it is paraxial.
pub fn angle(inputs: &Inputs) -> Degrees {
    if ANGLE.holds(inputs) { inputs.degrees(names::STA1) } else { Degrees(0.0) }
}

/// A vector from the axes of calibration, which are turned by `angle`, in abscissa and ordinate.
pub fn in_plane([first, second]: [f64; 2], angle: Degrees) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [first * cosine - second * sine, first * sine + second * cosine]
}

/// A vector from abscissa and ordinate in the axes of calibration.
pub fn turned(vector: [f64; 2], angle: Degrees) -> [f64; 2] {
    in_plane(vector, -angle)
}
