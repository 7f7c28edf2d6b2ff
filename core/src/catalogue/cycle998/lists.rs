//! CYCLE998 as a call with arguments.

use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing call (B:12008-12015) and the list of newer controls, of which only one angle with positioning at
/// an angle is known.
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
    newer::CYCLE998,
];
