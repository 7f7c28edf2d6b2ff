//! CYCLE978 as a call with arguments.

use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing call (B:11987-11996) and the list of newer controls. There the measuring direction is an argument
/// of its own, which programs leave out too; here the side on which the probe stands tells it.
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
    newer::CYCLE978,
];
