//! The lines of the help page of CYCLE997 (B:8172-8530).

use super::params::{ANGLE, DIAMETER, FOUR_POINTS, ONE, REPEATED, THREE};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(ONE, "help-cycle997-measures-one", "B:8190-8200"),
    measures(THREE, "help-cycle997-measures-three", "B:8190-8200"),
    measures(DIAMETER, "help-cycle997-measures-diameter", "B:8371"),
    before(When::Always, "help-cycle997-before-above", "B:8349;B:8421"),
    before(ANGLE, "help-cycle997-before-ball", "B:8371;B:6873"),
    before(When::Always, "help-cycle997-before-frame", "B:8228;B:8387;B:8407"),
    order(When::Not(&ANGLE), "help-cycle997-order-paraxial", "B:8433-8449"),
    order(When::All(&[ANGLE, When::Not(&FOUR_POINTS)]), "help-cycle997-order-three-points", "B:8453-8467"),
    order(When::All(&[ANGLE, FOUR_POINTS]), "help-cycle997-order-four-points", "B:8453-8467"),
    order(When::Always, "help-cycle997-order-top", "B:8441-8449"),
    order(DIAMETER, "help-cycle997-order-diameter", "B:8371"),
    order(REPEATED, "help-cycle997-order-repeat", "B:8369"),
    order(THREE, "help-cycle997-order-next", "B:8206;B:8449;B:8467"),
    order(When::Always, "help-cycle997-order-end", "B:8475"),
    corrects(ONE, "help-cycle997-corrects-shift", "B:8385"),
    corrects(THREE, "help-cycle997-corrects-turn", "B:8385-8411"),
    corrects(When::Always, "help-cycle997-corrects-area", "B:8373-8379"),
    wrong(When::Always, "help-cycle997-wrong-holder", "B:8349"),
    wrong(ANGLE, "help-cycle997-wrong-no-ball", "B:6873"),
    wrong(THREE, "help-cycle997-wrong-line", "A:15930"),
];
