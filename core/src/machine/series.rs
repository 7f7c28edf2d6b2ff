//! What varies from part to part, as the setup file describes it: plain data, drawn in `series`.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Most runs of a series; their results are kept.
pub const MOST_RUNS: u32 = 1_000_000;

/// A program that is run many times, and what varies from run to run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Series {
    /// How many runs, 1 to 1 000 000.
    pub runs: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Whether a run finds what the one before it left.
    pub mode: Mode,
    /// What varies. The scatter of a touch is the repeatability of the probe.
    pub vary: Vec<Vary>,
}

impl Default for Series {
    fn default() -> Series {
        Series { runs: 1000, seed: 1, mode: Mode::Independent, vary: Vec::new() }
    }
}

/// What a run of a series starts from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Mode {
    /// Each from the same state: how well a measurement repeats.
    #[default]
    Independent,
    /// Each from tools, frames and data as the one before it left them: parts one after another.
    Production,
}

/// Something that varies: what is drawn is added to what the file says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Vary {
    /// Member of the file: `workpiece[0].errors.size`, `.taper`, `.shift[0]`, `.tilt[2]`, `.outOfRound[0]`;
    /// `temperature.part`, K, by which the part is warmer; `probe.radius`, `.length`, `.delay`, `.skew[0]`,
    /// `.preTravel[0]`; a datum or a tool or frame variable as `data._WP[0,1]`, `data.$TC_DP3[9,1]`.
    pub what: String,
    /// How it is spread.
    #[serde(default, rename = "as")]
    #[cfg_attr(test, ts(as = "Option<Shape>"))]
    pub shape: Shape,
    /// Standard deviation, of `normal`.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub sigma: f64,
    /// Half width, of the others.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub half: f64,
    /// Its mean.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub mean: f64,
    /// By how much the mean grows from one part to the next: wear of the tool that makes them, a machine that warms up.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<f64>"))]
    pub drift: f64,
    /// How often it is drawn.
    #[serde(default)]
    #[cfg_attr(test, ts(as = "Option<Per>"))]
    pub per: Per,
    /// Added as well, one after the other from part to part, from the first again: a series as it was measured.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<f64>>"))]
    pub values: Vec<f64>,
    /// In production, how much of a correction reaches the next part: by variable, what one unit more of it adds here.
    /// A hole that is cut with T20 D1 gets smaller by twice the wear of the radius: `{ "$TC_DP15[20,1]": -2 }`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<String, f64>>"))]
    pub follows: BTreeMap<String, f64>,
}

impl Vary {
    /// Whether anything of it differs from part to part, or from what the file says.
    pub fn says_something(&self) -> bool {
        let spread = if self.shape == Shape::Normal { self.sigma } else { self.half };
        let own = [spread, self.mean, self.drift].iter().any(|number| *number != 0.0);
        own || !self.values.is_empty() || !self.follows.is_empty()
    }

    /// Which member says how far another shape reaches: it means nothing here.
    pub fn unused(&self) -> Option<&'static str> {
        match self.shape {
            Shape::Normal => (self.half != 0.0).then_some("half"),
            _ => (self.sigma != 0.0).then_some("sigma"),
        }
    }
}

/// How numbers are spread about their mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Shape {
    /// The normal distribution.
    #[default]
    Normal,
    /// Any value within the half width is as likely: a resolution.
    Uniform,
    /// Rarer towards the ends.
    Triangular,
    /// More frequent towards the ends: a swing met at any moment.
    Arcsine,
}

/// How often something is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Per {
    /// For each part.
    #[default]
    Part,
    /// Once, common to all parts: what a calibration left.
    Series,
}
