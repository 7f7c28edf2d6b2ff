//! Ball against a circular edge about the Z axis (the ball centre against a torus).

use super::{Path, V3, roots};

/// A circle about the Z axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Radius, mm.
    pub radius: f64,
    /// Height Z, mm.
    pub z: f64,
}

impl Circle {
    /// Point of the circle at an angle, radian.
    pub fn point(&self, angle: f64) -> V3 {
        let (sine, cosine) = angle.sin_cos();
        V3::new(self.radius * cosine, self.radius * sine, self.z)
    }

    /// Nearest point of the circle.
    pub fn foot(&self, p: &V3) -> V3 {
        let out = radial(p);
        V3::new(out.x * self.radius, out.y * self.radius, self.z)
    }

    /// Length after which a ball of this radius begins to touch the circle.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        let centre = V3::new(0.0, 0.0, self.z);
        let closest = -(path.from - centre).dot(&path.direction);
        let near = path.at(closest) - centre;
        let way = path.direction;
        let reach = near.norm_squared() + self.radius * self.radius - radius * radius;
        let four = 4.0 * self.radius * self.radius;
        let quartic = [
            reach * reach - four * near.xy().norm_squared(),
            -four * 2.0 * near.xy().dot(&way.xy()),
            2.0 * reach - four * way.xy().norm_squared(),
            0.0,
            1.0,
        ];
        // on the distance itself: the quartic has squared it twice
        let gap = |s: f64| {
            let p = path.at(s);
            let away = p - self.foot(&p);
            (away.norm() - radius, away.dot(&way) / away.norm())
        };
        roots::polynomial(&quartic, -closest, path.length - closest)
            .into_iter()
            .map(|root| roots::polished(gap, root + closest))
            .find(|&s| s > 0.0 && s <= path.length && gap(s).1 < 0.0)
    }
}

/// Unit vector from the Z axis towards `p`; X where `p` lies on the axis.
pub fn radial(p: &V3) -> V3 {
    let out = V3::new(p.x, p.y, 0.0);
    let length = out.norm();
    if length > 0.0 { out / length } else { V3::x() }
}
