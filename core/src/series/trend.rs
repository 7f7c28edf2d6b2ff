//! Whether numbers drift: a straight line through them in their order, and how certain it is.

use libm::{atan, cos, sin, sqrt};
use std::f64::consts::FRAC_2_PI;

/// Confidence from which a drift is told.
const CERTAIN: f64 = 0.95;
/// Fewest numbers through which a line can be uncertain.
const FEWEST: usize = 3;

/// A straight line through numbers in their order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Change from one number to the next.
    pub slope: f64,
    /// Correlation of number and place, −1 to 1.
    pub correlation: f64,
    /// Student's t of the correlation, with two degrees of freedom less than there are numbers.
    pub t: f64,
    /// Whether it is one with 95 % confidence.
    pub certain: bool,
}

impl Trend {
    /// Of these numbers; none where they are few or all the same.
    pub fn of(values: &[f64]) -> Option<Trend> {
        let count = values.len();
        if count < FEWEST {
            return None;
        }
        let mean = values.iter().sum::<f64>() / count as f64;
        let middle = (count - 1) as f64 / 2.0;
        let sum = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
            values.iter().enumerate().map(|(at, value)| of(at as f64 - middle, value - mean)).sum()
        };
        let (across, along, both) = (sum(&|at, _| at * at), sum(&|_, off| off * off), sum(&|at, off| at * off));
        if along <= 0.0 {
            return None;
        }
        let correlation = (both / sqrt(across * along)).clamp(-1.0, 1.0);
        let freedom = count - 2;
        let t = correlation * sqrt(freedom as f64 / (1.0 - correlation * correlation));
        Some(Trend { slope: both / across, correlation, t, certain: within(t.abs(), freedom) > CERTAIN })
    }
}

/// Share of Student's distribution between −t and t (M. Abramowitz, I. Stegun, 26.7.3 and 26.7.4).
fn within(t: f64, freedom: usize) -> f64 {
    let angle = atan(t / sqrt(freedom as f64));
    let (sine, cosine) = (sin(angle), cos(angle));
    let odd = freedom % 2 == 1;
    let (mut term, mut sum) = if odd { (cosine, 0.0) } else { (1.0, 0.0) };
    let mut at = if odd { 1 } else { 0 };
    while at + 2 <= freedom {
        sum += term;
        term *= cosine * cosine * (at + 1) as f64 / (at + 2) as f64;
        at += 2;
    }
    if odd { FRAC_2_PI * (angle + sine * sum) } else { sine * sum }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: peer: tables of Student's t, two-sided 95 %
    #[test]
    fn shares_are_those_of_the_tables() {
        let table = [(12.706_205, 1), (4.302_653, 2), (3.182_446, 3), (2.776_445, 4), (2.306_004, 8), (1.984_467, 98)];
        for (t, freedom) in table {
            assert!((within(t, freedom) - 0.95).abs() < 1e-6, "{freedom}: {}", within(t, freedom));
        }
    }

    // oracle: hand (least squares calculated apart from the code)
    #[test]
    fn a_drift_is_found() {
        let random = [20.0012, 20.0007, 20.0015, 20.0010, 20.0004, 20.0011, 20.0018, 20.0009, 20.0013, 20.0006];
        let trend = Trend::of(&random).unwrap();
        assert!((trend.slope + 0.000_006_666_667).abs() < 1e-12 && !trend.certain, "{trend:?}");
        assert!((trend.t + 0.134_507).abs() < 1e-6);
        let drifting = [20.0012, 20.0013, 20.0027, 20.0028, 20.0028, 20.0041, 20.0054, 20.0051, 20.0061, 20.0060];
        let trend = Trend::of(&drifting).unwrap();
        assert!((trend.slope - 0.000_593_333_333).abs() < 1e-12 && trend.certain, "{trend:?}");
        assert!((trend.correlation - 0.973_204_789).abs() < 1e-9 && (trend.t - 11.971_114).abs() < 1e-6);
    }

    // oracle: hand
    #[test]
    fn what_does_not_vary_has_no_trend() {
        assert_eq!(Trend::of(&[1.0; 10]), None);
        assert_eq!(Trend::of(&[1.0, 2.0]), None);
        assert!(Trend::of(&[1.0, 2.0, 3.0]).unwrap().certain);
    }
}
