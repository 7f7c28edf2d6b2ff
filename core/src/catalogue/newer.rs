//! Parameter lists of newer 840D sl and 828D controls (SINUMERIK Operate). They are not in our manuals: order and names
//! of the arguments are those of published lists of the calls and agree with programs that run on such controls. What a
//! number in an argument means is published for few of them; a list whose `_MVAR` is not is read and never written.
//!
//! Where an argument has the name and the meaning of one of our parameters it is that parameter. Others are named as
//! there:
//! the measuring direction counts differently (1 plus, 2 minus), and the tool target has an argument of its own.

use crate::entry::Arg::{Newer, Param};
use crate::entry::{ArgumentList, NEVER, Style, When, names};

/// The measuring variants of CYCLE977 that are evidenced: hole, shaft, groove, web and both rectangles; measured, or
/// with correction of a zero offset; with a protection zone or without.
const ELEMENTS: When = When::Variant(&[
    1, 2, 3, 4, 5, 6, 101, 102, 103, 104, 105, 106, 1001, 1002, 1003, 1004, 1005, 1006, 1101, 1102, 1103, 1104, 1105,
    1106,
]);

const fn list(name: &'static str, when: When, args: &'static [crate::entry::Arg]) -> ArgumentList {
    ArgumentList {
        style: Style::Operate,
        name,
        when,
        base: 0,
        args,
        source: "practice: published lists and generated programs of newer controls",
    }
}

/// CYCLE961.
pub const CYCLE961: ArgumentList = list(
    "CYCLE961",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Param(names::PRNUM),
        Param(names::SETV0),
        Param(names::SETV1),
        Param(names::SETV2),
        Param(names::SETV3),
        Param(names::SETV4),
        Param(names::SETV5),
        Param(names::SETV6),
        Param(names::SETV7),
        Newer("S_SETV8"),
        Newer("S_SETV9"),
        Param(names::STA1),
        Param(names::INCA),
        Param(names::ID),
        Param(names::FA),
        Newer("S_TSA"),
        Param(names::NMSP),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE971.
pub const CYCLE971: ArgumentList = list(
    "CYCLE971",
    NEVER,
    &[
        Param(names::MVAR),
        Newer("S_KNUM"),
        Param(names::PRNUM),
        Param(names::MA),
        Newer("S_MD"),
        Param(names::ID),
        Param(names::FA),
        Param(names::TSA),
        Param(names::VMS),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::NMSP),
        Param(names::MFS[1]),
        Param(names::MFS[0]),
        Param(names::MFS[3]),
        Param(names::MFS[2]),
        Param(names::MFS[5]),
        Param(names::MFS[4]),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE973.
pub const CYCLE973: ArgumentList = list(
    "CYCLE973",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::PRNUM),
        Param(names::CALNUM),
        Param(names::SETVAL),
        Param(names::MA),
        Newer("S_MD"),
        Param(names::FA),
        Param(names::TSA),
        Param(names::VMS),
        Param(names::NMSP),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE974.
pub const CYCLE974: ArgumentList = list(
    "CYCLE974",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Newer("S_KNUM1"),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::MA),
        Param(names::FA),
        Param(names::TSA),
        Param(names::STA1),
        Param(names::NMSP),
        Param(names::TNAME),
        Param(names::DLNUM),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::TUL),
        Param(names::TLL),
        Param(names::TMV),
        Param(names::K),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
        Newer("_DP"),
    ],
);

/// CYCLE976.
pub const CYCLE976: ArgumentList = list(
    "CYCLE976",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Newer("S_SETV0"),
        Param(names::MA),
        Newer("S_MD"),
        Param(names::FA),
        Param(names::TSA),
        Param(names::VMS),
        Param(names::STA1),
        Param(names::NMSP),
        Newer("S_SETV1"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE977.
pub const CYCLE977: ArgumentList = list(
    "CYCLE977",
    ELEMENTS,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Newer("S_KNUM1"),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::SETV0),
        Param(names::SETV1),
        Param(names::FA),
        Param(names::TSA),
        Newer("S_STA1"),
        Param(names::ID),
        Param(names::SZA),
        Param(names::SZO),
        Param(names::MA),
        Param(names::NMSP),
        Param(names::TNAME),
        Param(names::DLNUM),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::TUL),
        Param(names::TLL),
        Param(names::TMV),
        Param(names::K),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
        Newer("S_XM"),
        Newer("S_YM"),
        Newer("_DP"),
    ],
);

/// CYCLE978.
pub const CYCLE978: ArgumentList = list(
    "CYCLE978",
    When::Variant(&[0, 100]),
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Newer("S_KNUM1"),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::FA),
        Param(names::TSA),
        Param(names::MA),
        Newer("S_MD"),
        Param(names::NMSP),
        Param(names::TNAME),
        Param(names::DLNUM),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::TUL),
        Param(names::TLL),
        Param(names::TMV),
        Param(names::K),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
        Newer("_DP"),
    ],
);

/// CYCLE979.
pub const CYCLE979: ArgumentList = list(
    "CYCLE979",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Newer("S_KNUM1"),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::FA),
        Param(names::TSA),
        Param(names::CPA),
        Param(names::CPO),
        Param(names::STA1),
        Param(names::INCA),
        Param(names::NMSP),
        Param(names::TNAME),
        Param(names::DLNUM),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::TUL),
        Param(names::TLL),
        Param(names::TMV),
        Param(names::K),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
        Newer("S_MPVAL1"),
        Newer("S_MPVAL2"),
        Newer("_DP"),
    ],
);

/// CYCLE982.
pub const CYCLE982: ArgumentList = list(
    "CYCLE982",
    NEVER,
    &[
        Param(names::MVAR),
        Newer("S_KNUM"),
        Param(names::PRNUM),
        Param(names::MA),
        Newer("S_MD"),
        Newer("S_ID"),
        Param(names::FA),
        Param(names::TSA),
        Param(names::VMS),
        Param(names::STA1),
        Param(names::CORA),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::NMSP),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE994.
pub const CYCLE994: ArgumentList = list(
    "CYCLE994",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Newer("S_KNUM1"),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::MA),
        Param(names::SZA),
        Param(names::SZO),
        Param(names::FA),
        Param(names::TSA),
        Param(names::NMSP),
        Param(names::TNAME),
        Param(names::DLNUM),
        Param(names::TZL),
        Param(names::TDIF),
        Param(names::TUL),
        Param(names::TLL),
        Param(names::TMV),
        Param(names::K),
        Param(names::EVNUM),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
        Newer("_DP"),
    ],
);

/// CYCLE997.
pub const CYCLE997: ArgumentList = list(
    "CYCLE997",
    NEVER,
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::FA),
        Param(names::TSA),
        Param(names::STA1),
        Param(names::INCA),
        Param(names::SETV0),
        Param(names::SETV1),
        Param(names::SETV2),
        Param(names::SETV3),
        Param(names::SETV4),
        Param(names::SETV5),
        Param(names::SETV6),
        Param(names::SETV7),
        Param(names::SETV8),
        Param(names::TNVL),
        Param(names::NMSP),
        Newer("S_MCBIT"),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);

/// CYCLE998.
pub const CYCLE998: ArgumentList = list(
    "CYCLE998",
    When::Variant(&[105]),
    &[
        Param(names::MVAR),
        Param(names::KNUM),
        Param(names::RA),
        Param(names::PRNUM),
        Param(names::SETVAL),
        Param(names::STA1),
        Param(names::INCA),
        Param(names::FA),
        Param(names::TSA),
        Param(names::MA),
        Newer("S_MD"),
        Param(names::ID),
        Param(names::SETV0),
        Newer("S_SETV1"),
        Newer("S_SETV2"),
        Newer("S_SETV3"),
        Param(names::NMSP),
        Param(names::EVNUM),
        Newer("_DMODE"),
        Newer("_AMODE"),
    ],
);
