//! CYCLE994 as a call with arguments.

use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing call (B:12108-12121). And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_994",
        when: When::Always,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::SETVAL),
            Arg::Param(names::MA),
            Arg::Param(names::TNUM),
            Arg::Param(names::TNAME),
            Arg::Param(names::KNUM),
            Arg::Param(names::SZA),
            Arg::Param(names::SZO),
            Arg::Param(names::PRNUM),
        ],
        source: "B:12108-12121;A:13450-13458",
    },
    newer::CYCLE994,
];
