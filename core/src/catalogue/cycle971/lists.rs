//! CYCLE971 as a call with arguments.

use super::params::MEASURE;
use crate::catalogue::newer;
use crate::entry::{Arg, ArgumentList, Style, When, names};

/// The parameterizing calls (B:11755-11772, B:11856-11879): calibration in the machine, and measuring. The speeds and
/// feeds `_MFS[]` are printed the other way round than the data are defined (B:13515-13520),
/// which count. And the list of newer controls.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_CAL_TOOLSETTER",
        when: When::Variant(&[0, 10_000]),
        base: 0,
        args: &[
            Arg::Is(971),
            Arg::Param(names::MA),
            Arg::Param(names::PRNUM),
            Arg::Select(&[(0, 0), (1, 10_000)]),
            Arg::Param(names::FA),
        ],
        source: "B:11767-11772;A:13108-13112",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_971",
        when: MEASURE,
        base: 0,
        args: &[
            Arg::Param(names::MVAR),
            Arg::Param(names::MA),
            Arg::Param(names::ID),
            Arg::Param(names::PRNUM),
            Arg::Param(names::MFS[0]),
            Arg::Param(names::MFS[1]),
            Arg::Param(names::MFS[2]),
            Arg::Param(names::MFS[3]),
            Arg::Param(names::MFS[4]),
            Arg::Param(names::MFS[5]),
        ],
        source: "B:11870-11879;A:13210-13219",
    },
    newer::CYCLE971,
];
