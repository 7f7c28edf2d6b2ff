//! Addresses of G65 P9969 (C:1284-1322).

use crate::catalogue::common::{ALWAYS_REQUIRED, PARAM, optional};
use crate::catalogue::nct::{FORMAT_ERROR, LENGTH, NUMBER};
use crate::control::Plane;
use crate::entry::{Param, Unit, When, address};
use crate::name::Name;
use crate::range::Range;

/// End of the rectangle, or the deepest position in the plane of which it is the tool axis.
const END: Param = Param {
    key: "p9969-end",
    unit: Unit::ActiveLength,
    alarm: Some(FORMAT_ERROR),
    needs: ALWAYS_REQUIRED,
    source: "C:1284-1312",
    ..PARAM
};

/// Distance of the lines; the letter says which axis is stepped along.
const SPACING: Param = Param {
    key: "p9969-spacing",
    range: Range::POSITIVE,
    usual: Range::closed(0.01, 50.0),
    alarm: Some(FORMAT_ERROR),
    ..LENGTH
};

const REQUIRED_LENGTH: Param = Param {
    unit: Unit::ActiveLength,
    range: Range::POSITIVE,
    alarm: Some(FORMAT_ERROR),
    needs: ALWAYS_REQUIRED,
    ..PARAM
};

/// In the order of the block format.
pub const PARAMS: &[Param] = &[
    Param { name: address::X, labels: &[(When::Plane(Plane::G19), "p9969-deepest")], ..END },
    Param { name: address::Y, labels: &[(When::Plane(Plane::G18), "p9969-deepest")], ..END },
    Param { name: address::Z, labels: &[(When::Plane(Plane::G17), "p9969-deepest")], ..END },
    Param {
        name: address::I,
        needs: &[optional(When::Any(&[When::Plane(Plane::G17), When::Plane(Plane::G18)]), "need-p9969-spacing")],
        source: "C:1289-1295",
        ..SPACING
    },
    Param {
        name: address::J,
        needs: &[optional(When::Any(&[When::Plane(Plane::G17), When::Plane(Plane::G19)]), "need-p9969-spacing")],
        source: "C:1286-1307",
        ..SPACING
    },
    Param {
        name: address::K,
        needs: &[optional(When::Any(&[When::Plane(Plane::G18), When::Plane(Plane::G19)]), "need-p9969-spacing")],
        source: "C:1298-1304",
        ..SPACING
    },
    Param { name: address::R, key: "p9969-r", usual: Range::closed(0.01, 5.0), source: "C:1316", ..REQUIRED_LENGTH },
    Param { name: address::Q, key: "p9969-q", usual: Range::closed(0.1, 20.0), source: "C:1317", ..REQUIRED_LENGTH },
    Param {
        name: address::F,
        key: "p9969-f",
        unit: Unit::BasicFeed,
        range: Range::POSITIVE,
        usual: Range::closed(1.0, 3000.0),
        needs: LENGTH.needs,
        source: "C:1318-1321",
        ..PARAM
    },
    Param { name: address::S, key: "p9969-s", range: Range::closed(1.0, 9999.0), source: "C:1322", ..NUMBER },
];

/// The address that is given, of the two that step along an axis of the plane, with the axis of the lines and the axis
/// from line to line; none where not exactly one is.
pub fn spacing(inputs: &crate::entry::Inputs) -> Option<(f64, usize, usize)> {
    let [first, second, _] = inputs.plane.axes();
    let given = [second, first].map(|axis| inputs.given(letter(axis)));
    match given {
        [Some(step), None] => Some((step, first, second)),
        [None, Some(step)] => Some((step, second, first)),
        _ => None,
    }
}

/// Address of the line spacing along an axis.
pub const fn letter(axis: usize) -> Name {
    [address::I, address::J, address::K][axis]
}
