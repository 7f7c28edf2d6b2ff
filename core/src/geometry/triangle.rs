//! The rigid motion that lays a triangle onto another one.

use super::V3;
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3};

/// The motion that brings the corners of one triangle nearest to those of another (least squares); none where corners
/// of either lie on one line.
///
/// It takes centroid onto centroid and the plane of the corners onto that of the others, never turned over, as corners
/// in the same order run the same way round about the normals (DESIGN.md derives it). What is left is an angle in the
/// plane, whose cosine and sine are as the sums of the scalar and of the cross products.
pub fn laid(corners: &[V3; 3], onto: &[V3; 3]) -> Option<IsometryMatrix3<f64>> {
    let (from, to) = (basis(corners)?, basis(onto)?);
    let [start, end] = [centroid(corners), centroid(onto)];
    let (mut cosine, mut sine) = (0.0, 0.0);
    for (corner, other) in corners.iter().zip(onto) {
        let p = from.inverse() * (corner - start);
        let q = to.inverse() * (other - end);
        cosine += p.x * q.x + p.y * q.y;
        sine += p.x * q.y - p.y * q.x;
    }
    let size = cosine.hypot(sine);
    if size == 0.0 || !size.is_finite() {
        return None;
    }
    let (c, s) = (cosine / size, sine / size);
    let inside = Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
    let turn = to * Rotation3::from_matrix_unchecked(inside) * from.inverse();
    Some(super::rigid::placed(end - turn * start, turn))
}

fn centroid(corners: &[V3; 3]) -> V3 {
    corners.iter().sum::<V3>() / 3.0
}

/// Axes along the first side, in the plane, and along the normal of a triangle.
fn basis([a, b, c]: &[V3; 3]) -> Option<Rotation3<f64>> {
    let side = (b - a).try_normalize(0.0)?;
    let normal = side.cross(&(c - a)).try_normalize(0.0)?;
    let columns = Matrix3::from_columns(&[side, normal.cross(&side), normal]);
    Some(Rotation3::from_matrix_unchecked(columns))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::rigid::{Rpy, placed, rotation};
    use proptest::prelude::*;

    const TRIANGLE: [[f64; 3]; 3] = [[100.0, 100.0, 100.0], [600.0, 100.0, 80.0], [500.0, 700.0, 130.0]];

    fn moved(motion: &IsometryMatrix3<f64>, corners: &[V3; 3]) -> [V3; 3] {
        corners.map(|corner| motion.transform_point(&corner.into()).coords)
    }

    /// Sum of the squares of what is left.
    fn left(motion: &IsometryMatrix3<f64>, corners: &[V3; 3], onto: &[V3; 3]) -> f64 {
        let there = moved(motion, corners);
        there.iter().zip(onto).map(|(one, other)| (one - other).norm_squared()).sum()
    }

    fn small() -> impl Strategy<Value = [f64; 3]> {
        [-5.0..5.0, -5.0..5.0, -5.0..5.0]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        // oracle: hand (the motion that made the other triangle)
        #[test]
        fn a_moved_triangle_gives_its_motion(
            at in small(), turn in [-180.0..180.0, -80.0..80.0, -180.0..180.0],
        ) {
            let corners = TRIANGLE.map(V3::from);
            let motion = placed(V3::from(at), rotation(Rpy(turn)));
            let found = laid(&corners, &moved(&motion, &corners)).unwrap();
            prop_assert!((found.to_homogeneous() - motion.to_homogeneous()).amax() < 1e-12);
        }

        // oracle: definition of the least squares: no motion near to it does better, nor does a half turn
        #[test]
        fn a_distorted_triangle_gives_the_best_motion(
            errors in [small(), small(), small()], at in small(), turn in small(), step in small(),
        ) {
            let corners = TRIANGLE.map(V3::from);
            let motion = placed(V3::from(at), rotation(Rpy(turn)));
            let mut onto = moved(&motion, &corners);
            onto.iter_mut().zip(errors).for_each(|(corner, error)| *corner += V3::from(error));
            let found = laid(&corners, &onto).unwrap();
            let best = left(&found, &corners, &onto);
            let middle = centroid(&onto);
            let about = |step: V3, turn| placed(middle + step, turn) * placed(-middle, Rotation3::identity());
            for size in [1e-4, 1e-2, 36.0] {
                let turn = rotation(Rpy(step.map(|angle| angle * size)));
                for way in [V3::zeros(), V3::from(step) * size] {
                    prop_assert!(left(&(about(way, turn) * found), &corners, &onto) >= best - 1e-9);
                }
            }
        }
    }

    // oracle: another method: the singular value decomposition of the sum of products, calculated with 40 digits
    #[test]
    fn the_best_motion_is_that_of_the_singular_values() {
        let onto = [[103.25, 99.5, 101.75], [599.0, 130.5, 64.25], [468.5, 721.75, 131.0]];
        let turn = Matrix3::new(
            0.997_648_908_315_996_7, -0.057_740_463_711_372_95, 0.036_914_693_365_863_12, 0.058_517_593_136_133_05,
            0.998_079_362_192_288_9, -0.020_329_241_485_794_22, -0.035_669_973_779_834_345, 0.022_441_604_582_323_558,
            0.999_111_619_066_817_1,
        );
        let way = V3::new(4.698_057_472_540_695, -3.480_157_625_274_493_6, 3.293_974_166_998_907_7);
        let found = laid(&TRIANGLE.map(V3::from), &onto.map(V3::from)).unwrap();
        assert!((found.rotation.matrix() - turn).amax() < 1e-14);
        assert!((found.translation.vector - way).amax() < 1e-11);
    }

    // oracle: hand
    #[test]
    fn what_is_no_triangle_gives_none() {
        let corners = TRIANGLE.map(V3::from);
        let line = [V3::zeros(), V3::x(), V3::x() * 3.0];
        assert!(laid(&line, &corners).is_none());
        assert!(laid(&corners, &line).is_none());
        assert!(laid(&corners, &[V3::zeros(); 3]).is_none());
    }
}
