//! Parameters of CYCLE977 in the order of the manual's tables (B:5989-6024, B:6181-6205).

pub use crate::catalogue::common::{TOOL_OFFSET as TOOL, ZERO_OFFSET as ZERO};
use crate::catalogue::prelude::*;

/// Hole or shaft.
pub const ROUND: When = mvar(1, &[1, 2]);
/// Groove or web.
pub const WIDTH: When = mvar(1, &[3, 4]);
/// Hole, shaft, groove or web.
pub const SINGLE: When = mvar(1, &[1, 2, 3, 4]);
/// Rectangle inside or outside.
pub const RECTANGLE: When = mvar(1, &[5, 6]);
/// Shaft, web, outside rectangle.
pub const OUTSIDE: When = mvar(1, &[2, 4, 6]);
/// With a protection zone.
pub const ZONE: When = mvar(1000, &[1]);

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one(
        "mvar-element",
        1,
        &[
            (1, "element-hole"),
            (2, "element-shaft"),
            (3, "element-groove"),
            (4, "element-web"),
            (5, "element-pocket"),
            (6, "element-island"),
        ],
    ),
    common::CORRECTION_DIGIT,
    DigitGroup::one("mvar-zone", 1000, &[(0, "zone-without"), (1, "zone-with")]),
];

/// Both lengths of a rectangle.
const LENGTHS: &[Need] = &[required(RECTANGLE, "need-rectangle")];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "1", source: "B:5641-5667", ..common::MVAR },
    Param {
        range: Range::POSITIVE,
        needs: &[required(SINGLE, "need-element")],
        labels: &[(ROUND, "setval-diameter"), (WIDTH, "setval-width")],
        example: "132",
        source: "B:5830",
        ..common::SETVAL
    },
    Param { range: Range::POSITIVE, needs: LENGTHS, source: "B:5831", ..common::SETV0 },
    Param { range: Range::POSITIVE, needs: LENGTHS, source: "B:5832", ..common::SETV1 },
    Param {
        needs: &[required(ZONE, "need-infeed-zone"), required(OUTSIDE, "need-infeed-outside")],
        source: "B:5833;B:5915",
        ..common::ID
    },
    Param {
        needs: &[required(ZONE, "need-zone")],
        labels: &[(ROUND, "sza-diameter"), (WIDTH, "sza-width"), (RECTANGLE, "sza-length")],
        source: "B:5834",
        ..common::SZA
    },
    Param { needs: &[required(When::All(&[ZONE, RECTANGLE]), "need-zone-rectangle")], source: "B:5835", ..common::SZO },
    Param { needs: &[required(WIDTH, "need-axis")], source: "B:5836", ..common::MA },
    Param { example: "2001", source: "B:6012-6014;B:6201", ..common::KNUM },
    Param { example: "20", source: "B:6015", ..common::TNUM },
    Param { source: "B:6016", ..common::TNAME },
    Param { source: "B:6017", ..common::DLNUM },
    Param { source: "B:6018", ..common::TENV },
    Param { source: "B:5632-5633;B:5841", ..common::PRNUM },
    Param { example: "1", source: "B:5841;B:5945;B:5963", ..common::FA },
    Param { labels: &[(TOOL, "tsa-size"), (ZERO, "tsa-centre")], source: "B:5847;B:6024;B:6221", ..common::TSA },
    Param { source: "B:5841", ..common::VMS },
    Param { source: "B:5841", ..common::NMSP },
    Param { source: "B:5849;B:15629", ..common::CORA },
    Param { needs: &[optional(TOOL, "need-memory")], example: "10", source: "B:5841;B:6022", ..common::EVNUM },
    Param { source: "B:6022;B:2358-2366", ..common::K },
    Param { source: "B:5845;B:15667", ..common::TZL },
    Param { source: "B:5845;B:15660", ..common::TMV },
    Param { source: "B:5845;B:15664", ..common::TUL },
    Param { source: "B:5845;B:15665", ..common::TLL },
    Param { source: "B:5845;B:15659", ..common::TDIF },
];

/// What the variants measure: the rectangle and the protection zones of about the size of the hole in the example.
pub const EXAMPLES: Examples = &[
    (ZERO, &[(names::KNUM, "1")]),
    (WIDTH, &[(names::MA, "1")]),
    (RECTANGLE, &[(names::SETV0, "100"), (names::SETV1, "80")]),
    (OUTSIDE, &[(names::ID, "-20"), (names::SZA, "180"), (names::SZO, "160")]),
    (When::All(&[ZONE, When::Not(&OUTSIDE)]), &[(names::ID, "-20"), (names::SZA, "50"), (names::SZO, "40")]),
];
