//! Parameters of CYCLE998 in the order of the manual's tables (B:7395-7422, B:7602-7620).

pub use crate::catalogue::common::DIFFERENTIAL;
use crate::catalogue::prelude::*;

/// One angle, from two points.
pub const ONE: When = mvar(1, &[5]);
/// Two angles, from three points.
pub const TWO: When = mvar(1, &[6]);
/// Between the points along the set angle and away from the surface.
pub const AT_ANGLE: When = mvar(100_000, &[0]);
/// Between the points along an axis.
pub const PARAXIAL: When = mvar(100_000, &[1]);

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one("mvar-angles", 1, &[(5, "angles-one"), (6, "angles-two")]),
    common::ZERO_DIGIT,
    common::DIFFERENTIAL_DIGIT,
    DigitGroup::one("mvar-positioning", 100_000, &[(0, "positioning-angle"), (1, "positioning-paraxial")]),
];

/// Offset axis and measuring axis; differential measurement has to measure in the plane (B:7403-7408, B:7582).
const AXES: &[(When, &[(i64, &str)])] = &[
    (DIFFERENTIAL, &[(102, "ma-102"), (201, "ma-201"), (301, "ma-301"), (302, "ma-302")]),
    (
        When::Always,
        &[(102, "ma-102"), (103, "ma-103"), (201, "ma-201"), (203, "ma-203"), (301, "ma-301"), (302, "ma-302")],
    ),
];

/// The largest angle that can be measured (B:7306-7308).
const MEASURABLE: Range = Range::closed(-45.0, 45.0);

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "105", source: "B:7318-7324", ..common::MVAR },
    Param {
        needs: &[required(AT_ANGLE, "need-set-position")],
        labels: &[(ONE, "setval-point"), (TWO, "setval-point-applicate")],
        example: "-18",
        source: "B:7400;B:7606;B:15907-15909",
        ..common::SETVAL
    },
    Param {
        kind: Kind::ChoiceBy(AXES),
        range: Range::closed(102.0, 302.0),
        needs: &[required(ONE, "need-axes-angle")],
        labels: &[(When::Always, "ma-offset")],
        example: "102",
        source: "B:7403-7408;B:7502",
        ..common::MA
    },
    Param {
        needs: &[required(PARAXIAL, "need-direction-paraxial")],
        alarm: None, // A:15867 names 61326 for other cycles only
        source: "B:7412;B:7609;B:15888",
        ..common::MD
    },
    Param {
        range: Range::POSITIVE,
        usual: Range::closed(5.0, 5000.0),
        alarm: Some(Code::Alarm(61364)),
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ONE, "id-points"), (TWO, "id-points-abscissa")],
        example: "40",
        source: "B:7409;B:7610;A:15908",
        ..common::ID
    },
    Param {
        range: Range::POSITIVE,
        usual: Range::closed(5.0, 5000.0),
        needs: &[required(TWO, "need-third-point")],
        labels: &[(When::Always, "setv0-points")],
        source: "B:7611;B:15910",
        ..common::SETV0
    },
    Param {
        range: MEASURABLE,
        alarm: Some(Code::Alarm(61331)),
        needs: common::ALWAYS_REQUIRED,
        labels: &[(ONE, "sta1-edge"), (TWO, "sta1-about-abscissa")],
        example: "0",
        source: "B:7401-7402;B:7607;B:7308;A:15874",
        ..common::STA1
    },
    Param {
        range: MEASURABLE,
        needs: &[required(TWO, "need-second-angle")],
        labels: &[(When::Always, "inca-about-ordinate")],
        source: "B:7608;B:7308",
        ..common::INCA
    },
    Param {
        name: names::RA,
        key: "ra",
        kind: Kind::Integer,
        range: Range::NOT_NEGATIVE,
        alarm: Some(Code::Alarm(61329)),
        needs: &[required(ONE, "need-rotary")],
        example: "4",
        source: "B:7381-7391;B:7410-7411;A:15872",
        ..common::PARAM
    },
    Param { example: "1", source: "B:7413;B:7612;B:15876-15882", ..common::KNUM_ZERO },
    Param { source: "B:7290-7299;B:15895-15901", ..common::PRNUM },
    Param { labels: &[(PARAXIAL, "fa-paraxial")], example: "8", source: "B:7418;B:7538-7540;B:7554", ..common::FA },
    Param {
        unit: Unit::Degree,
        usual: Range::closed(0.0, 30.0),
        labels: &[(When::Always, "tsa-angle")],
        example: "5",
        source: "B:7422;B:7546;B:7620",
        watches: false, // an angle, and with intermediate positioning part of the way (B:7620)
        ..common::TSA
    },
    Param { source: "B:7418;B:7616", ..common::VMS },
    Param { source: "B:7418;B:7616", ..common::NMSP },
    Param { source: "B:7420;B:7618", ..common::CORA_CALIBRATED },
    Param {
        kind: Kind::Integer,
        key: "evnum-tool",
        needs: &[optional(When::Always, "need-memory-empirical")],
        labels: &[],
        example: "0",
        source: "B:7286;B:7418;B:7616;B:1307",
        ..common::EVNUM
    },
];
