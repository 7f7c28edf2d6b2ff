//! Rotations and rigid motions as the control defines them.

use super::{Degrees, V3, place::numbers_of};
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3};

/// Angles about X, Y, Z, degree, taken as RPY: first about Z, then about the new Y, then about the new X.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline, description = ""))]
pub struct Rpy(pub [f64; 3]);

numbers_of!(Rpy);

impl Rpy {
    /// About one of the axes X Y Z (by index) alone.
    pub fn about(axis: usize, angle: Degrees) -> Rpy {
        Rpy(std::array::from_fn(|i| if i == axis { angle.0 } else { 0.0 }))
    }
}

/// Rotation by these angles. A vector of the rotated system times this is the vector in the system before it.
pub fn rotation(angles: Rpy) -> Rotation3<f64> {
    let [(sx, cx), (sy, cy), (sz, cz)] = angles.map(|angle| Degrees(angle).sin_cos());
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let about_y = Matrix3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let about_z = Matrix3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    Rotation3::from_matrix_unchecked(about_z * about_y * about_x)
}

/// Angles of a rotation, the inverse of [`rotation`]; Y within ±90.
pub fn angles(turn: &Rotation3<f64>) -> Rpy {
    let m = turn.matrix();
    let y = (-m[(2, 0)]).clamp(-1.0, 1.0).asin();
    let flat = m[(2, 0)].abs() > 1.0 - 1e-15;
    let (x, z) = if flat {
        (0.0, (-m[(0, 1)]).atan2(m[(1, 1)]))
    } else {
        (m[(2, 1)].atan2(m[(2, 2)]), m[(1, 0)].atan2(m[(0, 0)]))
    };
    Rpy([x, y, z].map(f64::to_degrees))
}

/// A system whose origin lies at `at` and that is turned by `turn`: maps its points to the system before it.
pub fn placed(at: V3, turn: Rotation3<f64>) -> IsometryMatrix3<f64> {
    IsometryMatrix3::from_parts(Translation3::from(at), turn)
}
