//! CYCLE978: one point on a surface parallel to an axis (B:6287-6735).

pub mod params;
mod results;
pub mod simulate;

use crate::catalogue::Variant;

/// Measuring variants (B:6323-6328).
pub const VARIANTS: &[Variant] = &[
    Variant {
        number: 0,
        key: "cycle978-tool",
        source: "B:6325;B:6596;A:7189",
    },
    Variant {
        number: 100,
        key: "cycle978-zero",
        source: "B:6326;B:6456;A:7190",
    },
    Variant {
        number: 1000,
        key: "cycle978-differential-tool",
        source: "B:6327;B:6597;A:7191",
    },
    Variant {
        number: 1100,
        key: "cycle978-differential-zero",
        source: "B:6328;B:6457;A:7192",
    },
];

pub use results::RESULTS;
