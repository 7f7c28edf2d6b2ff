//! Whether a part is good, as far as a measurement that is uncertain tells it.

use super::normal::{below, quantile};

/// Limits of a deviation, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The smallest that is permitted.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

/// Chances of a part, or shares of many; together 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chances {
    /// Too small.
    pub low: f64,
    /// Within the limits.
    pub good: f64,
    /// Too large.
    pub high: f64,
}

/// What a measurement proves by ISO 14253-1: who proves bears the uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Proof {
    /// The part is good.
    Good,
    /// Neither is proved.
    Undecided,
    /// The part is bad.
    Bad,
}

impl Proof {
    /// Key of its words.
    pub fn key(self) -> &'static str {
        match self {
            Proof::Good => "certainty-proof-good",
            Proof::Undecided => "certainty-proof-undecided",
            Proof::Bad => "certainty-proof-bad",
        }
    }
}

impl Limits {
    /// Where the true value lies, of which this was measured with a standard uncertainty (JCGM 106, 7).
    pub fn chances(&self, measured: f64, uncertainty: f64) -> Chances {
        let share = |limit: f64| match uncertainty > 0.0 {
            true => below((limit - measured) / uncertainty),
            false => f64::from(u8::from(measured <= limit)),
        };
        let low = if uncertainty > 0.0 { share(self.low) } else { f64::from(u8::from(measured < self.low)) };
        let high = if uncertainty > 0.0 { below((measured - self.high) / uncertainty) } else { 1.0 - share(self.high) };
        Chances { low, good: (1.0 - low - high).max(0.0), high }
    }

    /// What is proved with a guard band this wide on either side of each limit.
    pub fn proof(&self, measured: f64, guard: f64) -> Proof {
        if measured >= self.low + guard && measured <= self.high - guard {
            Proof::Good
        } else if measured < self.low - guard || measured > self.high + guard {
            Proof::Bad
        } else {
            Proof::Undecided
        }
    }
}

/// Width of the guard band for 95 % at one limit, the default of ISO 14253-1:2017: 1.645·u.
pub fn guard(uncertainty: f64) -> f64 {
    quantile(0.95) * uncertainty
}

/// Coverage factor of the expanded uncertainty `U = k·u`, for about 95 % of a normal distribution (JCGM 100, 6.3.3).
pub const COVERAGE: f64 = 2.0;
