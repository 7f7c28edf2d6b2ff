//! The help page of G65 P9969.

use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// The lines of the help page.
pub const HELP: &[HelpLine] = &[
    measures(When::Always, "help-p9969-measures", "C:1262-1275"),
    before(When::Always, "help-stylus", "C:1335-1337"),
    before(When::Always, "help-p9969-before", "C:1280"),
    order(When::Always, "help-p9969-order-lines", "C:1278"),
    order(When::Always, "help-p9969-order-point", "C:1316-1317"),
    order(When::Always, "help-p9969-order-deepest", "C:1280"),
    corrects(When::Always, "help-p9969-corrects", "C:1262-1275;C:1322"),
    wrong(When::Always, "help-p9969-wrong-fast", "C:1318-1321"),
    wrong(When::Always, "help-p9969-wrong-step", "C:1337"),
    wrong(When::Always, "help-p9969-wrong-cavity", "C:1338"),
    wrong(When::Always, "help-p9969-wrong-ball", "C:1272-1275"),
];
