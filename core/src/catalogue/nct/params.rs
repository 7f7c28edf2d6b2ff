//! Addresses that macros share. A macro takes one and says what differs: `Param { source: "C:475", ..params::Q }`.

use super::{FORMAT_ERROR, LENGTH, NUMBER, PRINT, REGISTER};
use crate::catalogue::prelude::*;

/// X is the axis of the tool.
pub const ALONG_X: When = When::Plane(Plane::G19);
/// Y is the axis of the tool.
pub const ALONG_Y: When = When::Plane(Plane::G18);
/// Z is the axis of the tool.
pub const ALONG_Z: When = When::Plane(Plane::G17);

/// A coordinate of what is measured.
pub const COORDINATE: Param = Param { unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), ..PARAM };

const WAY: Param = Param { range: Range::POSITIVE, ..LENGTH };
/// Clearance beside a wall: 5 mm or 0.2 inch (C:474).
pub const R: Param = Param { name: address::R, key: "nct-r", default: Some(5.0), default_inch: Some(0.2), ..WAY };
/// Overtravel past the nominal surface: 10 mm or 0.4 inch (C:475).
pub const Q: Param = Param { name: address::Q, key: "nct-q", default: Some(10.0), default_inch: Some(0.4), ..WAY };
/// Work offset that is moved: 0 common, 1 to 6 (C:481).
pub const S: Param =
    Param { name: address::S, key: "nct-s", range: Range::closed(0.0, 6.0), alarm: Some(FORMAT_ERROR), ..NUMBER };
/// Register of the tool that is corrected; a macro adds the wording (C:495).
pub const T: Param = Param { name: address::T, ..REGISTER };
/// Unused register for the deviation (C:491).
pub const M: Param = Param { name: address::M, key: "nct-m", ..REGISTER };
/// Half of the tolerance (C:500).
pub const H: Param = Param { name: address::H, key: "nct-h", range: Range::NOT_NEGATIVE, ..LENGTH };
/// Deviation from which nothing is corrected (C:501).
pub const U: Param = Param { name: address::U, key: "nct-u", range: Range::NOT_NEGATIVE, ..LENGTH };
/// Prints the dimension (C:936).
pub const V: Param = Param { name: address::V, key: "nct-v", ..PRINT };
/// Prints the position (C:502).
pub const W: Param = Param { name: address::W, key: "nct-w", ..PRINT };

/// The macros leave no named results; these are what they work with, in the active unit.
pub const fn length(name: &'static str, key: &'static str, source: &'static str) -> ResultField {
    ResultField { name, key, when: When::Always, unit: Unit::ActiveLength, source }
}
