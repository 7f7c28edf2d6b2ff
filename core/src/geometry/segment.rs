//! Ball against a straight edge (the ball centre against a cylinder about the edge; its ends are corners).

use super::{Path, V3, roots};

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
        let way = across(path.direction);
        let speed = way.norm_squared();
        if speed < 1e-24 {
            return None;
        }
        let closest = -across(path.from - self.a).dot(&way) / speed;
        let gap = across(path.at(closest) - self.a);
        let entering = *roots::quadratic(speed, 0.0, gap.norm_squared() - radius * radius).first()? + closest;
        let reached = entering > 0.0 && entering <= path.length;
        (reached && self.foot(&path.at(entering)).is_some()).then_some(entering)
    }
}
