//! What is corrected: `_KNUM` and the tool that it means.

use super::{TOOL_OFFSET, ZERO_OFFSET};
use crate::catalogue::prelude::*;

/// The digit of `_KNUM` that tells length/radius from setup/additive offsets and `_TENV` (7th, or 9th with 5-digit D).
const fn knum_kind(is: &'static [i64]) -> When {
    When::Digit { param: names::KNUM, place: 1_000_000, is }
}

/// A tool is corrected.
const TOOL_CORRECTED: When = When::All(&[TOOL_OFFSET, When::Given(names::KNUM)]);

/// `_KNUM` (B:1894-2029).
pub const KNUM: Param = Param {
    kind: Kind::Knum,
    range: Range::closed(0.0, 399_999_999.0),
    needs: ALWAYS_REQUIRED,
    labels: &[(TOOL_OFFSET, "knum-tool"), (ZERO_OFFSET, "knum-zero")],
    ..param(names::KNUM, "knum", "B:1894-2029")
};

/// `_KNUM` of a cycle that corrects zero offsets alone.
pub const KNUM_ZERO: Param = Param { labels: &[(When::Always, "knum-zero")], ..KNUM };

pub const TNUM: Param = Param {
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
    ..param(names::TNUM, "tnum", "B:1872-1892")
};

pub const TNAME: Param = Param {
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61343)),
    needs: &[optional(TOOL_CORRECTED, "need-tool-name")],
    ..param(names::TNAME, "tname", "B:15661")
};

pub const DLNUM: Param = Param {
    kind: Kind::Integer,
    range: Range::closed(0.0, 6.0),
    alarm: Some(Code::Alarm(61406)),
    needs: &[required(When::All(&[TOOL_OFFSET, knum_kind(&[1, 3])]), "need-additive")],
    ..param(names::DLNUM, "dlnum", "B:2031-2043")
};

pub const TENV: Param = Param {
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61405)),
    needs: &[required(When::All(&[TOOL_OFFSET, knum_kind(&[2, 3])]), "need-environment")],
    ..param(names::TENV, "tenv", "B:2062-2102")
};
