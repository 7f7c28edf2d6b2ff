//! Parameters of CYCLE979 in the order of the manual's tables (B:6975-7004, B:7157-7174).

pub use crate::catalogue::common::{TOOL_OFFSET as TOOL, ZERO_OFFSET as ZERO};
use crate::catalogue::prelude::*;

/// Hole or shaft: three or four points.
pub const ROUND: When = mvar(1, &[1, 2]);
/// Groove or web: two points.
pub const WIDTH: When = mvar(1, &[3, 4]);
/// Shaft or web.
pub const OUTSIDE: When = mvar(1, &[2, 4]);
/// Web.
pub const WEB: When = mvar(1, &[4]);
/// Four points instead of three, in the fourth digit of the probe number (B:6744-6752).
pub const FOUR_POINTS: When = When::Digit { param: names::PRNUM, place: 1000, is: &[1] };

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one(
        "mvar-element",
        1,
        &[(1, "element-hole"), (2, "element-shaft"), (3, "element-groove"), (4, "element-web")],
    ),
    common::CORRECTION_DIGIT,
];

/// Points, type and number of the probe (B:6744-6752).
const PRNUM_DIGITS: &[DigitGroup] = &[
    DigitGroup { when: ROUND, ..DigitGroup::one("prnum-points", 1000, &[(0, "prnum-three"), (1, "prnum-four")]) },
    PROBE_TYPE,
    common::PROBE_NUMBER,
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "1", source: "B:6764-6773", ..common::MVAR },
    Param {
        range: Range::POSITIVE,
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ROUND, "setval-diameter"), (WIDTH, "setval-width-angle")],
        example: "130",
        source: "B:6979",
        ..common::SETVAL
    },
    Param { needs: common::ALWAYS_REQUIRED, example: "180", source: "B:6980-6981;B:6888-6893", ..common::CPA },
    Param { needs: common::ALWAYS_REQUIRED, example: "0", source: "B:6982-6983;B:6888-6893", ..common::CPO },
    Param {
        range: common::TURN,
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ROUND, "sta1-first"), (WIDTH, "sta1-width")],
        example: "15",
        source: "B:6984",
        ..common::STA1
    },
    Param {
        range: common::TURN,
        needs: &[required(ROUND, "need-points")],
        example: "80",
        source: "B:6986",
        ..common::INCA
    },
    Param { needs: &[required(ROUND, "need-circular")], example: "900", source: "B:6994;B:6911-6913", ..common::RF },
    Param {
        needs: &[required(WEB, "need-lift")],
        labels: &[(When::Always, "id-lift")],
        source: "B:6985;B:6921-6929",
        ..common::ID
    },
    Param { example: "2001", source: "B:6995;B:7170", ..common::KNUM },
    Param { example: "20", source: "B:6996", ..common::TNUM },
    Param { source: "B:6997", ..common::TNAME },
    Param { source: "B:6998", ..common::DLNUM },
    Param { source: "B:6999", ..common::TENV },
    Param {
        kind: Kind::Digits(PRNUM_DIGITS),
        range: Range::closed(1.0, 1199.0),
        labels: &[(ROUND, "prnum-with-points")],
        source: "B:6744-6752",
        ..common::PRNUM
    },
    Param { example: "2", source: "B:6905-6911;B:6941-6945", ..common::FA },
    Param { labels: &[(TOOL, "tsa-size"), (ZERO, "tsa-centre")], source: "B:7011;B:7178", ..common::TSA },
    Param { source: "B:7004;B:7174", ..common::VMS },
    Param { source: "B:7004;B:7174", ..common::NMSP },
    Param { source: "B:7007;B:7176", ..common::CORA },
    Param { needs: &[optional(TOOL, "need-memory")], example: "20", source: "B:7004;B:6965", ..common::EVNUM },
    Param { source: "B:7004;B:2358-2366", ..common::K },
    Param { source: "B:7004;B:7009", ..common::TZL },
    Param { source: "B:7004;B:7009", ..common::TMV },
    Param { source: "B:7004;B:7009", ..common::TUL },
    Param { source: "B:7004;B:7009", ..common::TLL },
    Param { source: "B:7004;B:7009", ..common::TDIF },
];
