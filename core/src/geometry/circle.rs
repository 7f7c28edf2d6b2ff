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
        roots::polynomial(&quartic, -closest, path.length - closest)
            .into_iter()
            .map(|root| self.polish(path, radius, root + closest))
            .find(|&s| s > 0.0 && s <= path.length && self.closing(path, s) > 0.0)
    }

    fn closing(&self, path: &Path, s: f64) -> f64 {
        let p = path.at(s);
        -(p - self.foot(&p)).dot(&path.direction)
    }

    /// Newton steps on the distance itself: the quartic has squared it twice.
    fn polish(&self, path: &Path, radius: f64, start: f64) -> f64 {
        let mut s = start;
        for _ in 0..4 {
            let p = path.at(s);
            let away = p - self.foot(&p);
            let distance = away.norm();
            let slope = away.dot(&path.direction) / distance;
            let step = (distance - radius) / slope;
            if !step.is_finite() || step.abs() > 1e-3 {
                break;
            }
            s -= step;
        }
        s
    }
}

/// Unit vector from the Z axis towards `p`; X where `p` lies on the axis.
pub fn radial(p: &V3) -> V3 {
    let out = V3::new(p.x, p.y, 0.0);
    let length = out.norm();
    if length > 0.0 { out / length } else { V3::x() }
}
