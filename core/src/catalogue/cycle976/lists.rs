//! CYCLE976 as a call with arguments.

use super::params::{HOLE, LENGTH, SURFACE};
use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing calls: holes are put together from selections, surfaces name their variant (B:11784-11854).
/// And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_976",
        when: HOLE,
        base: 1,
        args: &[
            Arg::Param(names::SETVAL),
            Arg::Select(&[(0, 0), (1, 100_000)]),
            Arg::Select(&[(0, 0), (1, 10_000)]),
            Arg::Select(&[(1, 1000), (2, 2000), (4, 0)]),
            Arg::Select(&[(0, 0), (1, 100)]),
            Arg::Param(names::MA),
            Arg::Param(names::MD),
            Arg::Param(names::STA1),
            Arg::Param(names::PRNUM),
            // from the known to the unknown centre: first digit 1 to 8
            Arg::Select(&[(0, 0), (1, 7)]),
        ],
        source: "B:11834-11854;A:13184-13192",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_CAL_PROBE",
        when: When::Any(&[SURFACE, LENGTH]),
        base: 0,
        args: &[
            Arg::Is(976),
            Arg::Param(names::SETVAL),
            Arg::Param(names::MA),
            Arg::Param(names::MD),
            Arg::Param(names::PRNUM),
            Arg::Param(names::MVAR),
        ],
        source: "B:11784-11797;A:13134-13139",
    },
    newer::CYCLE976,
];
