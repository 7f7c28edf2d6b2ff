//! The lines of the help page of CYCLE971 (B:4157-5029).

use super::params::{AUTOMATIC, CALIBRATE, INCREMENTAL, MEASURE, ROTATING};
use crate::catalogue::tool_probe::help::lines;
use crate::entry::{HelpLine, When, before, measures, mvar, order, wrong};

const TRAVELS: When = When::Not(&INCREMENTAL);
const STILL: When = mvar(1, &[1]);
const CALIBRATE_ONE: When = When::All(&[CALIBRATE, When::Not(&AUTOMATIC)]);
const CALIBRATES_KNOWN: When = When::All(&[CALIBRATE, TRAVELS]);
const ONE_SIDE: When = When::All(&[TRAVELS, When::Not(&AUTOMATIC)]);
const CALIBRATES_ONE_SIDE: When = When::All(&[CALIBRATE, ONE_SIDE]);

/// Lines that all cycles at a tool probe have.
pub const SHARED: &[HelpLine] = &lines([TRAVELS, CALIBRATES_KNOWN, MEASURE], [INCREMENTAL, INCREMENTAL]);
/// Section by section, in the order in which they are read.
pub const LINES: &[HelpLine] = &[
    measures(CALIBRATE_ONE, "help-cycle971-measures-side", "B:4188-4196"),
    measures(AUTOMATIC, "help-cycle971-measures-sides", "B:4621-4649"),
    measures(MEASURE, "help-cycle971-measures-tool", "B:4189-4194"),
    before(STILL, "help-cycle971-before-still", "B:4189"),
    before(ROTATING, "help-cycle971-before-rotating", "B:4771-4807"),
    before(When::Always, "help-cycle971-before-parallel", "B:4246-4250"),
    before(AUTOMATIC, "help-cycle971-before-over", "B:4686-4706"),
    before(ONE_SIDE, "help-cycle971-before-clear", "B:4246-4254;B:5019"),
    order(ONE_SIDE, "help-cycle971-order-beside", "B:4573;B:4593"),
    order(ONE_SIDE, "help-cycle971-order-on-top", "B:4593-4599"),
    order(CALIBRATES_ONE_SIDE, "help-cycle971-order-centre-first", "B:4605-4607"),
    order(MEASURE, "help-cycle971-order-widest", "B:4849"),
    order(ROTATING, "help-cycle971-order-turning", "B:4771-4805"),
    order(AUTOMATIC, "help-cycle971-order-all-sides", "B:4676;B:4686-4743"),
    wrong(TRAVELS, "help-cycle971-wrong-depth", "B:13369"),
    wrong(ONE_SIDE, "help-cycle971-wrong-unclear", "B:4589;A:15875"),
    wrong(STILL, "help-cycle971-wrong-edge", "B:4189"),
    wrong(CALIBRATE, "help-cycle971-wrong-master", "B:4326"),
    wrong(MEASURE, "help-cycle971-wrong-no-data", "A:15893"),
    wrong(ROTATING, "help-cycle971-wrong-direction", "A:15910"),
];
