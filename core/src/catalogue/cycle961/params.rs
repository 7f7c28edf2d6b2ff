//! Parameters of CYCLE961 in the order of the manual's tables (B:7915-7942, B:8052-8072).

use crate::catalogue::prelude::*;

/// Directions and distances are given, the points follow from them.
pub const DISTANCES: When = When::Variant(&[105, 106, 107, 108]);
/// The corner is one of a rectangle: three points.
pub const RECTANGLE: When = When::Variant(&[105, 106]);
/// The probe has to pass the corner from outside.
pub const PASSES: When = When::Variant(&[106, 108]);
/// The places before the points are given.
pub const POINTS: When = When::Variant(&[117, 118]);
/// Corner of a part, not of a pocket.
pub const OUTSIDE: When = When::Variant(&[106, 108, 118]);

/// Names of the coordinates of P1 to P4 (B:8059-8066).
pub const PLACES: [[Name; 2]; 4] = [
    [names::SETV0, names::SETV1],
    [names::SETV2, names::SETV3],
    [names::SETV4, names::SETV5],
    [names::SETV6, names::SETV7],
];

const DIRECTION: &[Need] = &[required(DISTANCES, "need-corner-directions")];
const PLACE: &[Need] = &[required(POINTS, "need-corner-points")];
const DISTANCE: &[Need] = &[required(DISTANCES, "need-corner-distances"), required(POINTS, "need-corner-points")];

/// The zero point is moved from the corner in the abscissa (B:7931-7935).
pub const MOVED_ABSCISSA: When = When::All(&[RECTANGLE, When::Number { param: names::SETV4, is: &[2.0, 3.0] }]);
/// The zero point is moved from the corner in the ordinate (B:7931-7935).
pub const MOVED_ORDINATE: When = When::All(&[RECTANGLE, When::Number { param: names::SETV4, is: &[3.0, 4.0] }]);

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { example: "108", source: "B:7862-7869;B:15346-15347", ..common::MVAR },
    Param {
        needs: DIRECTION,
        labels: &[(When::Always, "sta1-reference")],
        example: "-35",
        source: "B:7923;B:7992;A:8695",
        ..common::STA1
    },
    Param {
        range: Range::closed(-179.5, 179.5),
        needs: DIRECTION,
        labels: &[(When::Always, "inca-second-edge")],
        example: "80",
        source: "B:7924;B:15340;A:8696",
        ..common::INCA
    },
    Param {
        needs: DISTANCE,
        labels: &[(DISTANCES, "setv0-distance"), (POINTS, "p1-abscissa")],
        example: "100",
        source: "B:7926;B:8059;B:15353",
        ..common::SETV0
    },
    Param {
        needs: DISTANCE,
        labels: &[(DISTANCES, "setv1-distance"), (POINTS, "p1-ordinate")],
        example: "100",
        source: "B:7927;B:8060;B:15354",
        ..common::SETV1
    },
    Param {
        name: names::SETV2,
        key: "p2-abscissa",
        needs: &[required(MOVED_ABSCISSA, "need-corner-moved"), required(POINTS, "need-corner-points")],
        labels: &[(RECTANGLE, "setv2-offset")],
        source: "B:7929;B:8061;B:15355",
        ..common::SETVAL
    },
    Param {
        name: names::SETV3,
        key: "p2-ordinate",
        needs: &[required(MOVED_ORDINATE, "need-corner-moved"), required(POINTS, "need-corner-points")],
        labels: &[(RECTANGLE, "setv3-offset")],
        source: "B:7930;B:8062;B:15356",
        ..common::SETVAL
    },
    Param {
        kind: Kind::ChoiceIf(
            RECTANGLE,
            &[(1, "corner-itself"), (2, "corner-abscissa"), (3, "corner-both"), (4, "corner-ordinate")],
        ),
        name: names::SETV4,
        key: "p3-abscissa",
        needs: &[required(RECTANGLE, "need-corner-selection"), required(POINTS, "need-corner-points")],
        labels: &[(RECTANGLE, "setv4-selection")],
        source: "B:7931-7935;B:8063;B:15357",
        ..common::SETVAL
    },
    Param { name: names::SETV5, key: "p3-ordinate", needs: PLACE, source: "B:8064;B:15358", ..common::SETVAL },
    Param { name: names::SETV6, key: "p4-abscissa", needs: PLACE, source: "B:8065;B:15359", ..common::SETVAL },
    Param { name: names::SETV7, key: "p4-ordinate", needs: PLACE, source: "B:8066;B:15363", ..common::SETVAL },
    Param {
        needs: &[required(PASSES, "need-corner-passing"), required(POINTS, "need-corner-infeed")],
        labels: &[(PASSES, "id-over-corner")],
        example: "30",
        source: "B:7925;B:8006-8012;B:8058;B:15336",
        ..common::ID
    },
    Param { example: "2", source: "B:7840-7844;B:7922;B:8057;B:15342-15343", ..common::KNUM_ZERO },
    Param {
        kind: Kind::Digits(&[common::PROBE_NUMBER]),
        labels: &[(When::Always, "prnum-multi-only")],
        source: "B:7846-7848;B:15349",
        ..common::PRNUM
    },
    Param {
        labels: &[(DISTANCES, "fa-corner-distances"), (POINTS, "fa-corner-points")],
        example: "20",
        source: "B:7921;B:8146-8154;B:15334",
        ..common::FA
    },
    Param { source: "B:7942;B:8072", ..common::VMS },
    Param { source: "B:7942;B:8072", ..common::NMSP },
];
