//! The lines of the help page of CYCLE976 (B:5036-5593).

use super::params::{ANGLE, BALL, FOUR, HOLE, LENGTH, ONE, SKEW, SURFACE, TWO, UNKNOWN};
use crate::entry::{HelpLine, When, before, corrects, measures, mvar, order, wrong};

const KNOWN: When = mvar(1, &[1]);
/// Travels to the measuring block by itself.
const APPROACHES: When = When::Not(&LENGTH);

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(HOLE, "help-cycle976-measures-hole", "B:5036-5060"),
    measures(ONE, "help-cycle976-measures-one", "B:5066-5084"),
    measures(TWO, "help-cycle976-measures-two", "B:5066-5084"),
    measures(FOUR, "help-cycle976-measures-four", "B:5066-5084"),
    measures(UNKNOWN, "help-cycle976-measures-centre", "B:5216-5240"),
    measures(SURFACE, "help-cycle976-measures-surface", "B:5342-5369"),
    measures(LENGTH, "help-cycle976-measures-length", "B:5457-5501"),
    before(KNOWN, "help-cycle976-before-at-centre", "B:5198"),
    before(UNKNOWN, "help-cycle976-before-near-centre", "B:5311"),
    before(UNKNOWN, "help-cycle976-before-spindle", "B:5222-5234;B:5292-5296"),
    before(SURFACE, "help-cycle976-before-opposite", "B:5449-5455"),
    before(LENGTH, "help-cycle976-before-within", "B:5589"),
    before(When::Always, "help-cycle976-before-radius", "B:5036-5060;B:5463-5501"),
    order(ONE, "help-cycle976-order-one", "B:5120-5214"),
    order(TWO, "help-cycle976-order-two", "B:5120-5214"),
    order(FOUR, "help-cycle976-order-four", "B:5120-5214"),
    order(ANGLE, "help-cycle976-order-angle", "B:5120-5214;B:5323"),
    order(UNKNOWN, "help-cycle976-order-twice", "B:5216-5340"),
    order(LENGTH, "help-cycle976-order-no-approach", "B:5457-5593"),
    order(KNOWN, "help-cycle976-order-end-centre", "B:5214"),
    order(UNKNOWN, "help-cycle976-order-end-found", "B:5336"),
    order(SURFACE, "help-cycle976-order-end-surface", "B:5449-5455"),
    order(LENGTH, "help-ends-at-start", "B:5593"),
    order(APPROACHES, "help-order-block", "B:1111-1121;B:2344-2356"),
    corrects(BALL, "help-cycle976-corrects-ball", "B:13656"),
    corrects(SKEW, "help-cycle976-corrects-skew", "B:5049"),
    corrects(LENGTH, "help-cycle976-corrects-length", "B:5457-5509"),
    wrong(KNOWN, "help-cycle976-wrong-off-centre", "B:5120-5214"),
    wrong(HOLE, "help-cycle976-wrong-diameter", "B:5120-5214"),
    wrong(When::Any(&[SURFACE, LENGTH]), "help-cycle976-wrong-position", "B:5342-5369"),
    wrong(APPROACHES, "help-wrong-reach", "B:13999-14001"),
    wrong(APPROACHES, "help-wrong-in-the-way", "B:13743-13763"),
];
