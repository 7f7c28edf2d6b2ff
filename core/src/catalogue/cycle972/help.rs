//! The lines of the help page of CYCLE972 (B:8712-9211).

use super::params::{CALIBRATE, MEASURE};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(CALIBRATE, "help-cycle972-measures-side", "B:8834-8850"),
    measures(MEASURE, "help-cycle972-measures-length", "B:8954-8968"),
    before(When::Always, "help-tool-not-turned", "A:15873;B:9819"),
    before(When::Always, "help-tool-probe-known", "B:4204-4215;B:13357-13384"),
    order(When::Always, "help-cycle972-order-travel", "B:8870;B:9441"),
    order(CALIBRATE, "help-cycle972-order-nose", "B:8870"),
    order(MEASURE, "help-cycle972-order-tip", "B:9073"),
    order(When::Always, "help-tool-block", "B:1111-1121;B:2344-2356"),
    corrects(CALIBRATE, "help-tool-trigger", "B:4326"),
    corrects(MEASURE, "help-tool-data", "B:4324;B:4930-4937"),
    wrong(When::Always, "help-tool-reach", "B:13999-14001"),
];
