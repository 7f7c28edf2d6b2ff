//! What CYCLE982 leaves in the result arrays (B:9283-9322). The unit of `_OVR[]` is not defined by the manual; here the
//! active unit counts.

use super::params::{
    ABSCISSA, AUTOMATIC, CALIBRATE, DRILL, DRILL_ALONG_APPLICATE, INCREMENTAL, MEASURE, ORDINATE, RADIAL, RADIUS,
    TURNING, WITH_RADIUS,
};
use crate::catalogue::common::{integer, length};
use crate::entry::{ResultField, When, names};

/// `_MD` of the incremental variants names the one direction that is touched; otherwise the start position decides.
const fn direction(md: &'static [f64]) -> When {
    When::Number { param: names::MD, is: md }
}
const PLUS: When = When::Any(&[When::Not(&INCREMENTAL), direction(&[0.0])]);
const MINUS: When = When::Any(&[When::Not(&INCREMENTAL), direction(&[1.0])]);

const MINUS_ABSCISSA: When = When::All(&[CALIBRATE, ABSCISSA, MINUS]);
const PLUS_ABSCISSA: When = When::All(&[CALIBRATE, ABSCISSA, PLUS]);
const MINUS_ORDINATE: When = When::All(&[CALIBRATE, ORDINATE, MINUS]);
const PLUS_ORDINATE: When = When::All(&[CALIBRATE, ORDINATE, PLUS]);

/// Of a drill, automatic measurement finds the length along its axis only (B:9703).
const DRILL_AXIAL: When = When::All(&[AUTOMATIC, DRILL, When::Not(&RADIAL)]);
const DRILL_RADIAL: When = When::All(&[AUTOMATIC, DRILL, RADIAL]);
const L1: When = When::All(&[
    MEASURE,
    When::Not(&RADIUS),
    When::Not(&DRILL_AXIAL),
    When::Any(&[AUTOMATIC, ORDINATE, DRILL_ALONG_APPLICATE]),
]);
const L2: When = When::All(&[
    MEASURE,
    When::Not(&RADIUS),
    When::Not(&DRILL_RADIAL),
    When::Not(&DRILL_ALONG_APPLICATE),
    When::Any(&[AUTOMATIC, ABSCISSA]),
]);
const R: When = When::All(&[MEASURE, When::Any(&[AUTOMATIC, WITH_RADIUS]), When::Not(&TURNING), When::Not(&DRILL)]);

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[8]", "result-trigger-minus-abscissa", MINUS_ABSCISSA, "B:9287"),
    length("_OVR[8]", "result-actual-l1", L1, "B:9306"),
    length("_OVR[9]", "result-trigger-minus-abscissa-difference", MINUS_ABSCISSA, "B:9291"),
    length("_OVR[9]", "result-difference-l1", L1, "B:9307"),
    length("_OVR[10]", "result-trigger-plus-abscissa", PLUS_ABSCISSA, "B:9288"),
    length("_OVR[10]", "result-actual-l2", L2, "B:9308"),
    length("_OVR[11]", "result-trigger-plus-abscissa-difference", PLUS_ABSCISSA, "B:9292"),
    length("_OVR[11]", "result-difference-l2", L2, "B:9309"),
    length("_OVR[12]", "result-trigger-minus-ordinate", MINUS_ORDINATE, "B:9289"),
    length("_OVR[12]", "result-actual-radius", R, "B:9310"),
    length("_OVR[13]", "result-trigger-minus-ordinate-difference", MINUS_ORDINATE, "B:9293"),
    length("_OVR[13]", "result-difference-radius", R, "B:9311"),
    length("_OVR[14]", "result-trigger-plus-ordinate", PLUS_ORDINATE, "B:9290"),
    length("_OVR[15]", "result-trigger-plus-ordinate-difference", PLUS_ORDINATE, "B:9294"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:9295;B:9312"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:9296;B:9313"),
    length("_OVR[29]", "result-dimensional-difference", MEASURE, "B:9314"),
    length("_OVR[30]", "result-empirical-value", MEASURE, "B:9315"),
    integer("_OVI[0]", "result-edge", MEASURE, "B:9316"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:9297;B:9317"),
    integer("_OVI[3]", "result-variant", When::Always, "B:9298;B:9318"),
    integer("_OVI[5]", "result-probe", When::Always, "B:9299;B:9319"),
    integer("_OVI[7]", "result-empirical-memory", MEASURE, "B:9320"),
    integer("_OVI[8]", "result-tool", MEASURE, "B:9321"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:9300;B:9322"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:16022"),
];
