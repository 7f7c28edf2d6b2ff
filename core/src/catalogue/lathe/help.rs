//! What the help pages of the cycles with the probe of a turning machine have in common.

use crate::entry::{HelpLine, When, before, wrong};

/// What every cycle with the probe of a turning machine asks for.
pub const PROBE: &[HelpLine] = &[
    before(When::Always, "help-turning-probe", "B:8708;A:15849;A:15873"),
    wrong(When::Always, "help-turning-diameter", "B:10623;B:10975"),
];
