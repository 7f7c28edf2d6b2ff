//! CYCLE979 as a call with arguments.

use super::params::{ROUND, WIDTH};
use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, names};

/// The parameterizing calls that it shares with CYCLE977 (B:11894-11951), and the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_977_979A",
        when: ROUND,
        base: 0,
        args: &[
            Arg::Is(979),
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::ID),
            Arg::Open,
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Param(names::CPA),
            Arg::Param(names::CPO),
            Arg::Param(names::STA1),
            Arg::Param(names::INCA),
            Arg::Param(names::PRNUM),
        ],
        source: "B:11908-11923;A:13248-13260",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_977_979B",
        when: WIDTH,
        base: 0,
        args: &[
            Arg::Is(979),
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::ID),
            Arg::Open,
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Param(names::CPA),
            Arg::Param(names::CPO),
            Arg::Param(names::STA1),
            Arg::Open,
            Arg::Param(names::PRNUM),
        ],
        source: "B:11937-11951;A:13276-13289",
    },
    newer::CYCLE979,
];
