//! Ball against a round wall that is not round: radius over the angle with lobes, with or without taper.

mod first;

use super::{V3, radial, roots};
use nalgebra::UnitComplex;
use std::f64::consts::{PI, TAU};

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

    /// Point of the curve at an angle, radian, and a height, mm.
    pub fn point(&self, angle: f64, z: f64) -> V3 {
        let out = self.at_angle(angle) - self.slope * z;
        let (sine, cosine) = angle.sin_cos();
        V3::new(out * cosine, out * sine, z)
    }

    /// Unit normal there of the wall that the curve makes, away from the axis.
    pub fn normal(&self, angle: f64, z: f64) -> V3 {
        let count = f64::from(self.count);
        let growth = -self.amplitude * count * (count * angle).sin();
        let (sine, cosine) = angle.sin_cos();
        let aside = growth / (self.at_angle(angle) - self.slope * z);
        V3::new(cosine + aside * sine, sine - aside * cosine, self.slope).normalize()
    }

    /// Greatest radius down to a depth, mm.
    pub fn widest(&self, depth: f64) -> f64 {
        self.radius + (self.slope * depth).max(0.0) + self.amplitude.abs()
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
        self.foot_between(p, [0.0, self.depth])
    }

    /// Nearest point of the wall between other depths, which goes on beyond its rims.
    fn foot_between(&self, p: &V3, rims: [f64; 2]) -> V3 {
        let samples = (16 * self.lobes.count as usize).max(96);
        let pitch = TAU / samples as f64;
        let (from, to) = self.searched(p, pitch, rims);
        let values = self.looked(p, pitch, [from - 1, to + 1], rims);
        let best = values.iter().copied().fold(f64::INFINITY, f64::min);
        let near = (best.sqrt() + self.lobes.radius * pitch).powi(2);
        let mut nearest = radial(p) * self.lobes.radius;
        let mut least = f64::INFINITY;
        for (i, around) in (from..=to).zip(values.windows(3)) {
            if around[1] > around[0] || around[1] > around[2] || around[1] > near {
                continue;
            }
            let candidate = self.refine(p, i as f64 * pitch, pitch, rims);
            let distance = (p - candidate).norm_squared();
            if distance < least {
                (nearest, least) = (candidate, distance);
            }
        }
        nearest
    }

    /// Squared distance of the wall at each angle, by turning the direction, many times quicker than a sine of each.
    fn looked(&self, p: &V3, pitch: f64, [from, to]: [i64; 2], rims: [f64; 2]) -> Vec<f64> {
        let first = from as f64 * pitch;
        let n = f64::from(self.lobes.count);
        let [step, wave_step] = [pitch, n * pitch].map(UnitComplex::new);
        let [mut out, mut wave] = [first, n * first].map(UnitComplex::new);
        let distance = |_| {
            let nearest = self.nearest(p, &out, wave.re, rims);
            out *= step;
            wave *= wave_step;
            (p - nearest).norm_squared()
        };
        (from..=to).map(distance).collect()
    }

    /// The angles, in steps of `pitch`, at which the wall can be nearest. A place of it is known, straight out; and
    /// what lies at another angle is no nearer than its ray from the axis.
    fn searched(&self, p: &V3, pitch: f64, rims: [f64; 2]) -> (i64, i64) {
        let own = p.y.atan2(p.x);
        let known = (p - self.nearest_at(p, own, rims)).norm();
        let out = p.xy().norm();
        let half = if known < out { (known / out).asin() } else { PI };
        let step = |angle: f64| (angle / pitch) as i64;
        (step(own - half) - 1, step(own + half) + 1)
    }

    /// A distance that the wall is surely not below, mm: that of the cone through its middle, less the amplitude.
    pub fn at_least(&self, p: &V3) -> f64 {
        self.off_mean(p, [0.0, self.depth]) - self.lobes.amplitude.abs()
    }

    /// Distance from the cone through its middle, between these depths, mm.
    fn off_mean(&self, p: &V3, [low, high]: [f64; 2]) -> f64 {
        let Lobes { radius, slope, .. } = self.lobes;
        let out = p.xy().norm();
        let down = (((out - radius) * slope - p.z) / (1.0 + slope * slope)).max(low).min(high);
        (out - radius - slope * down).hypot(p.z + down)
    }

    fn nearest_at(&self, p: &V3, angle: f64, rims: [f64; 2]) -> V3 {
        let wave = f64::from(self.lobes.count) * angle;
        self.nearest(p, &UnitComplex::new(angle), wave.cos(), rims)
    }

    /// Nearest point of the line at one angle; `wave` is the cosine of the lobes there.
    fn nearest(&self, p: &V3, at: &UnitComplex<f64>, wave: f64, [low, high]: [f64; 2]) -> V3 {
        let Lobes { radius, slope, amplitude, .. } = self.lobes;
        let top = radius + amplitude * wave;
        let out = p.x * at.re + p.y * at.im - top;
        let depth = ((out * slope - p.z) / (1.0 + slope * slope)).max(low).min(high);
        let r = top + slope * depth;
        V3::new(r * at.re, r * at.im, -depth)
    }

    /// Where the distance no longer changes with the angle.
    fn refine(&self, p: &V3, angle: f64, pitch: f64, rims: [f64; 2]) -> V3 {
        let n = f64::from(self.lobes.count);
        let change = |a: f64| {
            let [turn, wave] = [a, n * a].map(UnitComplex::new);
            let at = self.nearest(p, &turn, wave.re, rims);
            let growth = -self.lobes.amplitude * n * wave.im;
            let tangent = V3::new(growth * turn.re - at.y, growth * turn.im + at.x, 0.0);
            (at - p).dot(&tangent)
        };
        let near = |at: f64| (at - angle).abs() <= pitch;
        let at = roots::secant(change, [angle, angle + 0.1 * pitch])
            .filter(|at| near(*at) && change(at + 0.1 * pitch) > change(at - 0.1 * pitch))
            .or_else(|| roots::bracketed(change, angle - pitch, angle + pitch))
            .unwrap_or(angle);
        self.nearest_at(p, at, rims)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Nearest of the places at 20,000 angles.
    fn sampled(wall: &LobedWall, p: &V3) -> f64 {
        let rims = [0.0, wall.depth];
        let at = |i: u32| (p - wall.nearest_at(p, f64::from(i) * TAU / 20_000.0, rims)).norm();
        (0..20_000).map(at).fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        // oracle: self, by looking everywhere
        #[test]
        fn no_place_of_the_wall_is_nearer_than_its_foot(
            (radius, amplitude, count, slope) in (2.0..80.0, 0.0..0.3, 1..12u32, -0.2..0.2),
            (out, angle, z) in (0.0..2.0, 0.0..TAU, -40.0..10.0),
        ) {
            let lobes = Lobes { radius, slope, amplitude, count };
            let wall = LobedWall { lobes, depth: 8.0 };
            let p = V3::new(out * radius * angle.cos(), out * radius * angle.sin(), z);
            let distance = (p - wall.foot(&p)).norm();
            let seen = sampled(&wall, &p);
            prop_assert!(distance < seen + 1e-9, "{distance} {seen}");
            prop_assert!(distance > seen - 0.01 * radius / 20.0, "{distance} {seen}");
            prop_assert!(distance > wall.at_least(&p) - 1e-9, "{distance} {}", wall.at_least(&p));
        }
    }
}
