//! Parameters of CYCLE997 in the order of the manual's tables (B:8309-8337).

use crate::catalogue::prelude::*;

/// One sphere.
pub const ONE: When = mvar(10_000, &[0]);
/// Three spheres.
pub const THREE: When = mvar(10_000, &[1]);
/// Points at an angle, on circular paths.
pub const ANGLE: When = mvar(1000, &[1]);
/// Four points at an angle instead of three.
pub const FOUR_POINTS: When = mvar(100_000, &[1]);
/// With the diameter.
pub const DIAMETER: When = mvar(1_000_000, &[1]);
/// The whole sphere once more, about the centre that was found.
pub const REPEATED: When = mvar(10, &[1]);
/// A frame is turned and moved.
pub const TURNED: When = When::All(&[THREE, When::Given(names::KNUM)]);

/// B:8246-8259; the first and the third digit are always 9 and 1.
const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one("mvar-element", 1, &[(9, "element-sphere")]),
    DigitGroup::one("spheres-number", 10_000, &[(0, "spheres-one"), (1, "spheres-three")]),
    DigitGroup::one("spheres-way", 1000, &[(0, "spheres-paraxial"), (1, "spheres-angle")]),
    DigitGroup::one("spheres-points", 100_000, &[(0, "spheres-points-three"), (1, "spheres-points-four")]),
    DigitGroup::one("spheres-diameter", 1_000_000, &[(0, "spheres-diameter-known"), (1, "spheres-diameter-find")]),
    DigitGroup::one("spheres-repeat", 10, &[(0, "spheres-once"), (1, "spheres-twice")]),
    common::ZERO_DIGIT,
];

/// A coordinate of the set centre of the first sphere.
const FIRST: Param = Param { needs: common::ALWAYS_REQUIRED, example: "100", ..common::SETVAL };
/// A coordinate of the set centre of the second or the third sphere.
const OTHER: Param = Param { needs: &[required(THREE, "need-spheres")], ..FIRST };

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "10109", source: "B:8242-8259;B:15849-15850", ..common::MVAR },
    Param {
        range: Range::POSITIVE,
        alarm: Some(Code::Alarm(61413)),
        needs: common::ALWAYS_REQUIRED,
        labels: &[(When::Always, "setval-sphere")],
        example: "50",
        source: "B:8311;A:15932",
        ..common::SETVAL
    },
    Param { name: names::SETV0, key: "sphere1-abscissa", source: "B:8312", ..FIRST },
    Param { name: names::SETV1, key: "sphere1-ordinate", source: "B:8313", ..FIRST },
    Param { name: names::SETV2, key: "sphere1-applicate", source: "B:8314", ..FIRST },
    Param { name: names::SETV3, key: "sphere2-abscissa", example: "600", source: "B:8315", ..OTHER },
    Param { name: names::SETV4, key: "sphere2-ordinate", source: "B:8316", ..OTHER },
    Param { name: names::SETV5, key: "sphere2-applicate", source: "B:8317", ..OTHER },
    Param { name: names::SETV6, key: "sphere3-abscissa", example: "1100", source: "B:8321", ..OTHER },
    Param { name: names::SETV7, key: "sphere3-ordinate", example: "1100", source: "B:8322", ..OTHER },
    Param { name: names::SETV8, key: "sphere3-applicate", source: "B:8323", ..OTHER },
    Param {
        needs: &[required(ANGLE, "need-start-angle")],
        labels: &[(When::Always, "sta1-first")],
        source: "B:8327;B:8457",
        ..common::STA1
    },
    Param { range: common::TURN, needs: &[required(ANGLE, "need-points")], source: "B:8328;B:8457", ..common::INCA },
    Param {
        alarm: None, // 61365 is named for CYCLE979 only (A:15909)
        needs: &[required(ANGLE, "need-circular")],
        source: "B:8324-8325;B:8461",
        ..common::RF
    },
    Param { example: "1", source: "B:8326;B:15847-15848", ..common::KNUM_ZERO },
    Param {
        name: names::TNVL,
        key: "tnvl",
        unit: Unit::BasicLength,
        default: Some(1.2),
        range: Range::POSITIVE,
        needs: &[optional(TURNED, "need-distortion")],
        example: "1.2",
        source: "B:8329-8331;B:15859;B:1774",
        ..common::PARAM
    },
    Param {
        kind: Kind::Digits(&[common::PROBE_NUMBER]),
        labels: &[(When::Always, "prnum-multi-only")],
        source: "B:8201;B:15852",
        ..common::PRNUM
    },
    Param { labels: &[(When::Always, "fa-sphere")], example: "5", source: "B:8337;B:8429;B:8437-8445", ..common::FA },
    Param { labels: &[(When::Always, "tsa-sphere")], example: "", source: "B:8373-8379", ..common::TSA },
    Param { example: "200", source: "B:8337", ..common::VMS },
    Param { source: "B:8337", ..common::NMSP },
];
