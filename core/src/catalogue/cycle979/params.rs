//! Parameters of CYCLE979 in the order of the manual's tables (B:6975-7004, B:7157-7174).

use crate::catalogue::common;
use crate::catalogue::common::{TOOL_OFFSET, ZERO_OFFSET, optional, required};
use crate::entry::{DigitGroup, Kind, Need, PROBE_TYPE, Param, When, names};
use crate::range::Range;

/// The element in the first digit of `_MVAR` is one of these.
pub const fn element(is: &'static [i64]) -> When {
    When::Digit { param: names::MVAR, place: 1, is }
}

/// Hole or shaft: three or four points.
pub const ROUND: When = element(&[1, 2]);
/// Groove or web: two points.
pub const WIDTH: When = element(&[3, 4]);
/// Shaft or web.
pub const OUTSIDE: When = element(&[2, 4]);
/// Web.
pub const WEB: When = element(&[4]);
/// With tool offset.
pub const TOOL: When = TOOL_OFFSET;
/// With ZO correction.
pub const ZERO: When = ZERO_OFFSET;
/// Four points instead of three, in the fourth digit of the probe number (B:6744-6752).
pub const FOUR_POINTS: When = When::Digit { param: names::PRNUM, place: 1000, is: &[1] };

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup {
        key: "mvar-element",
        place: 1,
        digits: 1,
        choices: &[(1, "element-hole"), (2, "element-shaft"), (3, "element-groove"), (4, "element-web")],
    },
    DigitGroup {
        key: "mvar-correction",
        place: 100,
        digits: 1,
        choices: &[(0, "correction-tool"), (1, "correction-zero")],
    },
];

/// Points, type and number of the probe (B:6744-6752).
const PRNUM_DIGITS: &[DigitGroup] = &[
    DigitGroup { key: "prnum-points", place: 1000, digits: 1, choices: &[(0, "prnum-three"), (1, "prnum-four")] },
    PROBE_TYPE,
    common::PROBE_NUMBER,
];

/// Tolerance parameters belong to the tool offset.
const TOLERANCE: &[Need] = &[optional(TOOL, "need-tolerance")];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), source: "B:6764-6773", ..common::MVAR },
    Param {
        range: Range::POSITIVE,
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ROUND, "setval-diameter"), (WIDTH, "setval-width-angle")],
        source: "B:6979",
        ..common::SETVAL
    },
    Param { needs: common::ALWAYS_REQUIRED, source: "B:6980-6981;B:6888-6893", ..common::CPA },
    Param { needs: common::ALWAYS_REQUIRED, source: "B:6982-6983;B:6888-6893", ..common::CPO },
    Param {
        range: Range::closed(-360.0, 360.0),
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ROUND, "sta1-first"), (WIDTH, "sta1-width")],
        source: "B:6984",
        ..common::STA1
    },
    Param {
        range: Range::closed(-360.0, 360.0),
        needs: &[required(ROUND, "need-points")],
        source: "B:6986",
        ..common::INCA
    },
    Param { needs: &[required(ROUND, "need-circular")], source: "B:6994;B:6911-6913", ..common::RF },
    Param {
        needs: &[required(WEB, "need-lift")],
        labels: &[(When::Always, "id-lift")],
        source: "B:6985;B:6921-6929",
        ..common::ID
    },
    Param { labels: &[(TOOL, "knum-tool"), (ZERO, "knum-zero")], source: "B:6995;B:7170", ..common::KNUM },
    Param { source: "B:6996", ..common::OFFSET_TNUM },
    Param { source: "B:6997", ..common::OFFSET_TNAME },
    Param { source: "B:6998", ..common::OFFSET_DLNUM },
    Param { source: "B:6999", ..common::OFFSET_TENV },
    Param {
        kind: Kind::Digits(PRNUM_DIGITS),
        range: Range::closed(1.0, 1199.0),
        labels: &[(ROUND, "prnum-with-points")],
        source: "B:6744-6752",
        ..common::PRNUM
    },
    Param { source: "B:6905-6911;B:6941-6945", ..common::FA },
    Param { labels: &[(TOOL, "tsa-size"), (ZERO, "tsa-centre")], source: "B:7011;B:7178", ..common::TSA },
    Param { source: "B:7004;B:7174", ..common::VMS },
    Param { source: "B:7004;B:7174", ..common::NMSP },
    Param { source: "B:7007;B:7176", ..common::CORA },
    Param { needs: &[optional(TOOL, "need-memory")], source: "B:7004;B:6965", ..common::EVNUM },
    Param { needs: &[optional(TOOL, "need-memory")], source: "B:7004;B:2358-2366", ..common::K },
    Param { needs: TOLERANCE, source: "B:7004;B:7009", ..common::TZL },
    Param { needs: TOLERANCE, source: "B:7004;B:7009", ..common::TMV },
    Param { needs: TOLERANCE, source: "B:7004;B:7009", ..common::TUL },
    Param { needs: TOLERANCE, source: "B:7004;B:7009", ..common::TLL },
    Param { needs: TOLERANCE, source: "B:7004;B:7009", ..common::TDIF },
];
