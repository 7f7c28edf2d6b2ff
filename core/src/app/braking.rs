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
    let axis = Braking { delay, acceleration, gain };
    let wrong = |(name, value): (&'static str, Option<f64>)| {
        value.filter(|value| !(value.is_finite() && *value > 0.0)).map(|value| (name, value))
    };
    let asked = || [("feed", feed), ("deflection", deflection)].into_iter().find_map(wrong);
    if let Some((name, value)) = axis.impossible().or_else(asked) {
        return Err(refused(name, value));
    }
    let path = feed.map(|feed| axis.parts(feed)).map(|parts| BrakingPath {
        delay: parts.delay,
        braking: parts.braking,
        following: parts.following,
        sum: parts.sum(),
    });
    Ok(BrakingView { path, feed: deflection.map(|deflection| axis.feed(deflection)) })
}

/// Why a value cannot be.
pub(super) fn refused(name: &'static str, value: f64) -> Error {
    Error::new("braking-value", Path::of(&[name])).number("value", value).text("name", name)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand (no axis stops without deceleration or gain, no probe allows less than nothing)
    #[test]
    fn values_that_cannot_be_are_named() {
        let fine = BrakingRequest { delay: 0.0, acceleration: 1.0, gain: 1.0, feed: None, deflection: None };
        assert!(braking(fine).is_ok());
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            for (name, asked) in [
                ("acceleration", BrakingRequest { acceleration: wrong, ..fine }),
                ("gain", BrakingRequest { gain: wrong, ..fine }),
                ("feed", BrakingRequest { feed: Some(wrong), ..fine }),
                ("deflection", BrakingRequest { deflection: Some(wrong), ..fine }),
            ] {
                let told = braking(asked).err().and_then(|error| error.message.word("name").map(str::to_owned));
                assert_eq!(told.as_deref(), Some(name), "{wrong}");
            }
        }
    }
}
