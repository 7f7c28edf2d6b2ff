//! One touch: what the position at switching says of the surface and of the ball (B:2746-2754, B:13441-13449).

use crate::control::{Control, Plane};
use crate::geometry::Wcs;

/// What the control knows of the probe with which it measures. Lengths in mm; abscissa, ordinate, applicate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stylus {
    /// Working plane.
    pub plane: Plane,
    /// Trigger values: position at switching minus surface, in minus and in plus direction.
    pub triggers: [[f64; 2]; 3],
    /// Ball centre minus spindle axis, abscissa and ordinate.
    pub skew: [f64; 2],
    /// Radius of the ball.
    pub radius: f64,
    /// Ball centre minus the point to which L1 refers, along the applicate.
    pub centre: f64,
}

/// A touch along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Position at switching.
    pub at: Wcs,
    /// Axis X (0), Y (1), Z (2).
    pub axis: usize,
    /// Direction of travel, +1 or -1.
    pub sign: f64,
}

/// What is worth in a WCS whose axis is mirrored: plus is the minus of the machine, in which calibration found it.
fn seen([minus, plus]: [f64; 2], sense: f64) -> [f64; 2] {
    if sense > 0.0 { [minus, plus] } else { [-plus, -minus] }
}

impl Stylus {
    /// The probe of a data field, from 1. A ball that was never found is half of what the trigger values are apart,
    /// else the radius of the tool. A mono probe turns with the spindle, so that its skew is not carried over.
    pub fn of(control: &Control, field: i64, mono: bool) -> Stylus {
        let datum = |index: usize| control.basic_length(&format!("_WP[{},{index}]", field - 1));
        let sense = control.plane.axes().map(|axis| if control.mirrored(axis) { -1.0 } else { 1.0 });
        let triggers: [[f64; 2]; 3] =
            std::array::from_fn(|axis| seen([datum(2 * axis + 1), datum(2 * axis + 2)], sense[axis]));
        let [minus, plus] = triggers[0];
        let known = [datum(0) / 2.0, (minus - plus) / 2.0].into_iter().find(|radius| *radius > 0.0);
        let radius = known.unwrap_or_else(|| control.active_radius());
        Stylus {
            plane: control.plane,
            triggers,
            skew: if mono { [0.0; 2] } else { [datum(7) * sense[0], datum(8) * sense[1]] },
            radius,
            // B:13652
            centre: if control.bit("_CBIT[14]") { control.active_radius() * sense[2] } else { 0.0 },
        }
    }

    /// This probe as if it had never been calibrated: a ball of the radius of the tool in the middle of the spindle.
    pub fn ideal(control: &Control) -> Stylus {
        let radius = control.active_radius();
        let stylus = Stylus { radius, skew: [0.0; 2], ..Stylus::of(control, 1, true) };
        let ends = [radius, -radius].map(|trigger| trigger - stylus.centre);
        Stylus { triggers: [[radius, -radius], [radius, -radius], ends], ..stylus }
    }

    /// Place of an axis X Y Z among abscissa, ordinate, applicate.
    pub fn place(&self, axis: usize) -> usize {
        self.plane.axes().iter().position(|known| *known == axis).unwrap_or_default()
    }

    /// Position at switching minus surface, along an axis X Y Z.
    pub fn trigger(&self, axis: usize, sign: f64) -> f64 {
        self.triggers[self.place(axis)][usize::from(sign > 0.0)]
    }

    /// Coordinate of the surface along the axis of a touch.
    pub fn surface(&self, touch: &Touch) -> f64 {
        touch.at[touch.axis] - self.trigger(touch.axis, touch.sign)
    }

    /// Centre of the ball where the probe stands.
    pub fn ball_at(&self, position: Wcs) -> Wcs {
        let [abscissa, ordinate, applicate] = self.plane.axes();
        let mut ball = position;
        ball[abscissa] += self.skew[0];
        ball[ordinate] += self.skew[1];
        ball[applicate] += self.centre;
        ball
    }

    /// Centre of the ball at a touch: along its axis by the trigger value.
    pub fn ball(&self, touch: &Touch) -> Wcs {
        let mut ball = self.ball_at(touch.at);
        ball[touch.axis] = self.surface(touch) - touch.sign * self.radius;
        ball
    }

    /// A point of the plane at a height.
    pub fn placed(&self, [first, second]: [f64; 2], height: f64) -> Wcs {
        let [abscissa, ordinate, applicate] = self.plane.axes();
        let mut at = Wcs::default();
        (at[abscissa], at[ordinate], at[applicate]) = (first, second, height);
        at
    }

    /// Abscissa and ordinate of a point.
    pub fn in_plane(&self, point: Wcs) -> [f64; 2] {
        let [abscissa, ordinate, _] = self.plane.axes();
        [point[abscissa], point[ordinate]]
    }
}
