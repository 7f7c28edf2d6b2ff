//! The lines of the help page of CYCLE974 (B:10452-10905).

use super::params::REVERSAL;
use crate::catalogue::common::{TOOL_OFFSET, ZERO_OFFSET};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle974-measures-point", "B:10455-10459"),
    before(When::Always, "help-cycle974-before-opposite", "B:10507-10511"),
    before(REVERSAL, "help-cycle974-before-chuck", "B:10784"),
    order(When::Always, "help-cycle974-order-axis", "B:10511;B:10583"),
    order(REVERSAL, "help-cycle974-order-reversal", "B:10784"),
    corrects(TOOL_OFFSET, "help-cycle974-corrects-half", "B:10742-10754"),
    corrects(ZERO_OFFSET, "help-cycle974-corrects-one-axis", "B:10525"),
    wrong(When::Always, "help-cycle974-wrong-side", "B:10511"),
    wrong(When::Not(&REVERSAL), "help-cycle974-wrong-run-out", "B:10776-10784"),
];
