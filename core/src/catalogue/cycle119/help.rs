//! The lines of the help page of CYCLE119 (B:8541-8592).

use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Always, "help-cycle119-does", "B:8547"),
    before(When::Always, "help-cycle119-variables", "B:8559-8586"),
    before(When::Always, "help-cycle119-points", "B:8563-8565"),
    before(When::Always, "help-cycle119-alarm", "B:8579-8580"),
    order(When::Always, "help-cycle119-frame", "B:8581-8584"),
    order(When::Always, "help-cycle119-decides", "B:8566-8576"),
    corrects(When::Always, "help-cycle119-left", "B:8579-8586"),
    corrects(When::Always, "help-cycle119-frame-moved", "B:8566-8573"),
    corrects(When::Always, "help-cycle119-again", "B:8592"),
    wrong(When::Always, "help-cycle119-line", "B:8582;A:15930"),
    wrong(When::Always, "help-cycle119-distorted", "B:8575-8576;A:15933"),
    wrong(When::Always, "help-cycle119-order", "B:8563-8565"),
    wrong(When::Always, "help-cycle119-mirrored", "B:8588;A:15930"),
    wrong(When::Always, "help-cycle119-absent", "B:8588;A:15862;A:15932"),
    wrong(When::Always, "help-cycle119-unseen", "B:8579-8583"),
];
