//! Addresses of G110 (C:1075-1101).

use crate::catalogue::common::{ALWAYS_REQUIRED, PARAM, optional};
use crate::catalogue::nct::{FORMAT_ERROR, LENGTH, NUMBER, PRINT, REGISTER};
use crate::catalogue::{Need, Param, Range, Unit, When};
use crate::control::Plane;

/// The address of the tool axis makes it a boss, whatever its value (C:1076).
const AXIS: Param = Param {
    unit: Unit::ActiveLength,
    chooses: Some(super::BOSS),
    source: "C:1076",
    ..PARAM
};

const fn in_plane(plane: Plane) -> Need {
    optional(When::Plane(plane), "need-g110-boss")
}

/// In the order of the block format.
pub const PARAMS: &[Param] = &[
    Param {
        name: "D",
        key: "g110-d",
        unit: Unit::ActiveLength,
        range: Range::POSITIVE,
        usual: Range::closed(1.0, 1000.0),
        alarm: Some(FORMAT_ERROR),
        needs: ALWAYS_REQUIRED,
        source: "C:1075",
        ..PARAM
    },
    Param {
        name: "X",
        key: "g110-axis",
        needs: &[in_plane(Plane::G19)],
        ..AXIS
    },
    Param {
        name: "Y",
        key: "g110-axis",
        needs: &[in_plane(Plane::G18)],
        ..AXIS
    },
    Param {
        name: "Z",
        key: "g110-axis",
        needs: &[in_plane(Plane::G17)],
        ..AXIS
    },
    Param {
        name: "R",
        key: "g110-r",
        default: Some(5.0),
        default_inch: Some(0.2),
        range: Range::POSITIVE,
        needs: &[optional(When::Variant(&[super::BOSS]), "need-nct-optional")],
        source: "C:1077",
        ..LENGTH
    },
    Param {
        name: "Q",
        key: "g110-q",
        default: Some(10.0),
        default_inch: Some(0.4),
        range: Range::POSITIVE,
        needs: &[optional(When::Always, "need-nct-optional")],
        source: "C:1078",
        ..LENGTH
    },
    Param {
        name: "S",
        key: "g110-s",
        range: Range::closed(0.0, 6.0),
        alarm: Some(FORMAT_ERROR),
        source: "C:1079",
        ..NUMBER
    },
    Param {
        name: "T",
        key: "g110-t",
        source: "C:1097",
        ..REGISTER
    },
    Param {
        name: "M",
        key: "g110-m",
        source: "C:1091",
        ..REGISTER
    },
    Param {
        name: "H",
        key: "g110-h",
        range: Range::NOT_NEGATIVE,
        source: "C:1098",
        ..LENGTH
    },
    Param {
        name: "U",
        key: "g110-u",
        range: Range::NOT_NEGATIVE,
        source: "C:1099",
        ..LENGTH
    },
    Param {
        name: "V",
        key: "g110-v",
        source: "C:1100",
        ..PRINT
    },
    Param {
        name: "W",
        key: "g110-w",
        source: "C:1101",
        ..PRINT
    },
];
