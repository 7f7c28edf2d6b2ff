//! Parameters of CYCLE994 in the order of the manual's table (B:10979-11001).

use crate::catalogue::lathe::params as lathe;
use crate::catalogue::prelude::*;

/// Inside, around a protection zone.
pub const INSIDE_ZONE: When = When::Variant(&[1]);

/// Outside with the second variant too; whether it is outside, the start position tells (B:10933, B:11122-11142).
const ZONE: &[Need] = &[required(INSIDE_ZONE, "need-zone-inside"), optional(When::Always, "need-zone-outside")];

/// Names of the zone in the measuring axis and along the part, by whether the abscissa is measured (B:10986-11001).
pub fn zone(abscissa: bool) -> [Name; 2] {
    if abscissa { [names::SZA, names::SZO] } else { [names::SZO, names::SZA] }
}

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { example: "2", source: "B:10930-10933", ..common::MVAR },
    Param {
        needs: common::ALWAYS_REQUIRED,
        labels: &[(lathe::DIAMETER, "setval-two-diameter"), (When::Always, "setval-two-radius")],
        example: "45",
        source: "B:10983-10984",
        ..common::SETVAL
    },
    Param { example: "2", source: "B:10985;B:10999", ..lathe::MA },
    Param {
        range: Range::ANY,
        needs: ZONE,
        labels: &[(When::Always, "sza-turned")],
        example: "55",
        source: "B:10986-10987;B:10891",
        ..common::SZA
    },
    Param {
        range: Range::ANY,
        needs: ZONE,
        labels: &[(common::APPLICATE, "szo-turned-applicate"), (When::Always, "szo-turned")],
        example: "55",
        source: "B:10988-10989;B:11001",
        ..common::SZO
    },
    Param { example: "1", source: "B:10990-10992", ..common::KNUM },
    Param { example: "8", source: "B:10993", ..common::TNUM },
    Param { source: "B:10994-10995", ..common::TNAME },
    Param { source: "B:10996", ..common::DLNUM },
    Param { source: "B:10997", ..common::TENV },
    Param { source: "B:11009;B:15555", ..lathe::PRNUM },
    Param { labels: &[(When::Always, "fa-lathe")], example: "1", source: "B:11009;B:15541", ..common::FA },
    Param { labels: &[(When::Always, "tsa-size")], example: "0.5", source: "B:11009;B:15574", ..common::TSA },
    Param { source: "B:11009;B:15576", ..common::VMS },
    Param { source: "B:11009;B:15554", ..common::NMSP },
    Param { example: "3", source: "B:11009;B:15538-15539", ..common::EVNUM },
    Param { source: "B:11009;B:15544", ..common::K },
    Param { example: "0.002", source: "B:11009;B:15575", ..common::TZL },
    Param { example: "0.005", source: "B:11009;A:16405", ..common::TMV },
    Param { example: "0", source: "B:11009;A:16406", ..common::TUL },
    Param { example: "-0.01", source: "B:11009;A:16407", ..common::TLL },
    Param { example: "0.04", source: "B:11009;B:15568", ..common::TDIF },
];
