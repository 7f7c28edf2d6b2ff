//! The lines of the help page of CYCLE998 (B:7248-7813).

use super::params::{AT_ANGLE, ONE, PARAXIAL, TWO};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

const ONE_AT_ANGLE: When = When::All(&[ONE, AT_ANGLE]);
const ONE_PARAXIAL: When = When::All(&[ONE, PARAXIAL]);
const TWO_PARAXIAL: When = When::All(&[TWO, PARAXIAL]);

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(ONE, "help-cycle998-measures-one", "B:7256-7300"),
    measures(TWO, "help-cycle998-measures-two", "B:7588-7622"),
    before(ONE_AT_ANGLE, "help-cycle998-before-opposite", "B:7532-7546"),
    before(ONE_PARAXIAL, "help-cycle998-before-both-near", "B:7550-7560"),
    before(TWO, "help-cycle998-before-over", "B:7792"),
    order(ONE_AT_ANGLE, "help-cycle998-order-one-angle", "B:7530-7546"),
    order(ONE_PARAXIAL, "help-cycle998-order-one-paraxial", "B:7548-7560"),
    order(When::All(&[TWO, AT_ANGLE]), "help-cycle998-order-two-angle", "B:7588-7622"),
    order(TWO_PARAXIAL, "help-cycle998-order-two-paraxial", "B:7788-7808"),
    order(When::Not(&TWO_PARAXIAL), "help-cycle998-order-end", "B:7564;B:7808"),
    order(TWO_PARAXIAL, "help-cycle998-order-end-height", "B:7808"),
    order(AT_ANGLE, "help-order-block", "B:1111-1121;B:2344-2356"),
    corrects(When::Always, "help-cycle998-corrects-rotation", "B:7262-7278;B:7371-7391"),
    corrects(ONE, "help-cycle998-corrects-axis", "B:7381-7391"),
    corrects(When::Always, "help-cycle998-corrects-area", "B:15921"),
    wrong(When::Always, "help-cycle998-wrong-degrees", "B:15921"),
    wrong(When::Always, "help-cycle998-wrong-near", "B:7514"),
    wrong(When::Always, "help-cycle998-wrong-limit", "B:7308"),
    wrong(PARAXIAL, "help-cycle998-wrong-path", "B:7550-7560"),
    wrong(AT_ANGLE, "help-wrong-reach", "B:13999-14001"),
    wrong(AT_ANGLE, "help-wrong-in-the-way", "B:13743-13763"),
];
