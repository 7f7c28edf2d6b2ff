//! The log of a measurement on such a control.

/// A log.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Log {
    /// Cycle that wrote it.
    pub cycle: String,
    /// Date as written.
    pub date: String,
    /// Time as written.
    pub time: String,
    /// Program that measured.
    pub program: String,
    /// Whether its lengths are inches.
    pub is_inch: bool,
    /// What was measured.
    pub rows: Vec<LogRow>,
    /// Lines, from 1, at whose figure something else stands.
    pub unread: Vec<u32>,
}

/// A figure of a log, with a decimal point or comma, as the control is set.
pub fn figure(text: &str) -> Option<f64> {
    text.trim().replacen(',', ".", 1).parse().ok().filter(|value: &f64| value.is_finite())
}

/// What was measured, and its limits; figures as written, empty where there is none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LogRow {
    /// Line of the actual value, from 1.
    pub line: u32,
    /// What the control calls it.
    pub label: String,
    /// Set value.
    pub nominal: String,
    /// Largest permissible value.
    pub maximum: String,
    /// Smallest permissible value.
    pub minimum: String,
    /// Actual value.
    pub actual: String,
    /// Actual value minus set value.
    pub deviation: String,
}
