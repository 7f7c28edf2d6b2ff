//! CYCLE972 as a call with arguments.

use super::params::{CALIBRATE, MEASURE};
use crate::entry::{Arg, ArgumentList, Style, names};

/// The parameterizing calls (B:11755-11772, B:11881-11888). In the list of newer controls CYCLE972 is not known to us.
pub const LISTS: &[ArgumentList] = &[
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_CAL_TOOLSETTER",
        when: CALIBRATE,
        base: 0,
        args: &[
            Arg::Is(972),
            Arg::Param(names::MA),
            Arg::Param(names::PRNUM),
            Arg::Select(&[(0, 0), (1, 0)]), // counts for CYCLE971 only
            Arg::Param(names::FA),
        ],
        source: "B:11767-11772;A:13108-13112",
    },
    ArgumentList {
        style: Style::Indirect,
        name: "CYCLE_972",
        when: MEASURE,
        base: 1,
        args: &[Arg::Param(names::MA), Arg::Param(names::PRNUM)],
        source: "B:11887-11888;A:13231-13232",
    },
];
