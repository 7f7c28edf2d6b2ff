//! The lines of the help page of CYCLE978 (B:6286-6730).

use super::params::{TOOL, ZERO};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle978-measures-point", "B:6288"),
    before(When::Always, "help-cycle978-before-opposite", "B:6376-6384"),
    order(When::Always, "help-cycle978-order-axis", "B:6376-6388"),
    corrects(TOOL, "help-cycle978-corrects-full", "B:6698-6699"),
    corrects(ZERO, "help-cycle978-corrects-one-axis", "B:6436-6450"),
    wrong(When::Always, "help-cycle978-wrong-side", "B:6376-6384"),
    wrong(When::Always, "help-cycle978-wrong-oblique", "B:6288"),
];
