//! Arcs of a program in the working plane: from centre, radius or opening angle.

use super::contour::distance;
use std::f64::consts::TAU;

/// How far the distances of both ends from the centre may differ, mm.
const TOLERANCE: f64 = 0.01;
/// An end that lies beside a tangent by no more lies on it, mm.
const STRAIGHT: f64 = 1e-6;
/// Angles below this are none, radian.
const NO_ANGLE: f64 = 1e-9;

/// An arc in the plane: abscissa and ordinate, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    pub centre: [f64; 2],
    pub end: [f64; 2],
    /// Angle from start to end, radian, counter-clockwise positive; whole turns included.
    pub sweep: f64,
}

impl Arc {
    /// The arc about a centre; none: it does not lie as far from both ends.
    pub fn about(centre: [f64; 2], start: [f64; 2], end: [f64; 2], counter: bool) -> Option<Arc> {
        let (from, to) = (distance(centre, start), distance(centre, end));
        if from <= 0.0 || (from - to).abs() > TOLERANCE {
            return None;
        }
        Some(Arc { centre, end, sweep: sweep(direction(centre, end) - direction(centre, start), counter) })
    }

    /// The arc with a radius, negative for more than a half circle.
    pub fn with_radius(radius: f64, start: [f64; 2], end: [f64; 2], counter: bool) -> Option<Arc> {
        let (dx, dy) = (end[0] - start[0], end[1] - start[1]);
        let length = dx.hypot(dy);
        let below = radius * radius - length * length / 4.0;
        if length == 0.0 || below < -1e-6 {
            return None;
        }
        let height = below.max(0.0).sqrt() / length;
        let side = if counter == (radius > 0.0) { 1.0 } else { -1.0 };
        let centre = [start[0] + dx / 2.0 - side * height * dy, start[1] + dy / 2.0 + side * height * dx];
        Arc::about(centre, start, end, counter)
    }

    /// The arc with an opening angle, degree.
    pub fn with_angle(angle: f64, start: [f64; 2], end: [f64; 2], counter: bool) -> Option<Arc> {
        if !(angle > 0.0 && angle < 360.0) {
            return None;
        }
        let radius = distance(start, end) / 2.0 / (angle.to_radians() / 2.0).sin();
        Arc::with_radius(if angle > 180.0 { -radius } else { radius }, start, end, counter)
    }

    /// The arc about a centre with an opening angle, degree.
    pub fn turned(centre: [f64; 2], start: [f64; 2], angle: f64, counter: bool) -> Option<Arc> {
        if !(angle > 0.0 && angle <= 360.0) {
            return None;
        }
        let turn = angle.to_radians() * if counter { 1.0 } else { -1.0 };
        let (radius, angle) = (distance(centre, start), direction(centre, start) + turn);
        Arc::about(centre, start, [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()], counter)
    }

    /// The arc to an end that begins in a direction; the inner none: the end lies straight ahead; the outer: behind.
    pub fn tangential(direction: [f64; 2], start: [f64; 2], end: [f64; 2]) -> Option<Option<Arc>> {
        let (dx, dy) = (end[0] - start[0], end[1] - start[1]);
        let [x, y] = direction;
        let (across, along) = (x * dy - y * dx, x * dx + y * dy);
        let half = across.atan2(along);
        let (length, size) = (dx.hypot(dy), x.hypot(y));
        // how far the end lies beside the straight line
        if across.abs() <= STRAIGHT * size {
            return (along >= 0.0 || length <= STRAIGHT).then_some(None);
        }
        let radius = length / (2.0 * half.sin()); // negative: to the right
        let centre = [start[0] - y / size * radius, start[1] + x / size * radius];
        Some(Some(Arc { centre, end, sweep: 2.0 * half }))
    }

    /// The arc with whole turns before its end (`TURN`).
    pub fn with_turns(self, turns: f64) -> Arc {
        Arc { sweep: self.sweep + TAU * turns * self.sweep.signum(), ..self }
    }
}

/// Angle from start to end, radian; a full circle where they are the same.
fn sweep(difference: f64, counter: bool) -> f64 {
    let positive = difference.rem_euclid(TAU);
    let turn = if positive < NO_ANGLE || TAU - positive < NO_ANGLE { TAU } else { positive };
    match counter {
        true => turn,
        false if turn == TAU => -TAU,
        false => turn - TAU,
    }
}

/// Direction from a centre to a point, radian.
fn direction(centre: [f64; 2], point: [f64; 2]) -> f64 {
    (point[1] - centre[1]).atan2(point[0] - centre[0])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn near(a: &[f64], b: &[f64]) {
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9), "{a:?} {b:?}");
    }

    // oracle: hand (a circle of 10 about the origin, from X10 to Y10)
    #[test]
    fn all_ways_to_write_an_arc_give_the_same() {
        let (start, end) = ([10.0, 0.0], [0.0, 10.0]);
        let arc = Arc::about([0.0; 2], start, end, true).unwrap();
        for other in [
            Arc::with_radius(10.0, start, end, true),
            Arc::with_angle(90.0, start, end, true),
            Arc::turned([0.0; 2], start, 90.0, true),
        ] {
            let other = other.unwrap();
            near(&other.centre, &arc.centre);
            near(&[other.sweep], &[TAU / 4.0]);
            near(&other.end, &end);
        }
        let long = Arc::with_radius(-10.0, start, end, true).unwrap();
        near(&long.centre, &[10.0, 10.0]);
        near(&[long.sweep], &[0.75 * TAU]);
        assert_eq!(Arc::about([0.0; 2], start, [0.0, 10.02], true), None);
    }

    // oracle: hand (from the origin along X: to the left and to the right of it, more than a half circle, straight on)
    #[test]
    fn a_tangent_and_an_end_make_an_arc() {
        let ahead = |end| Arc::tangential([3.0, 0.0], [0.0; 2], end);
        for (end, centre, quarters) in [
            ([10.0, 10.0], [0.0, 10.0], 1.0),
            ([10.0, -10.0], [0.0, -10.0], -1.0),
            ([0.0, 20.0], [0.0, 10.0], 2.0),
            ([-10.0, 10.0], [0.0, 10.0], 3.0),
            ([-10.0, -10.0], [0.0, -10.0], -3.0),
        ] {
            let arc = ahead(end).unwrap().unwrap();
            near(&arc.centre, &centre);
            near(&[arc.sweep], &[quarters * TAU / 4.0]);
            near(&arc.end, &end);
        }
        assert_eq!(ahead([10.0, 0.0]), Some(None));
        assert_eq!(ahead([0.0, 0.0]), Some(None));
        assert_eq!(ahead([-10.0, 0.0]), None);
    }

    // oracle: hand
    #[test]
    fn turns_and_full_circles_go_round() {
        let full = Arc::about([0.0; 2], [10.0, 0.0], [10.0, 0.0], false).unwrap();
        near(&[full.sweep], &[-TAU]);
        near(&[full.with_turns(2.0).sweep], &[-3.0 * TAU]);
    }
}
