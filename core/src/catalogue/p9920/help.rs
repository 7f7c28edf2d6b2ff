//! The lines of the help page of G65 P9920.

use super::{CALIBRATE, DIAMETER, LENGTH};
use crate::entry::{HelpLine, When, before, corrects, measures, order, wrong};

const AT_CALIBRATION: When = When::Variant(&[CALIBRATE]);
const AT_MEASUREMENT: When = When::Variant(&[LENGTH, DIAMETER]);
const AT_DIAMETER: When = When::Variant(&[DIAMETER]);

/// All of them.
pub const LINES: &[HelpLine] = &[
    measures(AT_CALIBRATION, "help-p9920-measures-probe", "C:1191-1202"),
    measures(When::Variant(&[LENGTH]), "help-p9920-measures-length", "C:1232-1245"),
    measures(AT_DIAMETER, "help-p9920-measures-both", "C:1232-1245"),
    before(When::Always, "help-p9920-before-reference", "C:1204-1206"),
    before(AT_CALIBRATION, "help-p9920-before-centre", "C:1214"),
    before(AT_MEASUREMENT, "help-p9920-before-above", "C:1234"),
    order(AT_CALIBRATION, "help-p9920-order-rim", "C:1224"),
    order(AT_CALIBRATION, "help-p9920-order-face", "C:1224"),
    order(AT_MEASUREMENT, "help-p9920-order-length", "C:1245"),
    order(AT_DIAMETER, "help-p9920-order-diameter", "C:1245"),
    corrects(AT_CALIBRATION, "help-p9920-corrects-probe", "C:1191-1202"),
    corrects(AT_MEASUREMENT, "help-p9920-corrects-length", "C:1239"),
    corrects(AT_DIAMETER, "help-p9920-corrects-radius", "C:1239"),
    wrong(When::Always, "help-p9920-wrong-length", "C:1254"),
    wrong(AT_MEASUREMENT, "help-p9920-wrong-turning", "C:1251"),
    wrong(AT_DIAMETER, "help-p9920-wrong-lift", "C:1252"),
    wrong(AT_CALIBRATION, "help-p9920-wrong-disk", "C:1202"),
];
