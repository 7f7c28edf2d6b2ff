//! What only seems so where the control simulates a measurement (B:672-694).

use crate::geometry::{Mcs, V3};

/// What of a measurement only seems so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pretended {
    /// Beyond where the probe switches that the measured position lies, in the direction of the motion, mm.
    pub deviation: f64,
    /// Whether there is more than the measurement: offsets, result screen, log, monitored travel (B:676-678).
    pub whole: bool,
}

impl Default for Pretended {
    fn default() -> Pretended {
        Pretended { deviation: 0.0, whole: true }
    }
}

impl Pretended {
    /// The measured position of a motion from one place to another that switches here.
    pub fn latched(&self, from: Mcs, to: Mcs, at: Mcs) -> Mcs {
        if self.deviation == 0.0 {
            return at;
        }
        let way = to - from;
        let length = V3::from(way).norm();
        if length > 0.0 { at + way * (self.deviation / length) } else { at }
    }
}
