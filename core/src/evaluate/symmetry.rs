//! Asymmetric tolerances are moved to the middle of their band before anything is compared (B:2203-2211).

/// Setpoint and tolerances as the decisions use them, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric {
    /// Middle of the tolerance band: `_OVR[0]`.
    pub setpoint: f64,
    /// Half of the band, positive: `_OVR[8]`.
    pub upper: f64,
    /// Half of the band, negative: `_OVR[12]`.
    pub lower: f64,
}

/// Moves the setpoint to the middle between `setpoint + lower` and `setpoint + upper`.
pub fn symmetric(setpoint: f64, upper: f64, lower: f64) -> Symmetric {
    let half = (upper - lower) / 2.0;
    Symmetric { setpoint: setpoint + (upper + lower) / 2.0, upper: half, lower: -half }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_on_one_side_moves_the_setpoint() {
        // oracle: manual B:2211
        let s = symmetric(10.0, 0.0, -0.004);
        assert!((s.setpoint - 9.998).abs() < 1e-12);
        assert!((s.upper - 0.002).abs() < 1e-12);
        assert!((s.lower + 0.002).abs() < 1e-12);
    }
}
