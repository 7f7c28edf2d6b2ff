//! The ways of CYCLE998 from its first point to the others, and the angles that the heights there make.
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate. Angles are right-handed about an axis of the plane, degree.

use super::params::ONE;
use crate::catalogue::prelude::*;
use nalgebra::Vector3;

/// A way from the first point to another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Axis along which the other point lies, on its plus side.
    pub axis: usize,
    /// Distance of the points along it, mm.
    pub distance: f64,
    /// Set angle.
    pub set: f64,
    /// +1 where the surface rises in the measuring axis with a positive angle, else -1.
    pub sense: f64,
}

impl Leg {
    /// How far the surface rises along the way at this angle, mm.
    pub fn rise(&self, angle: f64) -> f64 {
        self.distance * (self.sense * angle).to_radians().tan()
    }

    /// Angle of a surface that rises by this much along the way, degree.
    pub fn angle(&self, rise: f64) -> f64 {
        self.sense * rise.atan2(self.distance).to_degrees()
    }
}

/// What is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Measuring axis.
    pub measuring: usize,
    /// The ways in their order.
    pub legs: Vec<Leg>,
}

impl Surface {
    /// One angle in the axes of `_MA` (B:7403-7408), or two above the plane (B:7792-7802). None: `_MA` is wrong.
    pub fn of(inputs: &Inputs) -> Option<Surface> {
        let leg = |axis, distance, angle, sense| Leg {
            axis,
            distance: inputs.number(distance),
            set: inputs.number(angle),
            sense,
        };
        if ONE.holds(inputs) {
            let axes = inputs.integer(names::MA);
            let (offset, measuring) = (one_of(axes / 100)?, one_of(axes % 100)?);
            let sense = match (3 + measuring - offset) % 3 {
                1 => 1.0,
                2 => -1.0,
                _ => return None,
            };
            return Some(Surface { measuring, legs: vec![leg(offset, names::ID, names::STA1, sense)] });
        }
        Some(Surface {
            measuring: 2,
            legs: vec![leg(0, names::ID, names::INCA, -1.0), leg(1, names::SETV0, names::STA1, 1.0)],
        })
    }

    /// The axis about which a single angle turns.
    pub fn third(&self) -> usize {
        3 - self.measuring - self.legs.first().map_or(0, |leg| leg.axis)
    }

    /// Cosine between the direction about which a single angle turns and that of a rotary axis as the table stands: 1
    /// where they turn alike, -1 against each other, as where the WCS is mirrored or upside down.
    pub fn alike(&self, control: &Control, rotary: usize) -> f64 {
        let (axes, third) = (control.plane.axes(), self.third());
        let about = control.turn_axis(axes[(third + 1) % 3], axes[(third + 2) % 3]);
        Vector3::from(about).dot(&Vector3::from(control.rotary_direction(rotary)))
    }
}

fn one_of(digit: i64) -> Option<usize> {
    (1..=3).contains(&digit).then(|| digit as usize - 1)
}

/// Normal of a plane that is turned about abscissa and ordinate by these angles, as both are seen along the axes:
/// abscissa, ordinate, applicate.
pub fn normal(about_abscissa: f64, about_ordinate: f64) -> Vector3<f64> {
    let (rise, fall) = (about_abscissa.to_radians().tan(), about_ordinate.to_radians().tan());
    Vector3::new(fall, -rise, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rigid::between;
    use proptest::prelude::*;

    proptest! {
        // oracle: definition: it takes one to the other, about a direction across both, however near they are
        #[test]
        fn the_rotation_between_two_normals_is_a_rotation(
            about in prop::array::uniform2(-45.0..45.0_f64), off in prop::array::uniform2(-1.0..1.0_f64), near in 0..17,
        ) {
            let part = 0.1_f64.powi(near);
            let from = normal(about[0], about[1]);
            let to = normal(about[0] + off[0] * part, about[1] + off[1] * part);
            let turn = between(&from, &to);
            let missed = turn * from.normalize() - to.normalize();
            prop_assert!(missed.norm() < 1e-15 * 8.0, "{missed}");
            prop_assert!((turn.matrix() * from.cross(&to) - from.cross(&to)).norm() < 1e-15 * 8.0);
        }
    }
}
