//! The lines of the help page of CYCLE961 (B:7815-8170).

use super::params::{DISTANCES, OUTSIDE, PASSES, POINTS, RECTANGLE};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

const FREE: When = When::Variant(&[107, 108]);

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(When::Not(&OUTSIDE), "help-cycle961-measures-inside", "B:7866;B:7868"),
    measures(OUTSIDE, "help-cycle961-measures-outside", "B:7867;B:7869"),
    measures(RECTANGLE, "help-cycle961-measures-square", "B:7917-7918"),
    measures(FREE, "help-cycle961-measures-free", "B:7919-7920"),
    measures(POINTS, "help-cycle961-measures-given", "B:8050-8066"),
    before(DISTANCES, "help-cycle961-before-opposite", "B:7980-7988"),
    before(POINTS, "help-cycle961-before-above", "B:8158-8170"),
    before(When::Always, "help-cycle961-before-multi", "B:7846"),
    order(RECTANGLE, "help-cycle961-order-three", "B:7978-7998"),
    order(FREE, "help-cycle961-order-four", "B:7978-7998"),
    order(When::Variant(&[105, 107]), "help-cycle961-order-in-plane", "B:7906"),
    order(PASSES, "help-cycle961-order-passes", "B:8002-8012"),
    order(POINTS, "help-cycle961-order-infeed", "B:8158-8170"),
    order(When::Variant(&[117]), "help-cycle961-order-toward-pocket", "B:8046"),
    order(When::Variant(&[118]), "help-cycle961-order-toward-part", "B:8046"),
    order(When::Always, "help-cycle961-order-along-axis", "B:7990;B:8148-8154"),
    order(DISTANCES, "help-ends-at-start", "B:8016"),
    order(POINTS, "help-cycle961-order-end-p4", "B:8158-8170"),
    corrects(When::Always, "help-cycle961-corrects-absolute", "B:7840-7844;B:8042"),
    corrects(RECTANGLE, "help-cycle961-corrects-choice", "B:8018-8026"),
    wrong(DISTANCES, "help-cycle961-wrong-angle", "B:7996"),
    wrong(DISTANCES, "help-cycle961-wrong-not-opposite", "B:7980-7988"),
    wrong(POINTS, "help-cycle961-wrong-swapped", "B:8140"),
    wrong(POINTS, "help-cycle961-wrong-same-points", "A:15911-15912"),
];
