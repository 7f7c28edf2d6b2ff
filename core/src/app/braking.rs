//! The braking path as a calculator: the path of a feed, and the largest feed of a deflection.

use super::Error;
use crate::control::braking::Braking;
use crate::refused::Path;
use serde::{Deserialize, Serialize};

/// An axis, and what is asked of it.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct BrakingRequest {
    /// From the signal to the braking command, s.
    pub delay: f64,
    /// Deceleration, m/s².
    pub acceleration: f64,
    /// Servo gain, (m/min)/mm.
    pub gain: f64,
    /// Feed whose path is asked for, mm/min.
    pub feed: Option<f64>,
    /// Deflection whose largest feed is asked for, mm.
    pub deflection: Option<f64>,
}

/// What an axis needs to stop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct BrakingView {
    /// Path of the feed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<BrakingPath>,
    /// Largest feed of the deflection, mm/min.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<f64>,
}

/// The parts of a braking path, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct BrakingPath {
    /// Until the command to brake.
    pub delay: f64,
    /// While the set speed falls to zero.
    pub braking: f64,
    /// What the axis lags behind its set position.
    pub following: f64,
    /// All of it.
    pub sum: f64,
}

/// Answers what an axis needs to stop.
///
/// # Errors
/// There is no such axis: which value is at fault.
pub fn braking(asked: BrakingRequest) -> Result<BrakingView, Error> {
    let BrakingRequest { delay, acceleration, gain, feed, deflection } = asked;
    let refused =
        |name: &'static str, value: f64| Error::new("braking-value", Path::of(&[name])).number("value", value);
    let positive = |value: f64| value.is_finite() && value > 0.0;
    let not_negative = |value: f64| value.is_finite() && value >= 0.0;
    for (name, value, fits) in [
        ("delay", delay, not_negative(delay)),
        ("acceleration", acceleration, positive(acceleration)),
        ("gain", gain, positive(gain)),
        ("feed", feed.unwrap_or(0.0), not_negative(feed.unwrap_or(0.0))),
        ("deflection", deflection.unwrap_or(0.0), not_negative(deflection.unwrap_or(0.0))),
    ] {
        if !fits {
            return Err(refused(name, value).text("name", name));
        }
    }
    let axis = Braking { delay, acceleration, gain };
    let path = feed.map(|feed| axis.parts(feed)).map(|parts| BrakingPath {
        delay: parts.delay,
        braking: parts.braking,
        following: parts.following,
        sum: parts.sum(),
    });
    Ok(BrakingView { path, feed: deflection.map(|deflection| axis.feed(deflection)) })
}
