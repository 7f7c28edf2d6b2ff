//! The lines of the help page of CYCLE977 (B:5600-6285).

use super::params::{OUTSIDE, RECTANGLE, ROUND, TOOL, WIDTH, ZERO, ZONE};
use crate::entry::{HelpLine, When, before, corrects, measures, mvar, order, wrong};

const INSIDE: When = When::Not(&OUTSIDE);
const LEVEL: When = When::All(&[INSIDE, When::Not(&ZONE)]);
const RAISED: When = When::Any(&[OUTSIDE, ZONE]);
const ZONE_INSIDE: When = When::All(&[ZONE, INSIDE]);
const ZONE_OUTSIDE: When = When::All(&[ZONE, OUTSIDE]);
const TWO_AXES: When = When::Not(&WIDTH);

/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(mvar(1, &[1]), "help-cycle977-measures-hole", "B:5645;B:5773"),
    measures(mvar(1, &[2]), "help-cycle977-measures-shaft", "B:5646;B:5773"),
    measures(mvar(1, &[3]), "help-cycle977-measures-groove", "B:5647;B:5773"),
    measures(mvar(1, &[4]), "help-cycle977-measures-web", "B:5648;B:5773"),
    measures(mvar(1, &[5]), "help-cycle977-measures-pocket", "B:5649;B:5773"),
    measures(mvar(1, &[6]), "help-cycle977-measures-island", "B:5650;B:5773"),
    before(TWO_AXES, "help-cycle977-before-centre", "B:5879-5902"),
    before(WIDTH, "help-cycle977-before-middle", "B:5879-5902"),
    before(LEVEL, "help-cycle977-before-depth", "B:5917-5928"),
    before(RAISED, "help-cycle977-before-above", "B:5904-5915;B:5930-5941"),
    before(ZONE_INSIDE, "help-cycle977-before-zone-inside", "B:5801-5809"),
    before(ZONE_OUTSIDE, "help-cycle977-before-zone-outside", "B:5801-5809"),
    before(When::All(&[ZONE, RECTANGLE]), "help-cycle977-before-zone-lengths", "B:5801-5809"),
    order(TWO_AXES, "help-cycle977-order-two-axes", "B:5773-5799"),
    order(WIDTH, "help-cycle977-order-one-axis", "B:5773-5799"),
    order(LEVEL, "help-cycle977-order-straight", "B:5903-5957"),
    order(When::Not(&OUTSIDE), "help-cycle977-order-outwards", "B:5773-5799"),
    order(OUTSIDE, "help-cycle977-order-inwards", "B:5904-5915"),
    order(ZONE_INSIDE, "help-cycle977-order-over-zone", "B:5930-5951"),
    order(ZONE, "help-cycle977-order-less-room", "B:5801-5809"),
    order(ROUND, "help-cycle977-order-diameter", "B:5773"),
    order(RECTANGLE, "help-cycle977-order-lengths", "B:5773"),
    order(When::Always, "help-cycle977-order-end", "B:5957"),
    corrects(TOOL, "help-cycle977-corrects-half", "B:6130-6134"),
    corrects(When::All(&[TOOL, RECTANGLE]), "help-cycle977-corrects-mean", "B:6130-6134"),
    corrects(When::All(&[ZERO, TWO_AXES]), "help-cycle977-corrects-both-axes", "B:6167-6171"),
    corrects(When::All(&[ZERO, WIDTH]), "help-cycle977-corrects-one-axis", "B:6167-6171"),
    wrong(LEVEL, "help-cycle977-wrong-depth", "B:5917-5928"),
    wrong(RAISED, "help-cycle977-wrong-infeed", "B:5904-5915"),
    wrong(ZONE, "help-cycle977-wrong-zone", "A:15877"),
    wrong(ZERO, "help-cycle977-wrong-start", "B:5879-5902"),
];
