//! How far an axis goes on after the probe has switched, and how fast it may be so that the probe takes it
//! (B:1129-1196, A:1074-1146). The formula mixes units: m/s in the first two parts, m/min in the third.

use super::Control;

/// Data from which the braking path follows: of the axes the lowest (B:1149-1161).
pub const DATA: [&str; 4] = ["MD10050", "MD10070", "MD32300", "MD32200"];

/// Millimetres per minute in a metre per second.
const PER_SECOND: f64 = 60_000.0;
/// Millimetres in a metre.
const METRE: f64 = 1000.0;

/// What an axis does between the signal and its standstill: of all axes that take part the lowest values (B:1161).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Braking {
    /// From the signal to the braking command, s (MD10050 times MD10070).
    pub delay: f64,
    /// Deceleration, m/s² (MD32300).
    pub acceleration: f64,
    /// Servo gain Kv, (m/min)/mm (MD32200).
    pub gain: f64,
}

/// The parts of a braking path, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parts {
    /// Until the command to brake.
    pub delay: f64,
    /// While the set speed falls to zero.
    pub braking: f64,
    /// What the axis lags behind its set position.
    pub following: f64,
}

impl Parts {
    /// All of it, mm.
    pub fn sum(self) -> f64 {
        self.delay + self.braking + self.following
    }
}

impl Braking {
    /// The first value that no axis has, with its name; none: there is such an axis.
    pub fn impossible(&self) -> Option<(&'static str, f64)> {
        let Braking { delay, acceleration, gain } = *self;
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let values = [
            ("delay", delay, delay.is_finite() && delay >= 0.0),
            ("acceleration", acceleration, positive(acceleration)),
            ("gain", gain, positive(gain)),
        ];
        values.into_iter().find(|(_, _, fits)| !fits).map(|(name, value, _)| (name, value))
    }

    /// The braking path at a feed in mm/min.
    pub fn parts(&self, feed: f64) -> Parts {
        let speed = feed / PER_SECOND;
        Parts {
            delay: METRE * speed * self.delay,
            braking: METRE * speed * speed / (2.0 * self.acceleration),
            following: feed / METRE / self.gain,
        }
    }

    /// The largest feed, mm/min, whose braking path is not longer than a deflection in mm: the formula solved for the
    /// speed, which has one positive root.
    pub fn feed(&self, deflection: f64) -> f64 {
        if deflection <= 0.0 {
            return 0.0;
        }
        let linear = METRE * self.delay + 60.0 / self.gain;
        // the root as a quotient: a difference of large numbers would lose the digits
        let square = linear * linear + 2.0 * METRE * deflection / self.acceleration;
        PER_SECOND * 2.0 * deflection / (linear + square.sqrt())
    }
}

/// What the probe has to take of a touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deflection {
    /// How far the axis goes on after the signal, mm.
    pub path: f64,
    /// How far the probe may be deflected, mm.
    pub permitted: f64,
    /// Largest feed at which it is not deflected further, mm/min.
    pub largest: f64,
}

impl Deflection {
    /// Whether it is more than the probe takes.
    pub fn is_too_far(self) -> bool {
        self.path > self.permitted
    }

    /// The path as it is told, mm: rounded up to thousandths.
    pub fn told(self) -> f64 {
        (self.path * 1000.0 - 1e-6).ceil() / 1000.0
    }
}

impl Control {
    /// How its slowest axis stops, where its machine data say so.
    pub fn braking(&self) -> Option<Braking> {
        let [clock, ratio, acceleration, gain] = DATA.map(|name| self.number(name));
        let braking = Braking { delay: clock * ratio, acceleration, gain };
        (braking.delay > 0.0 && braking.impossible().is_none()).then_some(braking)
    }

    /// What the probe has to take of a touch at a feed in mm/min; none: the machine does not say how it stops, or what
    /// the probe allows.
    pub fn deflection_at(&self, feed: f64) -> Option<Deflection> {
        let permitted = self.deflection?;
        let braking = self.braking()?;
        Some(Deflection { path: braking.parts(feed).sum(), permitted, largest: braking.feed(permitted) })
    }
}

/// The feed of a measuring block, mm/min: `_VMS`, or 150 up to `_FA` = 1 mm and 300 above (B:2164-2170).
pub fn measuring_feed(chosen: f64, path: f64) -> f64 {
    match chosen {
        feed if feed > 0.0 => feed,
        _ if path > 1.0 => 300.0,
        _ => 150.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The machine of the manual's example (B:1184-1187).
    const EXAMPLE: Braking = Braking { delay: 0.016, acceleration: 1.0, gain: 1.0 };

    // oracle: manual B:1184-1196, A:1133-1146 (1.6 mm, 11 mm of which 6 mm are the following error, 12.6 mm in all)
    #[test]
    fn the_example_of_the_manual_is_met() {
        let parts = EXAMPLE.parts(6000.0);
        assert!((parts.delay - 1.6).abs() < 1e-12);
        assert!((parts.braking - 5.0).abs() < 1e-12);
        assert!((parts.following - 6.0).abs() < 1e-12);
        assert!((parts.sum() - 12.6).abs() < 1e-12);
        assert!((EXAMPLE.feed(12.6) - 6000.0).abs() < 1e-9);
    }

    // oracle: hand (the equation solved apart from the code, the result inserted again)
    #[test]
    fn the_largest_feed_of_a_deflection() {
        for (deflection, feed) in [(0.1, 78.2755), (0.5, 378.9878), (1.0, 730.8978), (2.0, 1372.4194), (5.0, 2976.1529)]
        {
            assert!((EXAMPLE.feed(deflection) - feed).abs() < 1e-4, "{deflection}");
        }
        let fast = Braking { delay: 0.004, acceleration: 3.0, gain: 3.0 };
        assert!((fast.feed(2.0) - 3545.265).abs() < 1e-3);
        assert_eq!((EXAMPLE.feed(0.0), EXAMPLE.feed(-1.0)), (0.0, 0.0));
    }

    proptest! {
        // oracle: self (each is the other's inverse)
        #[test]
        fn the_path_at_the_largest_feed_is_the_deflection(
            delay in 0.0_f64..0.1,
            acceleration in 0.01_f64..50.0,
            gain in 0.05_f64..20.0,
            deflection in 0.001_f64..50.0,
        ) {
            let braking = Braking { delay, acceleration, gain };
            let path = braking.parts(braking.feed(deflection)).sum();
            prop_assert!((path - deflection).abs() <= 1e-9 * deflection.max(1.0));
        }
    }
}
