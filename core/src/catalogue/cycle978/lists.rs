//! CYCLE978 as a call with arguments.

use crate::catalogue::{Arg, ArgumentList, Style, When, common, names};

/// The parameterizing call (B:11987-11996) and the list of newer controls. There the measuring direction is an argument
/// of its own; here the side on which the probe stands tells it.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_978",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::MA),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
        ],
        source: "B:11987-11996",
    },
    ArgumentList {
        style: Style::Operate,
        name: "CYCLE978",
        when: common::SHORT_TARGET,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::KNUM),
            Arg::Open,
            Arg::Param(names::PRNUM),
            Arg::Param(names::SETVAL),
            Arg::Param(names::FA),
            Arg::Param(names::TSA),
            Arg::Param(names::MA),
            Arg::Open,
            Arg::Param(names::NMSP),
            Arg::Param(names::TNAME),
            Arg::Open,
            Arg::Open,
            Arg::Param(names::TDIF),
            Arg::Param(names::TUL),
            Arg::Param(names::TLL),
            Arg::Param(names::TMV),
            Arg::Param(names::K),
            Arg::Open,
            Arg::Open,
            Arg::Open,
            Arg::Open,
        ],
        source: "practice: generated programs of newer controls",
    },
];
