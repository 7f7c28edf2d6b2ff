//! What G65 P9920 leaves: the place of the probe, or a tool (C:1193-1200, C:1245).

use super::{CALIBRATE, DIAMETER, LENGTH};
use crate::catalogue::nct::{params, ring};
use crate::entry::{ResultField, When};

/// All of them.
pub const RESULTS: &[ResultField] = &[
    calibrated("#506", "result-p9920-z", "C:1193"),
    calibrated("#507", "result-p9920-x", "C:1194"),
    calibrated("#508", "result-p9920-y", "C:1195"),
    calibrated("#509", "result-p9920-disk", "C:1196;C:1202"),
    calibrated("#513", "result-p9920-reference", "C:1200"),
    ResultField {
        when: When::Variant(&[LENGTH, DIAMETER]),
        ..params::length("LENGTH", "result-p9920-length", "C:1245")
    },
    ResultField { when: When::Variant(&[DIAMETER]), ..params::length("DIAMETER", "result-p9920-diameter", "C:1245") },
];

const fn calibrated(name: &'static str, key: &'static str, source: &'static str) -> ResultField {
    ResultField { when: When::Variant(&[CALIBRATE]), ..ring::value(name, key, source) }
}
