//! Data that a cycle leaves.

use crate::catalogue::prelude::*;

/// A length in `_OVR[]`, whose unit the manual does not define: here the active unit counts.
pub const fn length(name: &'static str, key: &'static str, when: When, source: &'static str) -> ResultField {
    ResultField { name, key, when, unit: Unit::ActiveLength, source }
}

/// An angle in `_OVR[]`.
pub const fn angle(name: &'static str, key: &'static str, when: When, source: &'static str) -> ResultField {
    ResultField { name, key, when, unit: Unit::Degree, source }
}

/// A whole number in `_OVI[]`.
pub const fn integer(name: &'static str, key: &'static str, when: When, source: &'static str) -> ResultField {
    ResultField { name, key, when, unit: Unit::None, source }
}
