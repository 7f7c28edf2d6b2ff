//! Parameters of CYCLE973 in the order of the manual's tables (B:10239-10255, B:10347-10356).

use crate::catalogue::lathe::params as lathe;
use crate::catalogue::prelude::*;

/// On a surface of the workpiece system.
pub const SURFACE: When = When::Variant(&[0]);
/// In a reference groove of the machine.
pub const GROOVE: When = When::Not(&SURFACE);
/// In the groove in one direction; 13 is written for 1013 (A:11504).
pub const ONE: When = When::Variant(&[13, 1013]);
/// In the groove in both directions of an axis.
pub const TWO: When = mvar(1000, &[2]);
/// With the active ball diameter.
pub const BALL: When = mvar(100, &[1]);
/// With the position deviation.
pub const SKEW: When = mvar(10_000, &[1]);

/// B:10163-10173.
const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup {
        choices: &[(0, "calibrate-surface"), (13, "calibrate-groove")],
        ..DigitGroup::number("calibrate-place", 1, 2)
    },
    DigitGroup::one(
        "calibrate-directions",
        1000,
        &[(0, "calibrate-one-short"), (1, "calibrate-one"), (2, "calibrate-two")],
    ),
    common::BALL_DIGIT,
    DigitGroup::one("calibrate-position", 10_000, &[(0, "calibrate-skew-without"), (1, "calibrate-skew-with")]),
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "0", source: "B:10163-10177;B:15498-15500", ..common::MVAR },
    Param {
        needs: &[required(SURFACE, "need-surface-position")],
        labels: &[(lathe::DIAMETER_IN_X, "setval-surface-diameter"), (When::Always, "setval-surface")],
        example: "-18",
        source: "B:10350;A:16313",
        ..common::SETVAL
    },
    Param {
        kind: Kind::ChoiceBy(&[
            (GROOVE, &[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate")]),
            (When::Always, &[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate"), (3, "ma-lathe-applicate")]),
        ]),
        needs: &[required(SURFACE, "need-axis-calibration-surface"), required(GROOVE, "need-axis-calibrated")],
        labels: &[(GROOVE, "ma-calibrated")],
        example: "1",
        source: "B:10249;B:10351;B:10354",
        ..lathe::MA
    },
    Param {
        needs: &[required(When::Any(&[ONE, SURFACE]), "need-direction")],
        example: "1",
        source: "B:10250-10251;B:10352",
        ..common::MD
    },
    Param {
        kind: Kind::Integer,
        range: Range { min: 1.0, min_included: true, ..Range::ANY },
        alarm: Some(Code::Alarm(61333)),
        needs: &[required(GROOVE, "need-groove")],
        ..param(names::CALNUM, "calnum", "B:10252;B:15486;A:15876")
    },
    Param { source: "B:10253;B:10353;A:16310", ..lathe::PRNUM },
    Param { labels: &[(When::Always, "fa-lathe")], example: "3", source: "B:10255;B:10356;B:15491", ..common::FA },
    Param { labels: &[(When::Always, "tsa-trigger")], source: "B:10263;B:10360;B:15520", ..common::TSA },
    Param { source: "B:10255;B:10356;B:15522", ..common::VMS },
    Param { source: "B:10255;B:10356;B:15501", ..common::NMSP },
    Param {
        needs: common::ALWAYS_OPTIONAL,
        labels: &[(When::Always, "tzl-trigger")],
        example: "0",
        source: "B:10255;B:10356;B:15521",
        ..common::TZL
    },
];
