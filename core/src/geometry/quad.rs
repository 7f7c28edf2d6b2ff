//! Ball against a flat face: a convex quadrangle, whole or trimmed by a round curve about the Z axis.

use super::{Lobes, Path, V3};

/// Round curves about the Z axis that leave a part of a face; without any it is whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trim {
    /// What lies within it is no face.
    pub inner: Option<Lobes>,
    /// What lies outside of it is no face.
    pub outer: Option<Lobes>,
}

/// A flat face. Its corners run counter-clockwise seen from outside the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// Corners.
    pub corners: [V3; 4],
    /// Round trim about the Z axis.
    pub trim: Trim,
}

impl Quad {
    /// Outward unit normal.
    pub fn normal(&self) -> V3 {
        let [a, b, c, d] = self.corners;
        (c - a).cross(&(d - b)).normalize()
    }

    /// The four edges.
    pub fn edges(&self) -> [(V3, V3); 4] {
        let [a, b, c, d] = self.corners;
        [(a, b), (b, c), (c, d), (d, a)]
    }

    /// Point of the face perpendicular below `p`.
    pub fn foot(&self, p: &V3) -> Option<V3> {
        let normal = self.normal();
        let foot = p - normal * (p - self.corners[0]).dot(&normal);
        self.covers(&foot, &normal).then_some(foot)
    }

    /// Length after which a ball of this radius, coming from outside, begins to touch the face.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        let normal = self.normal();
        let closing = -path.direction.dot(&normal);
        if closing <= 1e-14 {
            return None;
        }
        let gap = (path.from - self.corners[0]).dot(&normal) - radius;
        let reached = gap / closing;
        if reached <= 0.0 || reached > path.length {
            return None;
        }
        self.covers(&(path.at(reached) - normal * radius), &normal).then_some(reached)
    }

    fn covers(&self, point: &V3, normal: &V3) -> bool {
        let within = self.edges().iter().all(|(a, b)| (b - a).cross(&(point - a)).dot(normal) >= 0.0);
        let (away, Trim { inner, outer }) = (point.xy().norm(), self.trim);
        within
            && inner.is_none_or(|curve| away >= curve.radius_at(point))
            && outer.is_none_or(|curve| away <= curve.radius_at(point))
    }
}
