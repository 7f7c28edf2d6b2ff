//! What repeated touches of one place tell of a machine: how far they spread, whether they drift, and the zero offset
//! range that follows. `_TZL` is to be the largest random deviation, found on each machine (B:1384, B:16881); how many
//! digits and how it is found the manual leaves open.

use super::spread::Spread;
use super::trend::Trend;

/// Smallest step in which a range is proposed, mm: the repeat accuracy of measuring on the fly (B:16760).
const STEP: f64 = 0.001;
/// The same on an inch machine, inch.
const STEP_INCH: f64 = 0.0001;
/// Rounding up takes no step for what calculation left.
const REST: f64 = 1e-6;

/// Touches of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat {
    /// Mean and standard deviation.
    pub spread: Spread,
    /// Smallest and largest value.
    pub ends: [f64; 2],
    /// Largest distance from the mean.
    pub furthest: f64,
    /// A straight line through them, where they are enough and vary.
    pub trend: Option<Trend>,
    /// `_TZL` for one touch: the largest distance, rounded up.
    pub zone: f64,
    /// `_TZL` for what two touches make, a diameter or a width: twice the distance at most.
    pub zone_of_two: f64,
}

impl Repeat {
    /// Of these values in mm or inch; none without two numbers.
    pub fn of(values: &[f64], inch: bool) -> Option<Repeat> {
        let spread = Spread::of(values.to_vec());
        let [Some(low), Some(high)] = [spread.values.first(), spread.values.last()].map(Option::<&f64>::copied) else {
            return None;
        };
        if spread.count() < 2 {
            return None;
        }
        let furthest = (high - spread.mean).max(spread.mean - low);
        let step = if inch { STEP_INCH } else { STEP };
        let up = |value: f64| (value / step - REST).ceil().max(1.0) * step;
        let trend = Trend::of(values);
        Some(Repeat { ends: [low, high], furthest, trend, zone: up(furthest), zone_of_two: up(2.0 * furthest), spread })
    }

    /// Whether three standard deviations go beyond the proposed range: more touches would find a larger deviation.
    pub fn is_narrow(&self) -> bool {
        3.0 * self.spread.deviation > self.zone
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() < 1e-9, "{a} is not {b}");
    }

    // oracle: hand (calculated apart from the code)
    #[test]
    fn ten_touches_propose_a_range() {
        let values = [20.0012, 20.0007, 20.0015, 20.0010, 20.0004, 20.0011, 20.0018, 20.0009, 20.0013, 20.0006];
        let found = Repeat::of(&values, false).unwrap();
        near(found.spread.mean, 20.00105);
        near(found.spread.deviation, 0.000_424_918_293);
        near(found.ends[1] - found.ends[0], 0.0014);
        near(found.furthest, 0.00075);
        assert_eq!((found.zone, found.zone_of_two), (0.001, 0.002));
        assert!(found.is_narrow());
    }

    // oracle: hand
    #[test]
    fn drifting_touches_are_told() {
        let values = [20.0012, 20.0013, 20.0027, 20.0028, 20.0028, 20.0041, 20.0054, 20.0051, 20.0061, 20.0060];
        let found = Repeat::of(&values, false).unwrap();
        near(found.spread.deviation, 0.001_845_866_253);
        near(found.furthest, 0.00255);
        near(found.zone, 0.003);
        assert!(found.trend.unwrap().certain);
    }

    // oracle: hand
    #[test]
    fn a_range_is_a_step_at_least() {
        let same = Repeat::of(&[5.0; 4], false).unwrap();
        assert_eq!((same.zone, same.zone_of_two, same.is_narrow()), (0.001, 0.001, false));
        let inch = Repeat::of(&[0.0, 0.000_30], true).unwrap();
        near(inch.zone, 0.0002);
        near(inch.zone_of_two, 0.0003);
        assert_eq!(Repeat::of(&[1.0], false), None);
    }
}
