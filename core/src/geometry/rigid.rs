//! Rotations and rigid motions as the control defines them.

use super::V3;
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3};

/// Sine and cosine of an angle in degree; exact at multiples of 90.
pub fn sin_cos(degree: f64) -> (f64, f64) {
    let turn = degree.rem_euclid(360.0);
    match turn {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => turn.to_radians().sin_cos(),
    }
}

/// Rotation from angles about X, Y, Z in degree, taken as RPY: first about Z, then about the new Y,
/// then about the new X. A vector of the rotated system times this is the vector in the system before it.
pub fn rotation(angles: [f64; 3]) -> Rotation3<f64> {
    let [(sx, cx), (sy, cy), (sz, cz)] = angles.map(sin_cos);
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let about_y = Matrix3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let about_z = Matrix3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    Rotation3::from_matrix_unchecked(about_z * about_y * about_x)
}

/// Angles about X, Y, Z in degree of a rotation, the inverse of [`rotation`]; Y within ±90.
pub fn angles(turn: &Rotation3<f64>) -> [f64; 3] {
    let m = turn.matrix();
    let y = (-m[(2, 0)]).clamp(-1.0, 1.0).asin();
    let flat = m[(2, 0)].abs() > 1.0 - 1e-15;
    let (x, z) = if flat {
        (0.0, (-m[(0, 1)]).atan2(m[(1, 1)]))
    } else {
        (m[(2, 1)].atan2(m[(2, 2)]), m[(1, 0)].atan2(m[(0, 0)]))
    };
    [x.to_degrees(), y.to_degrees(), z.to_degrees()]
}

/// A system whose origin lies at `at` and that is turned by `turn`: maps its points to the system before it.
pub fn placed(at: V3, turn: Rotation3<f64>) -> IsometryMatrix3<f64> {
    IsometryMatrix3::from_parts(Translation3::from(at), turn)
}
