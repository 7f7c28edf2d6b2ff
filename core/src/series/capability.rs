//! How well a process holds a tolerance.

use super::decide::Limits;
use super::normal::quantile;
use super::spread::Spread;
use libm::{exp, lgamma, log};
use serde::Serialize;

/// Capability of a process that is normal, with intervals of 95 %.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Capability {
    /// `(TU − TL)/(6s)`: by its spread alone.
    pub cp: f64,
    /// `min(TU − x̄, x̄ − TL)/(3s)`: also by where its mean lies.
    pub cpk: f64,
    /// Where the first lies with 95 % confidence, by chi-square.
    pub cp_interval: [f64; 2],
    /// Where the second does (A. F. Bissell, Applied Statistics 39, 1990).
    pub cpk_interval: [f64; 2],
}

/// Fewest values of which a capability is told.
const FEWEST: usize = 10;

/// The capability of these values; none where they are few or do not spread.
pub fn capability(spread: &Spread, limits: Limits) -> Option<Capability> {
    let (count, mean, deviation) = (spread.count(), spread.mean, spread.deviation);
    if count < FEWEST || deviation <= 0.0 || limits.high <= limits.low {
        return None;
    }
    let freedom = (count - 1) as f64;
    let cp = (limits.high - limits.low) / (6.0 * deviation);
    let cpk = (limits.high - mean).min(mean - limits.low) / (3.0 * deviation);
    let scale = |share: f64| cp * (chi_square(share, freedom) / freedom).sqrt();
    let error = quantile(0.975) * (1.0 / (9.0 * count as f64) + cpk * cpk / (2.0 * freedom)).sqrt();
    Some(Capability { cp, cpk, cp_interval: [scale(0.025), scale(0.975)], cpk_interval: [cpk - error, cpk + error] })
}

/// The value below which this share of a chi-square distribution lies: by halving, from the ends of its first guess
/// (Wilson and Hilferty).
fn chi_square(share: f64, freedom: f64) -> f64 {
    let width = 2.0 / (9.0 * freedom);
    let guess = freedom * (1.0 - width + quantile(share) * width.sqrt()).powi(3).max(1e-6);
    let (mut low, mut high) = (guess * 0.5, guess * 2.0 + 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        let end = if gamma_share(0.5 * freedom, 0.5 * middle) < share { &mut low } else { &mut high };
        *end = middle;
    }
    0.5 * (low + high)
}

/// The regularized incomplete gamma function P(a, x): its series below a + 1, else its continued fraction by Lentz.
fn gamma_share(a: f64, x: f64) -> f64 {
    let scale = exp(a * log(x) - x - lgamma(a));
    if x < a + 1.0 {
        let (mut term, mut sum, mut at) = (1.0 / a, 1.0 / a, a);
        while term > sum * f64::EPSILON {
            at += 1.0;
            term *= x / at;
            sum += term;
        }
        return scale * sum;
    }
    let mut b = x + 1.0 - a;
    let (mut c, mut d) = (1.0 / f64::MIN_POSITIVE, 1.0 / b);
    let mut fraction = d;
    for step in 1..100_000 {
        let factor = -f64::from(step) * (f64::from(step) - a);
        b += 2.0;
        d = 1.0 / (factor * d + b);
        c = b + factor / c;
        fraction *= d * c;
        if (d * c - 1.0).abs() < f64::EPSILON {
            break;
        }
    }
    1.0 - scale * fraction
}
