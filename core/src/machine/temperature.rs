//! The temperature of the part, as far as its measurement depends on it.

use serde::{Deserialize, Serialize};

/// How well the temperature of the part is known. It has no effect on a run; it makes measured lengths uncertain.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Temperature {
    /// Standard deviation of its temperature from that for which the setpoints hold, K. 0: it is that temperature.
    pub spread: f64,
    /// How much it grows, µm per m and K.
    pub expansion: f64,
}

/// Linear expansion of steel between 20 and 100 °C, µm per m and K.
const STEEL: f64 = 11.5;

impl Default for Temperature {
    fn default() -> Temperature {
        Temperature { spread: 0.0, expansion: STEEL }
    }
}

impl Temperature {
    /// Whether it is as the file leaves it.
    pub fn is_default(&self) -> bool {
        *self == Temperature::default()
    }
}
