//! Tolerances and memories: when something is corrected, and by how much.

use super::{ALWAYS_OPTIONAL, PARAM, TOOL_OFFSET, ZERO_OFFSET, optional};
use crate::diagnostic::Code;
use crate::entry::{DigitGroup, Kind, Need, Param, Unit, names};
use crate::range::Range;

/// Halves of `_EVNUM` (B:2325-2342).
pub const MEMORY_DIGITS: &[DigitGroup] = &[
    DigitGroup { key: "evnum-mean", place: 10_000, digits: 4, choices: &[] },
    DigitGroup { key: "evnum-empirical", place: 1, digits: 4, choices: &[] },
];

/// Limits of the correction belong to the tool offset.
const TOLERANCE: &[Need] = &[optional(TOOL_OFFSET, "need-tolerance")];

/// `_TSA`.
pub const TSA: Param = Param {
    name: names::TSA,
    key: "tsa",
    unit: Unit::BasicLength,
    default: Some(2.0),
    range: Range::POSITIVE,
    watches: true,
    needs: ALWAYS_OPTIONAL,
    source: "B:15666",
    ..PARAM
};

/// `_EVNUM`.
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

/// `_K`.
pub const K: Param = Param {
    name: names::K,
    key: "k",
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61318)),
    needs: &[optional(TOOL_OFFSET, "need-memory")],
    source: "B:2358-2366;A:15859",
    ..PARAM
};

/// `_TZL`.
pub const TZL: Param = Param {
    name: names::TZL,
    key: "tzl",
    unit: Unit::BasicLength,
    default: Some(0.001),
    range: Range::NOT_NEGATIVE,
    needs: TOLERANCE,
    source: "B:15667;A:2323",
    ..PARAM
};

/// `_TMV`.
pub const TMV: Param = Param {
    name: names::TMV,
    key: "tmv",
    unit: Unit::BasicLength,
    default: Some(0.7),
    range: Range::POSITIVE,
    needs: TOLERANCE,
    source: "B:15660",
    ..PARAM
};

/// `_TUL`.
pub const TUL: Param = Param {
    name: names::TUL,
    key: "tul",
    unit: Unit::ActiveLength,
    default: Some(1.0),
    needs: TOLERANCE,
    source: "B:15664;A:1896",
    ..PARAM
};

/// `_TLL`.
pub const TLL: Param = Param {
    name: names::TLL,
    key: "tll",
    unit: Unit::ActiveLength,
    default: Some(-1.0),
    needs: TOLERANCE,
    source: "B:15665;A:1897",
    ..PARAM
};

/// `_TDIF`.
pub const TDIF: Param = Param {
    name: names::TDIF,
    key: "tdif",
    unit: Unit::BasicLength,
    default: Some(1.2),
    range: Range::POSITIVE,
    watches: true,
    needs: TOLERANCE,
    source: "B:15659",
    ..PARAM
};
