//! The ways of CYCLE998 from its first point to the others, and the angles that the heights there make.
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate. Angles are right-handed about an axis of the plane, degree.

use super::params::ONE;
use crate::catalogue::prelude::*;
use crate::geometry::V3;

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
    /// How far the surface rises at this angle for each mm along the way, mm.
    fn slope(&self, angle: f64) -> f64 {
        (self.sense * angle).to_radians().tan()
    }

    /// How far the surface rises along the way at this angle, mm.
    pub fn rise(&self, angle: f64) -> f64 {
        self.distance * self.slope(angle)
    }

    /// Angle of a surface that rises by this much along the way, degree.
    pub fn angle(&self, rise: f64) -> f64 {
        self.sense * rise.atan2(self.distance).to_degrees()
    }
}

/// Names of the set angle along each way and of the distance of its points (B:7506-7520, B:7796-7806).
pub fn ways(inputs: &Inputs) -> &'static [[Name; 2]] {
    match ONE.holds(inputs) {
        true => &[[names::STA1, names::ID]],
        false => &[[names::INCA, names::ID], [names::STA1, names::SETV0]],
    }
}

/// What is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Measuring axis.
    pub measuring: usize,
    /// The ways in their order, one or two.
    pub legs: Vec<Leg>,
}

impl Surface {
    /// One angle in the axes of `_MA` (B:7403-7408), or two above the plane (B:7792-7802). None: `_MA` is wrong.
    pub fn of(inputs: &Inputs) -> Option<Surface> {
        let axes = inputs.integer(names::MA);
        let (offsets, measuring) = match ONE.holds(inputs) {
            true => (vec![one_of(axes / 100)?], one_of(axes % 100)?),
            false => (vec![0, 1], 2),
        };
        let leg = |(axis, [angle, distance]): (usize, &[Name; 2])| {
            let sense = match (3 + measuring - axis) % 3 {
                1 => 1.0,
                2 => -1.0,
                _ => return None,
            };
            Some(Leg { axis, distance: inputs.number(*distance), set: inputs.degrees(*angle).0, sense })
        };
        let legs = offsets.into_iter().zip(ways(inputs)).map(leg).collect::<Option<_>>()?;
        Some(Surface { measuring, legs })
    }

    /// Normal of the surface when these angles are added to the set ones, in the order of the ways, its part in the
    /// measuring axis 1: abscissa, ordinate, applicate.
    pub fn normal(&self, more: &[f64]) -> V3 {
        let mut normal = V3::from(place::unit(self.measuring));
        for (leg, more) in self.legs.iter().zip(more) {
            normal[leg.axis] = -leg.slope(leg.set + more);
        }
        normal
    }

    /// Direction of the surface along its first way when this angle is added to the set one, its part in the axis of
    /// the way 1: abscissa, ordinate, applicate.
    pub fn along(&self, more: f64) -> V3 {
        let leg = self.legs[0];
        let mut along = V3::from(place::unit(leg.axis));
        along[self.measuring] = leg.slope(leg.set + more);
        along
    }

    /// The axis about which a single angle turns.
    pub fn third(&self) -> usize {
        3 - self.measuring - self.legs[0].axis
    }

    /// Cosine between the direction about which a single angle turns and that of a rotary axis as the table stands: 1
    /// where they turn alike, -1 against each other, as where the WCS is mirrored or upside down.
    pub fn alike(&self, control: &Control, rotary: usize) -> f64 {
        let (axes, third) = (control.plane.axes(), self.third());
        let about = control.turn_axis(axes[(third + 1) % 3], axes[(third + 2) % 3]);
        V3::from(about).dot(&V3::from(control.rotary_direction(rotary)))
    }
}

fn one_of(digit: i64) -> Option<usize> {
    (1..=3).contains(&digit).then(|| digit as usize - 1)
}
