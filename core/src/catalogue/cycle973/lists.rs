//! CYCLE973 as a call with arguments.

use super::params::{GROOVE, SURFACE};
use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, names};

/// The parameterizing calls: surfaces share one with CYCLE976, the groove is put together from selections, of which the
/// number of directions is always written (B:11784-11821). And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_CAL_PROBE",
        when: SURFACE,
        base: 0,
        args: &[
            Arg::Is(973),
            Arg::Param(names::SETVAL),
            Arg::Param(names::MA),
            Arg::Param(names::MD),
            Arg::Param(names::PRNUM),
            Arg::Param(names::MVAR),
        ],
        source: "B:11784-11797;A:13134-13139",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_973",
        when: GROOVE,
        base: 13,
        args: &[
            Arg::Param(names::SETVAL),
            Arg::Select(&[(0, 0), (1, 10_000)]),
            Arg::Select(&[(1, 1000), (2, 2000)]),
            Arg::Select(&[(0, 0), (1, 100)]),
            Arg::Param(names::MA),
            Arg::Param(names::MD),
            Arg::Param(names::CALNUM),
            Arg::Param(names::PRNUM),
        ],
        source: "B:11811-11821;A:13158-13165",
    },
    newer::CYCLE973,
];
