//! Tolerances and memories: when something is corrected, and by how much.

use super::{ALWAYS_OPTIONAL, TOOL_OFFSET, ZERO_OFFSET};
use crate::catalogue::prelude::*;

/// Halves of `_EVNUM`; a mean value counts with tool offset alone (B:2325-2342, B:1307).
pub const MEMORY_DIGITS: &[DigitGroup] = &[
    DigitGroup { when: TOOL_OFFSET, ..DigitGroup::number("evnum-mean", 10_000, 4) },
    DigitGroup::number("evnum-empirical", 1, 4),
];

const WITH_TOOL: &[Need] = &[optional(TOOL_OFFSET, "need-tolerance")];

/// A limit of the correction, which belongs to the tool offset.
const fn limit(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { unit: Unit::BasicLength, range: Range::POSITIVE, needs: WITH_TOOL, ..param(name, key, source) }
}
/// A limit of the size.
const fn tolerance(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { unit: Unit::ActiveLength, range: Range::ANY, ..limit(name, key, source) }
}

pub const TSA: Param = Param {
    default: Some(2.0),
    watches: true,
    needs: ALWAYS_OPTIONAL,
    example: "1",
    ..limit(names::TSA, "tsa", "B:15666")
};
/// `_EVNUM`: a mean value counts with tool offset alone (B:1307).
pub const EVNUM: Param = Param {
    kind: Kind::Digits(MEMORY_DIGITS),
    default: Some(0.0),
    range: Range::closed(0.0, 99_999_999.0),
    needs: &[optional(TOOL_OFFSET, "need-memory"), optional(ZERO_OFFSET, "need-memory-empirical")],
    labels: &[(ZERO_OFFSET, "evnum-tool")],
    ..param(names::EVNUM, "evnum", "B:2303-2342;B:1307")
};
pub const K: Param = Param {
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61318)),
    needs: &[optional(TOOL_OFFSET, "need-default")],
    example: "3",
    ..param(names::K, "k", "B:2358-2366;A:15859")
};
pub const TZL: Param = Param {
    default: Some(0.001),
    range: Range::NOT_NEGATIVE,
    example: "0.01",
    ..limit(names::TZL, "tzl", "B:15667;A:2323")
};
pub const TMV: Param = Param { default: Some(0.7), example: "0.02", ..limit(names::TMV, "tmv", "B:15660") };
pub const TUL: Param = Param { default: Some(1.0), example: "0.03", ..tolerance(names::TUL, "tul", "B:15664;A:1896") };
pub const TLL: Param =
    Param { default: Some(-1.0), example: "-0.03", ..tolerance(names::TLL, "tll", "B:15665;A:1897") };
pub const TDIF: Param =
    Param { default: Some(1.2), watches: true, example: "0.06", ..limit(names::TDIF, "tdif", "B:15659") };
