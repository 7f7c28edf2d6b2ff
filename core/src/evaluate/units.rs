//! Millimetre and inch.

use crate::control::{Control, Units};

/// mm of one unit of length.
pub const fn millimetres(units: Units) -> f64 {
    match units {
        Units::Metric => 1.0,
        Units::Inch => 25.4,
    }
}

/// mm of one unit of the basic system: `_WP`, `_EV`, `_MV`, `_SPEED`, tool and frame data (B:2314, B:13442).
pub fn basic(control: &Control) -> f64 {
    millimetres(control.basic_units)
}

/// mm of one unit of the active system (G70/G71/G700/G710); the lengths of `_OVR[]` count in it.
pub fn active(control: &Control) -> f64 {
    millimetres(control.active_units)
}
