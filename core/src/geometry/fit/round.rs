//! The circle and the sphere nearest to points; whether points make a triangle.

use crate::geometry::V3;
use nalgebra::{Matrix4, Vector4};

/// Points that differ from a line (of a sphere: from a plane) by less than this part of their extent determine nothing.
const FLAT: f64 = 1e-9;
/// Steps towards the least squares after which the last one counts; four at most are needed where points lie near a
/// circle.
const STEPS: usize = 50;
/// A step that is shorter than this part of the extent changes nothing any more.
const STILL: f64 = 1e-15;

/// Centre and radius of the circle through three points, of the nearest one to more: least squares of the distances.
/// None where the points lie in a line or upon each other.
pub fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let flat: Vec<V3> = points.iter().map(|[x, y]| V3::new(*x, *y, 0.0)).collect();
    let (centre, radius) = nearest(&flat, true)?;
    Some(([centre.x, centre.y], radius))
}

/// The sphere nearest to points, or with `plane`, where all have Z = 0, the circle.
pub fn nearest(points: &[V3], plane: bool) -> Option<(V3, f64)> {
    let middle = points.iter().sum::<V3>() / points.len() as f64;
    // about the middle and as large as 1, so that the size of the numbers decides nothing
    let apart = points
        .iter()
        .map(|p| (p - middle).norm())
        .fold(0.0, f64::max);
    let least = if plane { 3 } else { 4 };
    if points.len() < least || !apart.is_finite() || apart == 0.0 {
        return None;
    }
    let points: Vec<V3> = points.iter().map(|p| (p - middle) / apart).collect();
    let mut round = algebraic(&points, plane)?;
    for _ in 0..STEPS {
        let Some(step) = step(&points, plane, &round) else {
            break;
        };
        let next = round + step;
        if left(&points, &next) > left(&points, &round) * (1.0 + FLAT) {
            break;
        }
        round = next;
        if step.norm() < STILL {
            break;
        }
    }
    let found = (middle + round.xyz() * apart, round.w * apart);
    found.1.is_finite().then_some(found)
}

/// Where the search begins: least squares of p² = 2·p·centre + rest. Centre and radius as one vector.
fn algebraic(points: &[V3], plane: bool) -> Option<Vector4<f64>> {
    let rows = points.iter().map(|p| {
        let row = Vector4::new(2.0 * p.x, 2.0 * p.y, 2.0 * p.z, 1.0);
        (row, p.norm_squared())
    });
    let solution = solved(rows, plane)?;
    let radius = (solution.w + solution.xyz().norm_squared()).sqrt();
    radius.is_finite().then(|| solution.xyz().push(radius))
}

/// Gauss-Newton: the change of centre and radius that takes away the distances, as far as they are linear.
fn step(points: &[V3], plane: bool, round: &Vector4<f64>) -> Option<Vector4<f64>> {
    let rows = points.iter().map(|p| {
        let away = p - round.xyz();
        let out = away.try_normalize(0.0).unwrap_or_else(V3::zeros);
        (out.push(1.0), away.norm() - round.w)
    });
    solved(rows, plane)
}

/// Sum of the squares of the distances.
fn left(points: &[V3], round: &Vector4<f64>) -> f64 {
    let distance = |p: &V3| (p - round.xyz()).norm() - round.w;
    points.iter().map(|p| distance(p).powi(2)).sum()
}

/// Least squares of linear equations; in the plane the third unknown stays 0.
fn solved(rows: impl Iterator<Item = (Vector4<f64>, f64)>, plane: bool) -> Option<Vector4<f64>> {
    let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for (row, value) in rows {
        normal += row * row.transpose();
        right += row * value;
    }
    if plane {
        normal[(2, 2)] = 1.0;
    }
    (normal.determinant() > FLAT * FLAT)
        .then(|| normal.lu().solve(&right))
        .flatten()
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

    // oracle: definition: no circle near to it leaves less
    #[test]
    fn four_points_beside_a_circle_have_the_nearest_one() {
        let points = [[10.4, 0.0], [0.0, 9.7], [-10.0, 0.3], [1.0, -11.0]];
        let ([x, y], radius) = circle(&points).unwrap();
        let left = |x: f64, y: f64, radius: f64| -> f64 {
            let distance = |[a, b]: &[f64; 2]| (a - x).hypot(b - y) - radius;
            points.iter().map(|point| distance(point).powi(2)).sum()
        };
        let best = left(x, y, radius);
        for [dx, dy, dr] in [
            [1e-4, 0.0, 0.0],
            [0.0, 1e-4, 0.0],
            [0.0, 0.0, 1e-4],
            [1e-4, -1e-4, 1e-4],
        ] {
            assert!(left(x + dx, y + dy, radius + dr) > best);
            assert!(left(x - dx, y - dy, radius - dr) > best);
        }
    }
}
