//! Parameters of CYCLE974 in the order of the manual's tables (B:10533-10547, B:10620-10643, B:10792-10813).

use crate::catalogue::common::{self, required};
use crate::catalogue::lathe::params as lathe;
use crate::catalogue::{DigitGroup, Kind, Param, Range, When, names};

/// At two places of the turned part, 180 degree apart.
pub const REVERSAL: When = When::Digit {
    param: names::MVAR,
    place: 1000,
    is: &[1],
};

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup {
        key: "mvar-correction",
        place: 100,
        digits: 1,
        choices: &[(0, "correction-tool"), (1, "correction-zero")],
    },
    DigitGroup {
        key: "mvar-reversal",
        place: 1000,
        digits: 1,
        choices: &[(0, "reversal-without"), (1, "reversal-with")],
    },
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param {
        kind: Kind::Variant(MVAR_DIGITS),
        source: "B:10455-10459",
        ..common::MVAR
    },
    Param {
        needs: common::ALWAYS_REQUIRED,
        labels: &[
            (lathe::TRANSVERSE, "setval-turned-diameter"),
            (When::Always, "setval-turned-position"),
        ],
        source: "B:10534;B:10623-10624;B:10795-10796",
        ..common::SETVAL
    },
    Param {
        source: "B:10535;B:10545",
        ..lathe::MA
    },
    Param {
        range: Range::closed(0.0, 360.0),
        usual: Range::ANY,
        needs: &[required(REVERSAL, "need-angle-reversal")],
        labels: &[(When::Always, "sta1-spindle")],
        source: "B:10784;B:10798;B:15561",
        ..common::STA1
    },
    Param {
        source: "B:10536-10538;B:10626-10628",
        ..lathe::KNUM
    },
    Param {
        source: "B:10629",
        ..lathe::TNUM
    },
    Param {
        source: "B:10630-10631",
        ..lathe::TNAME
    },
    Param {
        source: "B:10632",
        ..lathe::DLNUM
    },
    Param {
        source: "B:10633",
        ..lathe::TENV
    },
    Param {
        source: "B:10547;B:15555",
        ..common::PRNUM
    },
    Param {
        labels: &[(When::Always, "fa-lathe")],
        source: "B:10547;B:15541",
        ..common::FA
    },
    Param {
        labels: &[(When::Always, "tsa-position")],
        source: "B:10547;B:10736",
        ..common::TSA
    },
    Param {
        source: "B:10547;B:10565-10571",
        ..common::VMS
    },
    Param {
        source: "B:10547;B:15554",
        ..common::NMSP
    },
    Param {
        source: "B:10547;B:10612-10616",
        ..lathe::EVNUM
    },
    Param {
        source: "B:10643;B:15544",
        ..lathe::K
    },
    Param {
        source: "B:10643;B:15575",
        ..lathe::TZL
    },
    Param {
        source: "B:10643;A:16405",
        ..lathe::TMV
    },
    Param {
        source: "B:10643;A:16406",
        ..lathe::TUL
    },
    Param {
        source: "B:10643;A:16407",
        ..lathe::TLL
    },
    Param {
        source: "B:10643;B:15568",
        ..lathe::TDIF
    },
];
