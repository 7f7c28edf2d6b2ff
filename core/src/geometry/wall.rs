//! Ball against a round wall about the Z axis from Z = 0 downwards: cylinder or cone, from inside or outside.

use super::{Lobes, Path, V3, radial, roots};

/// A cylinder or cone between Z = 0 and Z = −depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Radius at Z = 0, mm.
    pub radius: f64,
    /// Growth of the radius per mm of depth; 0: cylinder.
    pub slope: f64,
    /// Depth, mm.
    pub depth: f64,
    /// Whether the material is outside (a hole).
    pub inner: bool,
}

impl Wall {
    /// The curve at its upper end.
    pub fn lobes(&self) -> Lobes {
        Lobes { radius: self.radius, slope: self.slope, amplitude: 0.0, count: 0 }
    }

    fn side(&self) -> f64 {
        if self.inner { -1.0 } else { 1.0 }
    }

    /// Cosine of the half angle of the cone.
    fn lean(&self) -> f64 {
        1.0 / self.slope.hypot(1.0)
    }

    /// Distance of `p` from the (endless) wall, positive outside the material.
    fn gap(&self, p: &V3) -> f64 {
        self.side() * (p.xy().norm() - self.radius + self.slope * p.z) * self.lean()
    }

    /// Outward normal on the side of `p`.
    fn normal(&self, p: &V3) -> V3 {
        (radial(p) + V3::z() * self.slope) * (self.side() * self.lean())
    }

    /// Point of the wall perpendicular to `p`.
    pub fn foot(&self, p: &V3) -> Option<V3> {
        let foot = p - self.normal(p) * self.gap(p);
        (foot.z <= 0.0 && foot.z >= -self.depth && foot.dot(&radial(p)) > 0.0).then_some(foot)
    }

    /// Length after which a ball of this radius, coming from outside the material, begins to touch the wall.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        let offset = self.radius + self.side() * radius / self.lean();
        let (p, way) = (path.from, path.direction);
        let start = offset - self.slope * p.z;
        let growth = -self.slope * way.z;
        let a = way.xy().norm_squared() - growth * growth;
        let b = 2.0 * (p.xy().dot(&way.xy()) - start * growth);
        let c = p.xy().norm_squared() - start * start;
        let gap = |s: f64| {
            let ball = path.at(s);
            (self.gap(&ball) - radius, self.normal(&ball).dot(&way))
        };
        roots::quadratic(a, b, c)
            .into_iter()
            .filter(|s| start + growth * s >= 0.0)
            .map(|s| roots::polished(gap, s))
            .find(|&s| s > 0.0 && s <= path.length && gap(s).1 < 0.0 && self.foot(&path.at(s)).is_some())
    }
}
