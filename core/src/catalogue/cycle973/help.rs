//! The lines of the help page of CYCLE973 (B:10127-10451).

use super::params::{BALL, GROOVE, ONE, SKEW, SURFACE, TWO};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(SURFACE, "help-cycle973-measures-surface", "B:10331-10333"),
    measures(ONE, "help-cycle973-measures-groove-one", "B:10216"),
    measures(TWO, "help-cycle973-measures-groove-two", "B:10216"),
    before(SURFACE, "help-cycle973-before-surface", "B:10331;B:10411"),
    before(GROOVE, "help-cycle973-before-groove", "B:10213;B:10317;B:13470-13482"),
    before(When::Always, "help-cycle973-before-centre", "B:10275"),
    order(SURFACE, "help-cycle973-order-surface", "B:10403-10415"),
    order(GROOVE, "help-cycle973-order-into-groove", "B:10205-10230"),
    order(ONE, "help-cycle973-order-one", "B:10205-10230"),
    order(TWO, "help-cycle973-order-two", "B:10205-10230"),
    order(GROOVE, "help-cycle973-order-end-groove", "B:10323"),
    corrects(BALL, "help-cycle973-corrects-ball", "B:10163-10173"),
    corrects(SKEW, "help-cycle973-corrects-skew", "B:10163-10173"),
    wrong(GROOVE, "help-cycle973-wrong-groove-data", "B:13473-13482"),
    wrong(GROOVE, "help-cycle973-wrong-position", "B:10145;B:10213"),
    wrong(SURFACE, "help-cycle973-wrong-shank", "B:10331"),
];
