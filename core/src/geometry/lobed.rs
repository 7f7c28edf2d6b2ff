//! Ball against a round wall that is not round: radius over the angle with lobes, with or without taper.

use super::circle::radial;
use super::{Path, TOLERANCE, V3, roots};
use std::f64::consts::TAU;

/// A closed curve about the Z axis, growing with depth: `r = radius + slope·depth + amplitude·cos(count·angle)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobes {
    /// Mean radius at Z = 0, mm.
    pub radius: f64,
    /// Growth of the radius per mm of depth.
    pub slope: f64,
    /// Amplitude, mm.
    pub amplitude: f64,
    /// Number of lobes on the circumference.
    pub count: u32,
}

impl Lobes {
    /// Radius of the curve at the angle and height of `p`.
    pub fn radius_at(&self, p: &V3) -> f64 {
        self.at_angle(p.y.atan2(p.x)) - self.slope * p.z
    }

    fn at_angle(&self, angle: f64) -> f64 {
        self.radius + self.amplitude * (f64::from(self.count) * angle).cos()
    }
}

/// The wall below the curve, from Z = 0 to Z = −depth, both rims included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobedWall {
    /// Curve.
    pub lobes: Lobes,
    /// Depth, mm.
    pub depth: f64,
}

impl LobedWall {
    /// Nearest point of the wall. Its lines at one angle are straight, so that only the angle is searched.
    pub fn foot(&self, p: &V3) -> V3 {
        let samples = (16 * self.lobes.count as usize).max(96);
        let angle = |i: usize| TAU * i as f64 / samples as f64;
        let distance = |i: usize| (p - self.nearest_at(p, angle(i % samples))).norm_squared();
        let values: Vec<f64> = (0..samples).map(distance).collect();
        let best = values.iter().copied().fold(f64::INFINITY, f64::min);
        let pitch = self.lobes.radius * TAU / samples as f64;
        let near = best.sqrt() + pitch;
        let mut nearest = radial(p) * self.lobes.radius;
        let mut least = f64::INFINITY;
        for i in 0..samples {
            let (before, after) = (
                values[(i + samples - 1) % samples],
                values[(i + 1) % samples],
            );
            if values[i] > before || values[i] > after || values[i] > near * near {
                continue;
            }
            let candidate = self.refine(p, angle(i), TAU / samples as f64);
            let distance = (p - candidate).norm_squared();
            if distance < least {
                (nearest, least) = (candidate, distance);
            }
        }
        nearest
    }

    /// Length after which a ball of this radius begins to touch the wall. The distance to the wall is a way that
    /// is surely free; once inside the last micron the root is closed in with the exact slope of the distance.
    pub fn first(&self, path: &Path, radius: f64) -> Option<f64> {
        let gap = |s: f64| {
            let p = path.at(s);
            let away = p - self.foot(&p);
            let distance = away.norm();
            (distance - radius, away.dot(&path.direction) / distance)
        };
        let mut s = 0.0;
        for _ in 0..5000 {
            let (free, slope) = gap(s);
            if free < 1e-3 && slope < -1e-3 {
                let ahead = s + 2.0 * free.max(TOLERANCE) / -slope;
                let root = roots::bracketed(|x| gap(x).0, s, ahead);
                if let Some(root) = root {
                    return (root > 0.0 && root <= path.length).then_some(root);
                }
            }
            if free < 0.1 * TOLERANCE && slope < 0.0 {
                return (s > 0.0).then_some(s);
            }
            s += free.max(0.1 * TOLERANCE);
            if s > path.length {
                return None;
            }
        }
        None
    }

    fn nearest_at(&self, p: &V3, angle: f64) -> V3 {
        let out = V3::new(angle.cos(), angle.sin(), 0.0);
        let top = out * self.lobes.at_angle(angle);
        let down = out * self.lobes.slope - V3::z();
        let depth = ((p - top).dot(&down) / down.norm_squared()).clamp(0.0, self.depth);
        top + down * depth
    }

    /// Where the distance no longer changes with the angle.
    fn refine(&self, p: &V3, angle: f64, pitch: f64) -> V3 {
        let n = f64::from(self.lobes.count);
        let change = |a: f64| {
            let at = self.nearest_at(p, a);
            let r = at.xy().norm();
            let growth = -self.lobes.amplitude * n * (n * a).sin();
            let tangent = V3::new(
                growth * a.cos() - r * a.sin(),
                growth * a.sin() + r * a.cos(),
                0.0,
            );
            (at - p).dot(&tangent)
        };
        let at = roots::bracketed(change, angle - pitch, angle + pitch).unwrap_or(angle);
        self.nearest_at(p, at)
    }
}
