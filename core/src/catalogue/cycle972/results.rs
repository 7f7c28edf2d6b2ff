//! What CYCLE972 leaves in the result arrays (B:8777-8812). The unit of `_OVR[]` is not defined by the manual; here the
//! active unit counts.

use super::params::{ABSCISSA, CALIBRATE, MEASURE, ORDINATE};
use crate::catalogue::common::{integer, length};
use crate::entry::{ResultField, When};

const CALIBRATED_ABSCISSA: When = When::All(&[CALIBRATE, ABSCISSA]);
const CALIBRATED_ORDINATE: When = When::All(&[CALIBRATE, ORDINATE]);
const L1: When = When::All(&[MEASURE, ORDINATE]);
const L2: When = When::All(&[MEASURE, ABSCISSA]);

/// In the order of the arrays. Of a pair of directions, the one that was touched is set.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[8]", "result-trigger-minus-abscissa", CALIBRATED_ABSCISSA, "B:8779"),
    length("_OVR[8]", "result-actual-l1", L1, "B:8798"),
    length("_OVR[9]", "result-trigger-minus-abscissa-difference", CALIBRATED_ABSCISSA, "B:8783"),
    length("_OVR[9]", "result-difference-l1", L1, "B:8799"),
    length("_OVR[10]", "result-trigger-plus-abscissa", CALIBRATED_ABSCISSA, "B:8780"),
    length("_OVR[10]", "result-actual-l2", L2, "B:8800"),
    length("_OVR[11]", "result-trigger-plus-abscissa-difference", CALIBRATED_ABSCISSA, "B:8784"),
    length("_OVR[11]", "result-difference-l2", L2, "B:8801"),
    length("_OVR[12]", "result-trigger-minus-ordinate", CALIBRATED_ORDINATE, "B:8781"),
    length("_OVR[13]", "result-trigger-minus-ordinate-difference", CALIBRATED_ORDINATE, "B:8785"),
    length("_OVR[14]", "result-trigger-plus-ordinate", CALIBRATED_ORDINATE, "B:8782"),
    length("_OVR[15]", "result-trigger-plus-ordinate-difference", CALIBRATED_ORDINATE, "B:8786"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:8787;B:8802"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:8788;B:8803"),
    length("_OVR[29]", "result-dimensional-difference", MEASURE, "B:8804"),
    length("_OVR[30]", "result-empirical-value", MEASURE, "B:8805"),
    integer("_OVI[0]", "result-edge", MEASURE, "B:8806"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:8789;B:8807"),
    integer("_OVI[3]", "result-variant", When::Always, "B:8790;B:8808"),
    integer("_OVI[5]", "result-probe", When::Always, "B:8791;B:8809"),
    integer("_OVI[7]", "result-empirical-memory", MEASURE, "B:8810"),
    integer("_OVI[8]", "result-tool", MEASURE, "B:8811"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:8792;B:8812"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:16022"),
];
