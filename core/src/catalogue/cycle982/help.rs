//! The lines of the help page of CYCLE982 (B:9212-10126).

use super::params::{
    AUTOMATIC, BOTH, CALIBRATE, INCREMENTAL, MEASURE, OPPOSITE, POSITIONED, RADIAL, RADIUS, REVERSAL, UPPER,
    WITH_RADIUS, WORKPIECE,
};
use crate::catalogue::tool_probe::help::lines;
use crate::entry::{HelpLine, When, before, corrects, measures, mvar, order, wrong};

const CALIBRATES_KNOWN: When = When::All(&[CALIBRATE, POSITIONED]);
const MEASURES_KNOWN: When = When::All(&[MEASURE, POSITIONED]);
const CALIBRATES_HERE: When = When::All(&[CALIBRATE, INCREMENTAL]);
const MEASURES_HERE: When = When::All(&[MEASURE, INCREMENTAL]);
const ONE_LENGTH: When = When::All(&[mvar(1, &[1]), mvar(1000, &[0])]);
const ONE_LENGTH_KNOWN: When = When::All(&[ONE_LENGTH, POSITIONED]);
const EVERYTHING: When = When::All(&[AUTOMATIC, When::Not(&UPPER)]);
const UPPER_BEHIND: When = mvar(1000, &[3]);
const RADIUS_IN_AXIS: When = mvar(1000, &[1, 2]);
const AXIAL_TOOL: When = When::All(&[MEASURE, When::Not(&RADIAL)]);
const RADIAL_TOOL: When = When::All(&[MEASURE, RADIAL]);

/// Lines that all cycles at a tool probe have.
pub const SHARED: &[HelpLine] = &lines([POSITIONED, CALIBRATES_KNOWN, MEASURES_KNOWN], [INCREMENTAL, CALIBRATES_HERE]);
/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(CALIBRATE, "help-cycle982-measures-side", "B:9224-9260"),
    measures(ONE_LENGTH, "help-cycle982-measures-one-length", "B:9514-9522"),
    measures(RADIUS, "help-cycle982-measures-radius", "B:9578-9655"),
    measures(BOTH, "help-cycle982-measures-both", "B:9578-9655"),
    measures(EVERYTHING, "help-cycle982-measures-all", "B:9702-9752"),
    measures(UPPER, "help-cycle982-measures-upper", "B:9779-9793"),
    before(WORKPIECE, "help-tool-not-turned", "A:15873;B:9819"),
    before(When::Not(&WORKPIECE), "help-tool-parallel", "B:9819"),
    before(POSITIONED, "help-cycle982-before-outside", "B:9642"),
    before(MEASURE, "help-cycle982-before-setting", "B:9208;B:9334-9336"),
    before(AXIAL_TOOL, "help-cycle982-before-axial", "B:9208;B:9516"),
    before(RADIAL_TOOL, "help-cycle982-before-radial", "B:9208;B:9516"),
    order(CALIBRATES_KNOWN, "help-cycle982-order-calibrate", "B:9441"),
    order(MEASURE, "help-cycle982-order-spindle", "B:9600-9610;B:10088-10094"),
    order(REVERSAL, "help-cycle982-order-reversal", "B:9600-9602"),
    order(ONE_LENGTH_KNOWN, "help-cycle982-order-length", "B:9516-9610"),
    order(RADIUS, "help-cycle982-order-radius", "B:9578-9638"),
    order(BOTH, "help-cycle982-order-both", "B:9578-9655"),
    order(EVERYTHING, "help-cycle982-order-all", "B:9702-9758"),
    order(UPPER_BEHIND, "help-cycle982-order-upper-behind", "B:9779"),
    order(OPPOSITE, "help-cycle982-order-upper-across", "B:9787-9793"),
    corrects(MEASURES_HERE, "help-cycle982-corrects-geometry", "B:9935-9972"),
    wrong(RADIUS_IN_AXIS, "help-cycle982-wrong-axis", "B:9279"),
    wrong(WITH_RADIUS, "help-cycle982-wrong-drill-radius", "B:9208"),
    wrong(MEASURE, "help-cycle982-wrong-fast", "B:9604-9608"),
    wrong(POSITIONED, "help-cycle982-wrong-wrong-side", "A:15875"),
    wrong(CALIBRATE, "help-cycle982-wrong-nose", "B:9441;B:8943-8952"),
];
