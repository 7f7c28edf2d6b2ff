//! CYCLE974 as a call with arguments.

use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing call (B:12084-12098). And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_974",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::MA),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Param(names::PRNUM),
            Arg::Param(names::STA1),
        ],
        source: "B:12084-12098;A:13427-13434",
    },
    newer::CYCLE974,
];
