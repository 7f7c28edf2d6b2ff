//! What is corrected: `_KNUM` and the tool that it means.

use super::{ALWAYS_REQUIRED, PARAM, TOOL_OFFSET, ZERO_OFFSET, optional, required};
use crate::catalogue::prelude::*;

/// The digit of `_KNUM` that tells length/radius from setup/additive offsets and `_TENV` (7th, or 9th with 5-digit D).
const fn knum_kind(is: &'static [i64]) -> When {
    When::Digit { param: names::KNUM, place: 1_000_000, is }
}

/// A tool is corrected.
const TOOL_CORRECTED: When = When::All(&[TOOL_OFFSET, When::Given(names::KNUM)]);

/// `_KNUM` (B:1894-2029).
pub const KNUM: Param = Param {
    name: names::KNUM,
    key: "knum",
    kind: Kind::Knum,
    range: Range::closed(0.0, 399_999_999.0),
    needs: ALWAYS_REQUIRED,
    labels: &[(TOOL_OFFSET, "knum-tool"), (ZERO_OFFSET, "knum-zero")],
    source: "B:1894-2029",
    ..PARAM
};

/// `_KNUM` of a cycle that corrects zero offsets alone.
pub const KNUM_ZERO: Param = Param { labels: &[(When::Always, "knum-zero")], ..KNUM };

pub const TNUM: Param = Param {
    name: names::TNUM,
    key: "tnum",
    kind: Kind::Integer,
    range: Range::NOT_NEGATIVE,
    alarm: Some(Code::Alarm(61320)),
    needs: &[
        required(
            When::All(&[TOOL_CORRECTED, When::Not(&When::Given(names::TNAME)), When::Not(&When::Given(names::TENV))]),
            "need-tool",
        ),
        optional(TOOL_CORRECTED, "need-tool-otherwise"),
    ],
    source: "B:1872-1892",
    ..PARAM
};

pub const TNAME: Param = Param {
    name: names::TNAME,
    key: "tname",
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61343)),
    needs: &[optional(TOOL_CORRECTED, "need-tool-name")],
    source: "B:15661",
    ..PARAM
};

pub const DLNUM: Param = Param {
    name: names::DLNUM,
    key: "dlnum",
    kind: Kind::Integer,
    range: Range::closed(0.0, 6.0),
    alarm: Some(Code::Alarm(61406)),
    needs: &[required(When::All(&[TOOL_OFFSET, knum_kind(&[1, 3])]), "need-additive")],
    source: "B:2031-2043",
    ..PARAM
};

pub const TENV: Param = Param {
    name: names::TENV,
    key: "tenv",
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61405)),
    needs: &[required(When::All(&[TOOL_OFFSET, knum_kind(&[2, 3])]), "need-environment")],
    source: "B:2062-2102",
    ..PARAM
};
