//! CYCLE977 as a call with arguments.

use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

const fn elements(is: &'static [i64]) -> When {
    When::Digit { param: names::MVAR, place: 1, is }
}

/// Three parameterizing calls by element (B:11894-11985), and the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_977_979A",
        when: elements(&[1, 2]),
        base: 0,
        args: &[
            Arg::Is(977),
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::ID),
            Arg::Param(names::SZA),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Open,
            Arg::Open,
            Arg::Open,
            Arg::Open,
            Arg::Param(names::PRNUM),
        ],
        source: "B:11894-11923;A:13046",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_977_979B",
        when: elements(&[3, 4]),
        base: 0,
        args: &[
            Arg::Is(977),
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::ID),
            Arg::Param(names::MA),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Open,
            Arg::Open,
            Arg::Open,
            Arg::Param(names::SZA),
            Arg::Param(names::PRNUM),
        ],
        source: "B:11925-11951",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_977_979C",
        when: elements(&[5, 6]),
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::SETV0),
            Arg::Param(names::SETV1),
            Arg::Param(names::ID),
            Arg::Param(names::SZA),
            Arg::Param(names::SZO),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
        ],
        source: "B:11953-11985",
    },
    newer::CYCLE977,
];
