//! Addresses of G65 P9969 (C:1284-1322).

use crate::catalogue::nct::params::{ALONG_X, ALONG_Y, ALONG_Z};
use crate::catalogue::nct::{FORMAT_ERROR, LENGTH, NUMBER};
use crate::catalogue::prelude::*;

/// The address steps along an axis of these planes.
const fn steps(planes: &'static [When]) -> Need {
    optional(When::Any(planes), "need-p9969-spacing")
}

/// End of the rectangle, or the deepest position in the plane of which it is the tool axis.
const END: Param =
    Param { key: "p9969-end", alarm: Some(FORMAT_ERROR), needs: ALWAYS_REQUIRED, source: "C:1284-1312", ..LENGTH };

/// Distance of the lines; the letter says which axis is stepped along.
const SPACING: Param = Param {
    key: "p9969-spacing",
    range: Range::POSITIVE,
    usual: Range::closed(0.01, 50.0),
    alarm: Some(FORMAT_ERROR),
    ..LENGTH
};

/// A length of every step.
const fn step(name: Name, key: &'static str, source: &'static str) -> Param {
    let needs = ALWAYS_REQUIRED;
    Param { name, key, range: Range::POSITIVE, alarm: Some(FORMAT_ERROR), needs, source, ..LENGTH }
}

/// In the order of the block format.
pub const PARAMS: &[Param] = &[
    Param { name: address::X, labels: &[(ALONG_X, "p9969-deepest")], example: "60", ..END },
    Param { name: address::Y, labels: &[(ALONG_Y, "p9969-deepest")], example: "40", ..END },
    Param { name: address::Z, labels: &[(ALONG_Z, "p9969-deepest")], example: "-12", ..END },
    Param { name: address::I, needs: &[steps(&[ALONG_Z, ALONG_Y])], source: "C:1289-1295", ..SPACING },
    Param { name: address::J, needs: &[steps(&[ALONG_Z, ALONG_X])], example: "8", source: "C:1286-1307", ..SPACING },
    Param { name: address::K, needs: &[steps(&[ALONG_Y, ALONG_X])], source: "C:1298-1304", ..SPACING },
    Param { usual: Range::closed(0.01, 5.0), example: "3", ..step(address::R, "p9969-r", "C:1316") },
    Param { usual: Range::closed(0.1, 20.0), example: "4", ..step(address::Q, "p9969-q", "C:1317") },
    Param {
        name: address::F,
        key: "p9969-f",
        unit: Unit::BasicFeed,
        range: Range::POSITIVE,
        usual: Range::closed(1.0, 3000.0),
        example: "120",
        source: "C:1318-1321",
        ..LENGTH
    },
    Param {
        range: Range::closed(1.0, 9999.0),
        example: "1000",
        name: address::S,
        key: "p9969-s",
        source: "C:1322",
        ..NUMBER
    },
];

/// The address that is given, of the two that step along an axis of the plane, with the axis of the lines and the axis
/// from line to line; none where not exactly one is.
pub fn spacing(inputs: &Inputs) -> Option<(f64, usize, usize)> {
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
