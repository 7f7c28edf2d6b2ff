//! Parameters of CYCLE974 in the order of the manual's tables (B:10537-10547, B:10619-10639, B:10792-10811).

use crate::catalogue::lathe::params as lathe;
use crate::catalogue::prelude::*;

/// At two places of the turned part, 180 degree apart.
pub const REVERSAL: When = mvar(1000, &[1]);

const MVAR_DIGITS: &[DigitGroup] = &[
    common::CORRECTION_DIGIT,
    DigitGroup::one("mvar-reversal", 1000, &[(0, "reversal-without"), (1, "reversal-with")]),
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "0", source: "B:10455-10459", ..common::MVAR },
    Param {
        needs: common::ALWAYS_REQUIRED,
        labels: &[(lathe::DIAMETER, "setval-turned-diameter"), (When::Always, "setval-turned-position")],
        example: "45",
        source: "B:10540;B:10622-10623;B:10795-10796",
        ..common::SETVAL
    },
    Param { example: "2", source: "B:10541;B:10545", ..lathe::MA },
    Param {
        range: Range::closed(0.0, 360.0),
        usual: Range::ANY,
        needs: &[required(REVERSAL, "need-angle-reversal")],
        labels: &[(When::Always, "sta1-spindle")],
        source: "B:10784;B:10798;B:15561",
        ..common::STA1
    },
    Param { example: "1", source: "B:10542-10544;B:10625-10627", ..common::KNUM },
    Param { example: "7", source: "B:10628", ..common::TNUM },
    Param { source: "B:10629-10630", ..common::TNAME },
    Param { source: "B:10631-10632", ..common::DLNUM },
    Param { source: "B:10633", ..common::TENV },
    Param { source: "B:10547;B:15555", ..lathe::PRNUM },
    Param { labels: &[(When::Always, "fa-lathe")], example: "1", source: "B:10547;B:15541", ..common::FA },
    Param { labels: &[(When::Always, "tsa-position")], example: "0.5", source: "B:10547;B:10740", ..common::TSA },
    Param { source: "B:10547;B:10567-10571", ..common::VMS },
    Param { source: "B:10547;B:15554", ..common::NMSP },
    Param { example: "13", source: "B:10547;B:15538-15539", ..common::EVNUM },
    Param { example: "2", source: "B:10639;B:15544", ..common::K },
    Param { example: "0.002", source: "B:10639;B:15575", ..common::TZL },
    Param { example: "0.005", source: "B:10639;A:16405", ..common::TMV },
    Param { example: "0", source: "B:10639;A:16406", ..common::TUL },
    Param { example: "-0.01", source: "B:10639;A:16407", ..common::TLL },
    Param { example: "0.04", source: "B:10639;B:15568", ..common::TDIF },
];
