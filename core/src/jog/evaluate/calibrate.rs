//! What calibrating the probe finds: its length on a surface, its ball in a ring (B:2902-2977).

use super::Flat;

/// Exact length L1 and trigger value of the applicate: touched from above at `position`, shown with the length that was
/// stored, on a surface at this height, mm. Where L1 ends at the circumference of the ball, the trigger value is 0.
pub fn length(stored: f64, position: f64, height: f64, radius: f64, circumference: bool) -> (f64, f64) {
    let trigger = if circumference { 0.0 } else { radius };
    (stored + position - height - trigger, trigger)
}

/// Two touches opposite each other in a ring, as positions of the spindle: along their axis in plus and in minus
/// direction, and across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// Position along the axis at the touch in plus direction, mm.
    pub plus: f64,
    /// In minus direction.
    pub minus: f64,
    /// Position across.
    pub across: f64,
}

impl Chord {
    fn middle(&self) -> f64 {
        (self.plus + self.minus) / 2.0
    }

    fn half(&self) -> f64 {
        (self.plus - self.minus) / 2.0
    }
}

/// What was found in a ring. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// Centre of the ring.
    pub centre: Flat,
    /// Ball centre minus spindle axis.
    pub skew: Flat,
    /// Trigger values of abscissa and ordinate, in minus and in plus direction.
    pub triggers: [[f64; 2]; 2],
    /// Active diameter of the ball.
    pub ball: f64,
}

/// From two runs, the spindle turned by 180 degree and as it stood, each along abscissa and ordinate: turned round, the
/// skew changes its sign, so that the middle of both is the centre. A ball that ran beside the middle is calculated as
/// if it had run through it. A probe that follows its direction has no skew: its second run counts alone.
pub fn ring(diameter: f64, turned: [Chord; 2], usual: [Chord; 2], follows: bool) -> Ring {
    let [first, second] = [turned, usual].map(|run| run.map(|chord| chord.middle()));
    let centre: Flat =
        std::array::from_fn(|axis| if follows { second[axis] } else { (first[axis] + second[axis]) / 2.0 });
    let skew: Flat = std::array::from_fn(|axis| if follows { 0.0 } else { (first[axis] - second[axis]) / 2.0 });
    let triggers = std::array::from_fn(|axis| {
        let aside = usual[axis].across + skew[1 - axis] - centre[1 - axis];
        let beyond = usual[axis].half().hypot(aside) - diameter / 2.0;
        [-skew[axis] - beyond, -skew[axis] + beyond]
    });
    let [[x, to_x], [y, to_y]] = triggers;
    Ring { centre, skew, triggers, ball: (x - to_x + y - to_y) / 2.0 }
}
