//! The line and the plane nearest to points.
//!
//! Both run through the mean of the points. The sum of the squares of the distances is then what the points extend
//! across the element, so that the line lies along the direction in which they extend most and the plane across the one
//! in which they extend least: the first and the last singular vector of the points about their mean.

use crate::geometry::V3;
use nalgebra::Matrix3xX;

/// Extents that differ by less than this part of the largest are the same: no direction is told apart from another.
const ALIKE: f64 = 1e-9;

/// The nearest line: a point of it, and a unit vector along it. None where no direction is the best one: all points
/// upon each other, or as far apart across as along.
pub fn line(points: &[V3]) -> Option<(V3, V3)> {
    let Extent { middle, sizes, directions, .. } = extent(points)?;
    let [longest, across, _] = sizes;
    (longest - across > ALIKE * longest).then_some((middle, directions[0]))
}

/// The nearest plane: a point of it, and a unit vector upright on it. None where the points do not determine it: fewer
/// than three, on one line, or as thick as they are wide.
pub fn plane(points: &[V3]) -> Option<(V3, V3)> {
    let Extent { middle, sizes, directions, .. } = extent(points)?;
    let [longest, across, thickness] = sizes;
    let normal = directions[0].cross(&directions[1]);
    (across - thickness > ALIKE * longest).then_some((middle, normal))
}

/// How far points lie from their mean.
pub(super) struct Extent {
    pub(super) middle: V3,
    /// Distance of the farthest one, mm.
    pub(super) farthest: f64,
    /// Roots of the sums of squares along the directions, the longest first, in parts of `farthest`.
    pub(super) sizes: [f64; 3],
    /// Upright on each other.
    directions: [V3; 2],
}

pub(super) fn extent(points: &[V3]) -> Option<Extent> {
    let middle = points.iter().sum::<V3>() / points.len() as f64;
    let away: Vec<V3> = points.iter().map(|point| point - middle).collect();
    let farthest = away.iter().map(V3::norm).fold(0.0, f64::max);
    if !farthest.is_finite() || farthest == 0.0 {
        return None;
    }
    // never fewer columns than rows, as large as 1
    let columns: Vec<V3> = away.into_iter().map(|away| away / farthest).chain([V3::zeros(); 3]).collect();
    let found = Matrix3xX::from_columns(&columns).svd(true, false);
    let directions = found.u?;
    Some(Extent {
        middle,
        farthest,
        sizes: [0, 1, 2].map(|i| found.singular_values[i]),
        directions: [0, 1].map(|i| directions.column(i).into_owned()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn points_that_determine_nothing_have_none() {
        let point = V3::new(3.0, -2.0, 5.0);
        let triangle = [V3::x(), V3::y(), V3::z()]; // equilateral: no side is the longest
        let row = [1.0, 2.0, 4.0].map(|way| point + V3::new(1.0, 1.0, -1.0) * way);
        assert_eq!(line(&[]), None);
        assert_eq!(line(&[point; 4]), None);
        assert_eq!(line(&triangle), None);
        assert!(plane(&triangle).is_some() && line(&row).is_some());
        assert_eq!(plane(&row), None);
        assert_eq!(plane(&[point, V3::x()]), None);
        assert_eq!(line(&[point, V3::x() * f64::INFINITY]), None);
    }
}
