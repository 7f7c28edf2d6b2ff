//! Rotations and rigid motions as the control defines them.

use super::{Degrees, V3, place::numbers_of};
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3, Unit};

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

/// The rotation that takes one direction to another and does not turn about it, by sine and cosine, so that rounding
/// makes next to nothing of it. Opposite directions have none of their own: nothing turns.
pub fn between(from: &V3, to: &V3) -> Rotation3<f64> {
    let across = from.cross(to);
    let angle = across.norm().atan2(from.dot(to));
    Unit::try_new(across, 0.0).map_or_else(Rotation3::identity, |axis| Rotation3::from_axis_angle(&axis, angle))
}

/// A system whose origin lies at `at` and that is turned by `turn`: maps its points to the system before it.
pub fn placed(at: V3, turn: Rotation3<f64>) -> IsometryMatrix3<f64> {
    IsometryMatrix3::from_parts(Translation3::from(at), turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand: what turns one direction into another; between one and the same, but for rounding, hardly anything
    #[test]
    fn a_turn_between_directions_is_a_number() {
        let from = V3::new(-0.2, 0.14, 1.0);
        for exponent in 0..40 {
            for aside in [V3::x(), V3::new(0.3, -0.7, 0.1)] {
                let to = from + aside * 0.5_f64.powi(2 * exponent);
                let turned = between(&from, &to) * from.normalize();
                assert!((turned - to.normalize()).norm() < 1e-15, "{exponent}");
                let size = (turned - from.normalize()).norm();
                let turn = angles(&between(&from, &to));
                let most = turn.iter().map(|angle| angle.abs()).fold(0.0, f64::max);
                assert!(most <= 100.0 * size + 1e-13, "{exponent} {turn:?}");
            }
        }
        assert_eq!(angles(&between(&from, &-from)), [0.0; 3]);
    }
}
