//! CYCLE961 as a call with arguments.

use super::params::{DISTANCES, POINTS};
use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, names};

/// The parameterizing calls: one for distances and angles, one for points (B:12027-12078). The infeed of the second has
/// no sign there. And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_961_W",
        when: DISTANCES,
        base: 105,
        args: &[
            Arg::Select(&[(0, 0), (1, 1)]),
            Arg::Select(&[(3, 0), (4, 2)]),
            Arg::Param(names::SETV0),
            Arg::Param(names::SETV1),
            Arg::Param(names::ID),
            Arg::Param(names::STA1),
            Arg::Param(names::INCA),
            Arg::Param(names::KNUM),
            Arg::Param(names::SETV4),
            Arg::Param(names::SETV2),
            Arg::Param(names::SETV3),
            Arg::Param(names::PRNUM),
        ],
        source: "B:12033-12052;A:13373-13384",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_961_P",
        when: POINTS,
        base: 117,
        args: &[
            Arg::Select(&[(0, 0), (1, 1)]),
            Arg::Down(names::ID),
            Arg::Param(names::SETV0),
            Arg::Param(names::SETV1),
            Arg::Param(names::SETV2),
            Arg::Param(names::SETV3),
            Arg::Param(names::SETV4),
            Arg::Param(names::SETV5),
            Arg::Param(names::SETV6),
            Arg::Param(names::SETV7),
            Arg::Param(names::KNUM),
            Arg::Param(names::PRNUM),
        ],
        source: "B:12066-12078;A:13400-13411",
    },
    newer::CYCLE961,
];
