//! The lines of the help page of CYCLE116 (B:2408-2469).

use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle116-does", "B:2414"),
    before(When::Always, "help-cycle116-variables", "B:2418;B:2448"),
    before(When::Always, "help-cycle116-points", "B:2430-2438"),
    order(When::Always, "help-cycle116-circle", "B:2414;B:2430"),
    corrects(When::Always, "help-cycle116-left", "B:2444-2448;A:2635"),
    wrong(When::Always, "help-cycle116-line", "B:2448;A:15857"),
    wrong(When::Always, "help-cycle116-count", "B:2448;A:15858"),
    wrong(When::Always, "help-cycle116-unseen", "B:2448"),
];
