//! A straight path.

use super::V3;
use nalgebra::IsometryMatrix3;

/// Straight way of the ball centre, by length in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Start.
    pub from: V3,
    /// Unit direction; zero for a path without length.
    pub direction: V3,
    /// Length, mm.
    pub length: f64,
}

impl Path {
    /// From one point to another.
    pub fn new(from: V3, to: V3) -> Path {
        let way = to - from;
        let length = way.norm();
        let direction = if length > 0.0 { way / length } else { V3::zeros() };
        Path { from, direction, length }
    }

    /// As seen from a system that stands at `place`.
    pub fn seen(&self, place: &IsometryMatrix3<f64>) -> Path {
        let from = place.inverse_transform_point(&self.from.into()).coords;
        Path { from, direction: place.rotation.inverse() * self.direction, ..*self }
    }

    /// Point after `s` mm.
    pub fn at(&self, s: f64) -> V3 {
        self.from + self.direction * s
    }
}
