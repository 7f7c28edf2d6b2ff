//! A way round an axis: an arc, or with a climb along the axis a helix.

use super::{Degrees, Dir, Stretch, V3};

/// How a way between two points goes round an axis.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(concrete(P = super::Mcs)))]
pub struct Around<P> {
    /// A point of the axis.
    pub centre: P,
    /// Unit vector along it.
    #[cfg_attr(test, ts(as = "Dir<super::Mcs>"))]
    pub axis: Dir<P>,
    /// Degrees from start to end, right-handed about the axis; whole turns included.
    pub degrees: Degrees,
}

impl<P: Copy + From<V3> + Into<V3>> Around<P> {
    /// The place after a part of the way, 0 to 1: height and distance from the axis change evenly up to its end.
    pub fn at(&self, from: P, to: P, part: f64) -> P {
        if part >= 1.0 {
            return to;
        }
        self.stretch(from, to, [0.0, 1.0]).at(part).into()
    }

    /// Where an arc from here ends that climbs by so much, mm.
    ///
    /// ```compile_fail
    /// use probewright_core::geometry::{Around, Degrees, Dir, Mcs, Wcs};
    /// let turn = Around { centre: Wcs::default(), axis: Dir::new([0.0, 0.0, 1.0]), degrees: Degrees(90.0) };
    /// let end = turn.end(Mcs([1.0, 2.0, 3.0]), 0.0);
    /// ```
    pub fn end(&self, from: P, climb: f64) -> P {
        let (start, height) = self.split(from);
        let angle = self.degrees.radians();
        let (away, heights) = ([start.norm(); 2], [height, height + climb]);
        Stretch::round(self.centre.into(), self.axis.into(), start, angle, away, heights).at(1.0).into()
    }

    /// A point seen from the axis, and its height along it.
    fn split(&self, point: P) -> (V3, f64) {
        let axis = V3::from(self.axis);
        let away = point.into() - self.centre.into();
        let height = away.dot(&axis);
        (away - axis * height, height)
    }

    /// Length of the way, mm.
    pub fn length(&self, from: P, to: P) -> f64 {
        let [(start, height), (_, top)] = [from, to].map(|point| self.split(point));
        (start.norm() * self.degrees.radians()).hypot(top - height)
    }

    /// The way between two parts of it, 0 to 1.
    pub fn stretch(&self, from: P, to: P, [begin, end]: [f64; 2]) -> Stretch {
        let axis = V3::from(self.axis);
        let [(start, height), (last, top)] = [from, to].map(|point| self.split(point));
        let angle = self.degrees.radians();
        let (sine, cosine) = (angle * begin).sin_cos();
        let between = |a: f64, b: f64| [begin, end].map(|part| a + part * (b - a));
        Stretch::round(
            self.centre.into(),
            axis,
            start * cosine + axis.cross(&start) * sine,
            angle * (end - begin),
            between(start.norm(), last.norm()),
            between(height, top),
        )
    }

    /// The direction in which it ends; its length says nothing.
    pub fn leaves(&self, from: P, to: P) -> V3 {
        let [(_, height), (last, top)] = [from, to].map(|point| self.split(point));
        let axis = V3::from(self.axis);
        axis.cross(&last) * self.degrees.radians() + axis * (top - height)
    }

    /// Distance from the axis, where that is greatest, mm.
    pub fn radius(&self, from: P, to: P) -> f64 {
        let [start, end] = [from, to].map(|point| self.split(point).0.norm());
        start.max(end)
    }

    /// The way as `map` moves its points; none where it is no circle there: the axes have different scales.
    pub fn mapped<Q: From<V3> + Into<V3>>(&self, map: impl Fn(P) -> Q) -> Option<Around<Q>> {
        let axis = V3::from(self.axis);
        let upright = if axis.x.abs() < 0.9 { V3::x() } else { V3::y() };
        let first = axis.cross(&upright).normalize();
        let centre: V3 = map(self.centre).into();
        let seen = |direction: V3| map((self.centre.into() + direction).into()).into() - centre;
        let (first, second) = (seen(first), seen(axis.cross(&first)));
        let size = first.norm();
        let round = (second.norm() - size).abs() < 1e-9 * size && first.dot(&second).abs() < 1e-9 * size;
        round.then(|| Around {
            centre: centre.into(),
            axis: first.cross(&second).normalize().into(),
            degrees: self.degrees,
        })
    }
}

/// The way from start through a point to the end; none: the three lie on a line.
pub fn through<P: From<V3> + Into<V3>>(start: P, middle: P, end: P) -> Option<Around<P>> {
    let [a, b, c] = [start, middle, end].map(P::into);
    let (to_middle, to_end) = (b - a, c - a);
    let normal = to_middle.cross(&to_end);
    let square = normal.norm_squared();
    if square <= 1e-18 * to_middle.norm_squared() * to_end.norm_squared() {
        return None;
    }
    let lift = to_middle.norm_squared() * to_end.cross(&normal) - to_end.norm_squared() * to_middle.cross(&normal);
    let centre = a + lift / (2.0 * square);
    let axis = normal.normalize();
    let (x, to_end) = (a - centre, c - centre);
    let angle = to_end.dot(&axis.cross(&x)).atan2(to_end.dot(&x));
    Some(Around { centre: centre.into(), axis: axis.into(), degrees: Degrees::of(angle).positive() })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn near(a: [f64; 3], b: [f64; 3]) {
        assert!((V3::from(a) - V3::from(b)).norm() < 1e-9, "{a:?} {b:?}");
    }

    const ABOUT: Around<[f64; 3]> =
        Around { centre: [5.0, 2.0, 0.0], axis: Dir::new([0.0, 0.0, 1.0]), degrees: Degrees(90.0) };

    // oracle: hand
    #[test]
    fn a_quarter_is_driven_on_its_circle() {
        let from = [15.0, 2.0, 7.0];
        for (degrees, end) in [(90.0, [5.0, 12.0, 7.0]), (-90.0, [5.0, -8.0, 7.0]), (360.0, from)] {
            let arc = Around { degrees: Degrees(degrees), ..ABOUT };
            near(arc.end(from, 0.0), end);
            for part in [0.0, 0.1, 0.5, 0.9, 1.0] {
                let [x, y, z] = arc.at(from, end, part);
                assert!(((x - 5.0_f64).hypot(y - 2.0) - 10.0).abs() < 1e-9);
                assert_eq!(z, 7.0);
            }
            let way = 10.0 * degrees.abs().to_radians();
            assert!((arc.length(from, end) - way).abs() < 1e-9);
        }
    }

    // oracle: hand: a turn and a half up by 3; and an end that lies 0.01 farther out
    #[test]
    fn a_helix_climbs_evenly_and_every_way_ends_at_its_end() {
        let arc = Around { degrees: Degrees(540.0), ..ABOUT };
        let from = [15.0, 2.0, 0.0];
        let to = arc.end(from, 3.0);
        near(to, [-5.0, 2.0, 3.0]);
        near(arc.at(from, to, 1.0 / 3.0), [-5.0, 2.0, 1.0]);
        near(arc.at(from, to, 2.0 / 3.0), [15.0, 2.0, 2.0]);
        let beside = [5.0, 12.01, 0.0];
        near(ABOUT.at(from, beside, 1.0), beside);
        let [x, y, _] = ABOUT.at(from, beside, 0.5);
        assert!(((x - 5.0_f64).hypot(y - 2.0) - 10.005).abs() < 1e-9);
    }

    // oracle: self: a stretch is where the way is
    #[test]
    fn a_stretch_lies_on_its_way() {
        for degrees in [90.0, -200.0, 800.0] {
            let arc = Around { degrees: Degrees(degrees), ..ABOUT };
            let from = [15.0, 2.0, 7.0];
            let [x, y, _] = arc.end(from, 0.0);
            let to = [5.0 + 1.001 * (x - 5.0), 2.0 + 1.001 * (y - 2.0), 9.0];
            let stretch = arc.stretch(from, to, [0.25, 0.75]);
            for part in [0.0, 0.3, 1.0] {
                let place = arc.at(from, to, 0.25 + part / 2.0);
                near(stretch.at(part).into(), place);
            }
        }
    }

    // oracle: hand: what is mirrored goes round the other way; an ellipse is no circle
    #[test]
    fn a_way_is_mapped_with_its_points() {
        let map = |[x, y, z]: [f64; 3]| [z + 1.0, -2.0 * x, 2.0 * y];
        let (from, to) = ([15.0, 2.0, 0.0], [5.0, 12.0, 0.0]);
        let seen = ABOUT.mapped(map).unwrap();
        for part in [0.2, 0.7] {
            near(seen.at(map(from), map(to), part), map(ABOUT.at(from, to, part)));
        }
        assert_eq!(ABOUT.mapped(|[x, y, z]| [x, 2.0 * y, z]), None);
    }

    // oracle: hand: a half circle over the Z axis stands in the plane X-Z
    #[test]
    fn three_points_make_a_circle_in_space() {
        let (from, to) = ([10.0, 5.0, 0.0], [-10.0, 5.0, 0.0]);
        let arc = through(from, [0.0, 5.0, 10.0], to).unwrap();
        for part in [0.1, 0.5, 0.8] {
            let [x, y, z] = arc.at(from, to, part);
            assert!((x.hypot(z) - 10.0).abs() < 1e-9 && y == 5.0 && z > 0.0);
        }
        assert_eq!(through([0.0; 3], [1.0; 3], [2.0; 3]), None);
    }
}
