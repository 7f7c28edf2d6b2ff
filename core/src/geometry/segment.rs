//! Ball against a straight edge (the ball centre against a cylinder about the edge; its ends are corners).

use super::{Path, V3, point};

/// A straight edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// One end.
    pub a: V3,
    /// Other end.
    pub b: V3,
}

impl Segment {
    /// Point of the edge perpendicular below `p`; none beyond the ends.
    pub fn foot(&self, p: &V3) -> Option<V3> {
        let edge = self.b - self.a;
        let part = (p - self.a).dot(&edge) / edge.norm_squared();
        (0.0..=1.0).contains(&part).then(|| self.a + edge * part)
    }

    /// Length after which a ball of this radius begins to touch the edge between its ends.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        let along = (self.b - self.a).normalize();
        let across = |v: V3| v - along * v.dot(&along);
        let reached = point::entering(&across(path.from - self.a), &across(path.direction), radius, path.length)?;
        self.foot(&path.at(reached)).is_some().then_some(reached)
    }
}
