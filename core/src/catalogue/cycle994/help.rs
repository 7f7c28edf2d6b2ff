//! The lines of the help page of CYCLE994 (B:10906-11170).

use super::params::INSIDE_ZONE;
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Outside, or inside without a zone: where the probe stands decides.
const EITHER: When = When::Variant(&[2]);

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle994-measures-diameter", "B:10886"),
    before(When::Always, "help-cycle994-before-plus-side", "B:10889;B:10933"),
    before(INSIDE_ZONE, "help-cycle994-before-inside", "B:10932"),
    before(EITHER, "help-cycle994-before-either", "B:10933;B:11122-11142"),
    order(When::Always, "help-cycle994-order-plus-first", "B:10889"),
    order(INSIDE_ZONE, "help-cycle994-order-round-inside", "B:10932;B:11122-11142"),
    order(EITHER, "help-cycle994-order-round-outside", "B:11122-11142"),
    corrects(When::Always, "help-cycle994-corrects-half", "B:11076-11090"),
    wrong(When::Always, "help-cycle994-wrong-zone", "B:10891"),
    wrong(When::Always, "help-cycle994-wrong-ball", "B:10903-10906"),
];
