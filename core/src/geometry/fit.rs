//! A circle through measured points of a plane; whether points make a triangle.

use super::V3;
use nalgebra::{Matrix3, Vector3};

/// Points that differ from a line by less than this part of their extent determine no circle.
const FLAT: f64 = 1e-9;

/// Centre and radius of the circle through three points, of the nearest one to more (least squares of
/// x² + y² = 2ax + 2by + c). None where the points lie in a line or upon each other.
pub fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let count = points.len() as f64;
    let middle = [0, 1].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / count);
    // about the middle and as large as 1, so that the size of the numbers decides nothing
    let apart = points
        .iter()
        .map(|[x, y]| (x - middle[0]).hypot(y - middle[1]))
        .fold(0.0, f64::max);
    if points.len() < 3 || !apart.is_finite() || apart == 0.0 {
        return None;
    }
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for [x, y] in points {
        let (x, y) = ((x - middle[0]) / apart, (y - middle[1]) / apart);
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        normal += row * row.transpose();
        right += row * (x * x + y * y);
    }
    let solution = (normal.determinant() > FLAT * FLAT)
        .then(|| normal.lu().solve(&right))
        .flatten()?;
    let [x, y, rest]: [f64; 3] = solution.into();
    let radius = (rest + x * x + y * y).sqrt() * apart;
    let centre = [middle[0] + x * apart, middle[1] + y * apart];
    radius.is_finite().then_some((centre, radius))
}

/// Three points are on one line when their triangle is lower than this share of its longest side.
const LOW: f64 = 1e-6;

/// Whether three points lie on one line or upon each other.
pub fn in_line([a, b, c]: [V3; 3]) -> bool {
    let sides = [b - a, c - a, c - b].map(|side| side.norm());
    let longest = sides.into_iter().fold(0.0, f64::max);
    (b - a).cross(&(c - a)).norm() <= LOW * longest * longest
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: manual B:2456-2466 (three points of a circle of radius 10 about the zero)
    #[test]
    fn three_points_determine_a_circle() {
        let (centre, radius) = circle(&[[0.0, 10.0], [-10.0, 0.0], [0.0, -10.0]]).unwrap();
        assert!(
            centre[0].abs() < 1e-12 && centre[1].abs() < 1e-12 && (radius - 10.0).abs() < 1e-12
        );
    }

    // oracle: hand (four points of a circle of radius 5 about 1003, -2)
    #[test]
    fn four_points_far_from_the_zero_are_as_good() {
        let points = [[1008.0, -2.0], [1006.0, 2.0], [1003.0, 3.0], [999.0, -5.0]];
        let (centre, radius) = circle(&points).unwrap();
        assert!((centre[0] - 1003.0).abs() < 1e-9 && (centre[1] + 2.0).abs() < 1e-9);
        assert!((radius - 5.0).abs() < 1e-9);
    }

    // oracle: hand
    #[test]
    fn points_in_line_or_upon_each_other_determine_none() {
        for points in [
            [[0.0, 0.0], [1.0, 1.0], [7.0, 7.0]],
            [[1.0, 2.0], [1.0, 2.0], [5.0, 0.0]],
            [[3.0, 3.0]; 3],
            [[f64::INFINITY, 0.0], [0.0, 1.0], [1.0, 0.0]],
        ] {
            assert_eq!(circle(&points), None, "{points:?}");
        }
    }
}
