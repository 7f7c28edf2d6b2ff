//! A stretch of a way, straight or round an axis, and between which bounds it stays: along a direction, about an axis,
//! from a point. The bounds are exact where the distance from the axis does not change.

use super::V3;
use nalgebra::IsometryMatrix3;
use std::f64::consts::PI;

/// Sine of an angle below which two directions are one.
const PARALLEL: f64 = 1e-9;
/// What a difference of squares may lose, as a part of them: much on circles of kilometres.
const ROUNDING: f64 = 1e-15;

/// A piece of a straight line, of an arc or of a helix; the distance from the axis may change evenly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// A point of the axis.
    centre: V3,
    /// Unit vector along the axis; of a straight stretch along itself.
    axis: V3,
    /// Unit vectors across the axis: towards the start, and to where it goes from there.
    across: [V3; 2],
    /// Distance from the axis at both ends, mm; of a straight stretch none.
    radius: [f64; 2],
    /// Height over the centre at both ends, mm.
    height: [f64; 2],
    /// How far it goes round, radian, not negative.
    angle: f64,
    /// Cosine and sine of that.
    turn: [f64; 2],
}

impl Stretch {
    /// A straight one.
    pub fn straight(from: V3, to: V3) -> Stretch {
        let way = to - from;
        let length = way.norm();
        let axis = if length > 0.0 { way / length } else { V3::z() };
        Stretch {
            centre: from,
            axis,
            across: [V3::zeros(); 2],
            radius: [0.0; 2],
            height: [0.0, length],
            angle: 0.0,
            turn: [1.0, 0.0],
        }
    }

    /// One that goes round an axis by an angle, radian, right-handed; `start` is a vector across the axis.
    pub fn round(centre: V3, axis: V3, start: V3, angle: f64, radius: [f64; 2], height: [f64; 2]) -> Stretch {
        let out = start.try_normalize(0.0).unwrap_or_else(V3::zeros);
        Stretch {
            centre,
            axis,
            across: [out, axis.cross(&out) * angle.signum()],
            radius,
            height,
            angle: angle.abs(),
            turn: [angle.cos(), angle.abs().sin()],
        }
    }

    /// Moved by so much, mm.
    pub fn moved(&self, by: &V3) -> Stretch {
        Stretch { centre: self.centre + by, ..*self }
    }

    /// As seen from a system that stands at `place`.
    pub fn seen(&self, place: &IsometryMatrix3<f64>) -> Stretch {
        let into = place.rotation.inverse();
        Stretch {
            centre: place.inverse_transform_point(&self.centre.into()).coords,
            axis: into * self.axis,
            across: self.across.map(|across| into * across),
            ..*self
        }
    }

    /// Where it is after a part of it, 0 to 1.
    pub fn at(&self, part: f64) -> V3 {
        let between = |[from, to]: [f64; 2]| from + part * (to - from);
        let (sine, cosine) = (self.angle * part).sin_cos();
        let [out, on] = self.across;
        let away = (out * cosine + on * sine) * between(self.radius);
        self.centre + away + self.axis * between(self.height)
    }

    /// How far it goes from its middle at most, mm.
    pub fn half(&self) -> f64 {
        let [begin, end] = self.radius;
        let round = 2.0 * begin.max(end) * (self.angle.min(2.0 * PI) / 4.0).sin();
        let climb = (self.height[1] - self.height[0]) / 2.0;
        round.hypot(climb) + (end - begin).abs() / 2.0
    }

    /// Between which values a position times a direction stays.
    pub fn along(&self, direction: &V3) -> [f64; 2] {
        let [out, on] = self.across.map(|across| across.dot(direction));
        let [low, high] = self.turned(out, on);
        let [low, high] = [low, high].map(|value| self.radius.map(|radius| radius * value));
        let rise = self.axis.dot(direction);
        let [begin, end] = self.height.map(|height| rise * height);
        let base = self.centre.dot(direction);
        [base + begin.min(end) + low[0].min(low[1]), base + begin.max(end) + high[0].max(high[1])]
    }

    /// Whether its axis has this direction, a unit vector.
    pub fn goes_about(&self, direction: &V3) -> bool {
        self.angle > 0.0 && self.axis.cross(direction).norm_squared() < PARALLEL * PARALLEL
    }

    /// Least and greatest distance, mm, from the line through a point along its axis.
    pub fn from_axis(&self, point: &V3) -> [f64; 2] {
        let away = self.centre - point;
        let away = away - self.axis * away.dot(&self.axis);
        let [out, on] = self.across.map(|across| across.dot(&away));
        let [low, high] = self.turned(out, on);
        let [begin, end] = self.radius;
        let nearest = (-low).clamp(begin.min(end), begin.max(end));
        let (apart, widest) = (away.norm_squared(), begin.max(end));
        let lost = ROUNDING * (apart + widest * widest);
        let distance = |radius: f64, inner: f64, lost: f64| {
            let square = apart + radius * (radius + 2.0 * inner) + lost;
            square.max(0.0).sqrt()
        };
        let farthest = distance(begin, high, lost).max(distance(end, high, lost));
        [distance(nearest, low, -lost), farthest]
    }

    /// Least distance from a point, mm.
    pub fn from_point(&self, point: &V3) -> f64 {
        let base = (self.centre - point).dot(&self.axis);
        let [begin, end] = self.height.map(|height| base + height);
        let above = begin.min(end).max(-begin.max(end)).max(0.0);
        self.from_axis(point)[0].hypot(above)
    }

    /// Between which values `a·cos + b·sin` of its angle stays.
    fn turned(&self, a: f64, b: f64) -> [f64; 2] {
        let most = a.hypot(b);
        if self.angle > PI {
            return [-most, most];
        }
        let [cosine, sine] = self.turn;
        let end = a * cosine + b * sine;
        let (begins, ends) = (b, b * cosine - a * sine); // how it changes at both ends
        [
            if begins < 0.0 && ends > 0.0 { -most } else { a.min(end) },
            if begins > 0.0 && ends < 0.0 { most } else { a.max(end) },
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = V3> {
        let one = -size..size;
        (one.clone(), one.clone(), one).prop_map(|(x, y, z)| V3::new(x, y, z))
    }

    /// Arcs, helices and spirals of up to two turns.
    fn stretches() -> impl Strategy<Value = Stretch> {
        let (radius, height) = ([0.0..40.0, 0.0..40.0], [-9.0..9.0, -9.0..9.0]);
        (vector(30.0), vector(1.0), vector(1.0), -12.0..12.0, radius, height, any::<bool>()).prop_map(
            |(centre, axis, start, angle, [begin, end], [low, high], even)| {
                let axis = axis.try_normalize(1e-3).unwrap_or_else(V3::x);
                let upright = axis.cross(&V3::new(axis.y, axis.z, -axis.x - 2.0));
                let start = start - axis * start.dot(&axis) + upright * 1e-3;
                let end = if even { begin } else { end };
                Stretch::round(centre, axis, start, angle, [begin, end], [low, high])
            },
        )
    }

    proptest! {
        // oracle: self: places of the stretch lie within its bounds, and where it is an arc some of them on the bounds
        #[test]
        fn no_place_is_out_of_bounds(stretch in stretches(), direction in vector(1.0), point in vector(50.0)) {
            let places: Vec<V3> = (0..=2000).map(|i| stretch.at(f64::from(i) / 2000.0)).collect();
            let bounds = |value: &dyn Fn(&V3) -> f64| {
                let values = places.iter().map(value);
                values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
            };
            let axial = |place: &V3| {
                let away = place - point;
                (away - stretch.axis * away.dot(&stretch.axis)).norm()
            };
            let found = [
                (stretch.along(&direction), bounds(&|place| place.dot(&direction))),
                (stretch.from_axis(&point), bounds(&axial)),
            ];
            for ([low, high], [least, most]) in found {
                prop_assert!(low <= least + 1e-9 && high >= most - 1e-9, "{low} {least} {most} {high}");
            }
            let [least, _] = bounds(&|place| (place - point).norm());
            prop_assert!(stretch.from_point(&point) <= least + 1e-9);
            let [_, farthest] = bounds(&|place| (place - stretch.at(0.5)).norm());
            prop_assert!(stretch.half() >= farthest - 1e-9);
            let arc = stretch.radius[0] == stretch.radius[1];
            if arc && (stretch.angle <= PI || stretch.angle > 2.0 * PI) {
                let [[low, high], [least, most]] = [found[1].0, found[1].1];
                let step = stretch.angle * stretch.radius[0] / 2000.0;
                prop_assert!(least - low < step && high - most < step, "{low} {least} {most} {high}");
            }
        }
    }
}
