//! Tolerances and memories: when something is corrected, and by how much.

use super::{ALWAYS_OPTIONAL, PARAM, TOOL_OFFSET, ZERO_OFFSET, optional};
use crate::catalogue::prelude::*;

/// Halves of `_EVNUM` (B:2325-2342).
pub const MEMORY_DIGITS: &[DigitGroup] = &[
    DigitGroup { key: "evnum-mean", place: 10_000, digits: 4, choices: &[] },
    DigitGroup { key: "evnum-empirical", place: 1, digits: 4, choices: &[] },
];

/// A limit of the correction, which belongs to the tool offset.
const LIMIT: Param = Param {
    unit: Unit::BasicLength,
    range: Range::POSITIVE,
    needs: &[optional(TOOL_OFFSET, "need-tolerance")],
    ..PARAM
};
/// A limit of the size.
const TOLERANCE: Param = Param { unit: Unit::ActiveLength, range: Range::ANY, ..LIMIT };

pub const TSA: Param = Param {
    name: names::TSA,
    key: "tsa",
    default: Some(2.0),
    watches: true,
    needs: ALWAYS_OPTIONAL,
    example: "1",
    source: "B:15666",
    ..LIMIT
};
pub const EVNUM: Param = Param {
    name: names::EVNUM,
    key: "evnum",
    kind: Kind::Digits(MEMORY_DIGITS),
    default: Some(0.0),
    range: Range::closed(0.0, 99_999_999.0),
    needs: &[optional(TOOL_OFFSET, "need-memory"), optional(ZERO_OFFSET, "need-memory-empirical")],
    source: "B:2303-2342",
    ..PARAM
};
pub const K: Param = Param {
    name: names::K,
    key: "k",
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61318)),
    needs: &[optional(TOOL_OFFSET, "need-memory")],
    example: "3",
    source: "B:2358-2366;A:15859",
    ..PARAM
};
pub const TZL: Param = Param {
    name: names::TZL,
    key: "tzl",
    default: Some(0.001),
    range: Range::NOT_NEGATIVE,
    example: "0.01",
    source: "B:15667;A:2323",
    ..LIMIT
};
pub const TMV: Param =
    Param { name: names::TMV, key: "tmv", default: Some(0.7), example: "0.02", source: "B:15660", ..LIMIT };
pub const TUL: Param =
    Param { name: names::TUL, key: "tul", default: Some(1.0), example: "0.03", source: "B:15664;A:1896", ..TOLERANCE };
pub const TLL: Param = Param {
    name: names::TLL,
    key: "tll",
    default: Some(-1.0),
    example: "-0.03",
    source: "B:15665;A:1897",
    ..TOLERANCE
};
pub const TDIF: Param = Param {
    name: names::TDIF,
    key: "tdif",
    default: Some(1.2),
    watches: true,
    example: "0.06",
    source: "B:15659",
    ..LIMIT
};
