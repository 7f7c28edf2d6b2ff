//! CYCLE998 as a call with arguments.

use crate::catalogue::{Arg, ArgumentList, Style, When, common, names};

/// The parameterizing call (B:12008-12015) and the list of newer controls. There the measuring direction is coded in
/// its own way and the second angle has no place that is known, so that only one angle with positioning at an angle is
/// written.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_998",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::ID),
            Arg::Param(names::RA),
            Arg::Param(names::MA),
            Arg::Param(names::KNUM),
            Arg::Param(names::STA1),
            Arg::Param(names::PRNUM),
        ],
        source: "B:12008-12015;A:13350-13357",
    },
    ArgumentList {
        style: Style::Operate,
        name: "CYCLE998",
        when: When::All(&[common::SHORT_TARGET, When::Variant(&[105, 1105])]),
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::KNUM),
            Arg::Param(names::RA),
            Arg::Param(names::PRNUM),
            Arg::Param(names::SETVAL),
            Arg::Param(names::STA1),
            Arg::Open,
            Arg::Param(names::FA),
            Arg::Param(names::TSA),
            Arg::Param(names::MA),
            Arg::Open,
            Arg::Param(names::ID),
            Arg::Param(names::SETV0),
            Arg::Open,
            Arg::Open,
            Arg::Open,
            Arg::Param(names::NMSP),
            Arg::Open,
            Arg::Open,
            Arg::Open,
        ],
        source: "practice: generated programs of newer controls",
    },
];
