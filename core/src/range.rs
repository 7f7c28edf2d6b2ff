//! Ranges of numbers.

/// Range of a number. `f64::NEG_INFINITY`/`INFINITY` for an open end.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Range {
    /// Lower end.
    #[serde(skip_serializing_if = "open")]
    #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
    pub min: f64,
    /// Whether `min` itself is allowed.
    pub min_included: bool,
    /// Upper end.
    #[serde(skip_serializing_if = "open")]
    #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
    pub max: f64,
    /// Whether `max` itself is allowed.
    pub max_included: bool,
}

fn open(end: &f64) -> bool {
    end.is_infinite()
}

impl Range {
    /// Any finite number.
    pub const ANY: Range =
        Range { min: f64::NEG_INFINITY, min_included: false, max: f64::INFINITY, max_included: false };
    /// Greater than 0.
    pub const POSITIVE: Range = Range { min: 0.0, ..Range::ANY };
    /// 0 or greater.
    pub const NOT_NEGATIVE: Range = Range { min: 0.0, min_included: true, ..Range::ANY };

    /// From `min` to `max`, both allowed.
    pub const fn closed(min: f64, max: f64) -> Range {
        Range { min, min_included: true, max, max_included: true }
    }

    /// Whether the number lies inside; NaN never does.
    pub fn contains(&self, value: f64) -> bool {
        let low = value > self.min || (self.min_included && value == self.min);
        let high = value < self.max || (self.max_included && value == self.max);
        low && high
    }
}
