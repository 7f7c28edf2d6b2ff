//! Inch and millimetre. Inside the core everything is metric; data of the control keep the unit the manual gives them.

use super::{Control, Units};

/// Millimetres in an inch.
pub const INCH: f64 = 25.4;

impl Units {
    /// Millimetres in one unit of length.
    pub const fn factor(self) -> f64 {
        match self {
            Units::Metric => 1.0,
            Units::Inch => INCH,
        }
    }
}

impl Control {
    /// Millimetres in one unit of the active system (G70/G71/G700/G710, G20/G21).
    pub fn active_factor(&self) -> f64 {
        self.active_units.factor()
    }

    /// Millimetres in one unit of the basic system (`_EV[]`, `_WP[]`, `_SPEED[]`, B:1787-1795).
    pub fn basic_factor(&self) -> f64 {
        self.basic_units.factor()
    }

    /// A datum whose unit is that of the basic system, in mm or mm/min.
    pub fn basic_length(&self, name: &str) -> f64 {
        self.number(name) * self.basic_factor()
    }
}
