//! The lines of the help page of CYCLE979 (B:6732-7246).

use super::params::{ROUND, TOOL, WEB, WIDTH, ZERO};
use crate::entry::{HelpLine, When, before, corrects, measures, mvar, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(mvar(1, &[1]), "help-cycle979-measures-hole", "B:6835-6850"),
    measures(mvar(1, &[2]), "help-cycle979-measures-shaft", "B:6835-6850"),
    measures(mvar(1, &[3]), "help-cycle979-measures-groove", "B:6852-6858"),
    measures(mvar(1, &[4]), "help-cycle979-measures-web", "B:6852-6858"),
    before(When::Always, "help-cycle979-before-near", "B:6898-6905"),
    before(When::Always, "help-cycle979-before-ball", "B:6873"),
    order(ROUND, "help-cycle979-order-circle", "B:6835-6850;B:6907-6913"),
    order(mvar(1, &[1]), "help-cycle979-order-outwards", "B:6907-6913"),
    order(mvar(1, &[2]), "help-cycle979-order-inwards", "B:6907-6913"),
    order(mvar(1, &[3]), "help-cycle979-order-across", "B:6915-6933"),
    order(WEB, "help-cycle979-order-over", "B:6915-6933"),
    order(ROUND, "help-cycle979-order-fit", "B:6838"),
    order(When::Always, "help-cycle979-order-end", "B:6939"),
    corrects(TOOL, "help-cycle979-corrects-half", "B:7111-7114"),
    corrects(ZERO, "help-cycle979-corrects-both", "B:7133-7149"),
    wrong(ROUND, "help-cycle979-wrong-arc", "B:6907-6913"),
    wrong(ROUND, "help-cycle979-wrong-close", "B:6835-6850"),
    wrong(ROUND, "help-cycle979-wrong-speed", "B:6994"),
    wrong(WIDTH, "help-cycle979-wrong-skewed", "B:6852-6858"),
    wrong(WEB, "help-cycle979-wrong-lift", "B:6929"),
];
