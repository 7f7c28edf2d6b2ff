//! Angles, so that one passes neither for a length nor for radians.

use std::ops::{Add, Mul, Neg, Sub};

/// An angle, degree.
///
/// ```compile_fail
/// use probewright_core::geometry::Degrees;
/// let mm: f64 = Degrees(30.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, serde::Serialize, serde::Deserialize)]
#[serde(transparent)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline, description = ""))]
pub struct Degrees(pub f64);

impl Degrees {
    /// Of radians.
    pub fn of(radians: f64) -> Degrees {
        Degrees(radians.to_degrees())
    }

    /// In radians.
    pub fn radians(self) -> f64 {
        self.0.to_radians()
    }

    /// Less whole turns, from 0 to below 360.
    pub fn positive(self) -> Degrees {
        Degrees(self.0.rem_euclid(360.0))
    }

    /// Less whole turns, with its sign: between -360 and 360.
    pub fn within_turn(self) -> Degrees {
        Degrees(self.0 % 360.0)
    }

    /// Sine and cosine; exact at multiples of 90.
    pub fn sin_cos(self) -> (f64, f64) {
        match self.positive().0 {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            turn => turn.to_radians().sin_cos(),
        }
    }
}

impl Add for Degrees {
    type Output = Degrees;

    fn add(self, other: Degrees) -> Degrees {
        Degrees(self.0 + other.0)
    }
}

impl Sub for Degrees {
    type Output = Degrees;

    fn sub(self, other: Degrees) -> Degrees {
        Degrees(self.0 - other.0)
    }
}

impl Neg for Degrees {
    type Output = Degrees;

    fn neg(self) -> Degrees {
        Degrees(-self.0)
    }
}

/// So many times the angle, or a part of it.
impl Mul<f64> for Degrees {
    type Output = Degrees;

    fn mul(self, times: f64) -> Degrees {
        Degrees(self.0 * times)
    }
}
