//! Parameters of CYCLE976 in the order of the manual's tables (B:5154-5166, B:5252-5260, B:5364-5373, B:5496-5509).

use crate::catalogue::prelude::*;

/// In a hole.
pub const HOLE: When = mvar(1, &[1, 8]);
/// In a hole whose centre is not known: two runs, the first with the spindle turned.
pub const UNKNOWN: When = mvar(1, &[8]);
/// On a surface, without the probe length.
pub const SURFACE: When = When::Variant(&[0]);
/// On a surface in the applicate, with the probe length.
pub const LENGTH: When = When::Variant(&[10_000]);
/// One direction in a hole.
pub const ONE: When = mvar(1000, &[1]);
/// Both directions of one axis in a hole.
pub const TWO: When = mvar(1000, &[2]);
/// All four directions in a hole.
pub const FOUR: When = When::All(&[HOLE, mvar(1000, &[0])]);
/// With the active ball diameter.
pub const BALL: When = mvar(100, &[1]);
/// With the skew.
pub const SKEW: When = When::All(&[HOLE, mvar(10_000, &[1])]);
/// At the angle `_STA1`.
pub const ANGLE: When = mvar(100_000, &[1]);

/// B:5066-5080; the second digit is always 0.
const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one(
        "calibrate-place",
        1,
        &[(1, "calibrate-known"), (8, "calibrate-unknown"), (0, "calibrate-surface")],
    ),
    DigitGroup::one("calibrate-directions", 1000, &[(0, "calibrate-four"), (1, "calibrate-one"), (2, "calibrate-two")]),
    common::BALL_DIGIT,
    DigitGroup::one("calibrate-skew", 10_000, &[(0, "calibrate-skew-without"), (1, "calibrate-skew-with")]),
    DigitGroup::one("calibrate-angle", 100_000, &[(0, "calibrate-paraxial"), (1, "calibrate-at-angle")]),
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "10101", source: "B:5060-5084", ..common::MVAR },
    Param {
        needs: common::ALWAYS_REQUIRED,
        labels: &[(HOLE, "setval-ring"), (When::Always, "setval-surface")],
        example: "110.246",
        source: "B:5155;B:5253;B:5365;B:5497",
        ..common::SETVAL
    },
    Param {
        kind: Kind::ChoiceBy(&[
            (HOLE, &[(1, "ma-abscissa"), (2, "ma-ordinate")]),
            (LENGTH, &[(3, "ma-applicate")]),
            (When::Always, &[(1, "ma-abscissa"), (2, "ma-ordinate"), (3, "ma-applicate")]),
        ]),
        range: Range::closed(1.0, 3.0),
        needs: &[
            required(When::Any(&[ONE, TWO]), "need-axis-calibrated"),
            required(SURFACE, "need-axis-calibration-surface"),
            required(LENGTH, "need-axis-length"),
        ],
        labels: &[(When::Any(&[ONE, TWO]), "ma-calibrated")],
        source: "B:5156-5157;B:5366;B:5498",
        ..common::MA
    },
    Param {
        needs: &[required(When::Any(&[ONE, SURFACE, LENGTH]), "need-direction")],
        source: "B:5158-5159;B:5367-5368;B:5499-5500",
        ..common::MD
    },
    Param { example: "3", source: "B:5160;B:5254", ..common::PRNUM },
    Param {
        needs: &[required(ANGLE, "need-angle-calibration")],
        labels: &[(When::Always, "sta1-calibration")],
        source: "B:5161-5162;B:5255-5256",
        ..common::STA1
    },
    Param {
        labels: &[(UNKNOWN, "fa-unknown"), (LENGTH, "fa-length")],
        example: "1",
        source: "B:5166;B:5260;B:5373;B:5589",
        ..common::FA
    },
    Param { labels: &[(When::Always, "tsa-trigger")], source: "B:5134;B:5148;B:5509", ..common::TSA },
    Param { source: "B:5166", ..common::VMS },
    Param { source: "B:5166", ..common::NMSP },
    Param { source: "B:5166-5168", ..common::CORA },
    Param {
        needs: common::ALWAYS_OPTIONAL,
        labels: &[(When::Always, "tzl-trigger")],
        example: "0",
        source: "B:5134;B:5166",
        ..common::TZL
    },
];

/// What the variants calibrate beside the ring: the surface of B:5423-5432, the length of B:5564-5569, and an unknown
/// centre that the path bridges (B:5282-5289).
pub const EXAMPLES: Examples = &[
    (When::Any(&[ONE, TWO]), &[(names::MA, "1"), (names::MD, "0")]),
    (ANGLE, &[(names::STA1, "30")]),
    (UNKNOWN, &[(names::PRNUM, "2"), (names::FA, "55.123")]),
    (
        When::Any(&[SURFACE, LENGTH]),
        &[
            (names::SETVAL, "20"),
            (names::MA, "3"),
            (names::MD, "1"),
            (names::PRNUM, "1"),
            (names::TSA, "4"),
            (names::FA, "2"),
        ],
    ),
    (LENGTH, &[(names::TSA, "25"), (names::FA, "12")]),
];
