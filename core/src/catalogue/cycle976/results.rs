//! What CYCLE976 leaves in the result arrays (B:5090-5118). The unit of `_OVR[]` is not defined by the manual; here the
//! active unit counts. Trigger values are those of the directions that were calibrated.

use super::params::{BALL, FOUR, LENGTH, ONE, SKEW, SURFACE, TWO, UNKNOWN};
use crate::catalogue::common::{ABSCISSA, APPLICATE, MINUS, ORDINATE, PLUS, angle, integer, length};
use crate::entry::{ResultField, When};

/// Touched in this direction of the measuring axis, where not all four are.
const PLUS_OF_AXIS: When = When::Any(&[TWO, When::All(&[When::Any(&[ONE, SURFACE]), PLUS])]);
const MINUS_OF_AXIS: When = When::Any(&[TWO, When::All(&[When::Any(&[ONE, SURFACE]), MINUS])]);
const ABSCISSA_MINUS: When = When::Any(&[FOUR, When::All(&[ABSCISSA, MINUS_OF_AXIS])]);
const ABSCISSA_PLUS: When = When::Any(&[FOUR, When::All(&[ABSCISSA, PLUS_OF_AXIS])]);
const ORDINATE_MINUS: When = When::Any(&[FOUR, When::All(&[ORDINATE, MINUS_OF_AXIS])]);
const ORDINATE_PLUS: When = When::Any(&[FOUR, When::All(&[ORDINATE, PLUS_OF_AXIS])]);
const APPLICATE_MINUS: When = When::All(&[When::Any(&[SURFACE, LENGTH]), APPLICATE, MINUS]);
const APPLICATE_PLUS: When = When::All(&[When::Any(&[SURFACE, LENGTH]), APPLICATE, PLUS]);

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[4]", "result-ball-diameter", BALL, "B:5092;B:15933"),
    length("_OVR[5]", "result-ball-difference", BALL, "B:5093;B:15934"),
    length("_OVR[6]", "result-hole-abscissa", UNKNOWN, "B:5094;B:15935"),
    length("_OVR[7]", "result-hole-ordinate", UNKNOWN, "B:5095;B:15936"),
    length("_OVR[8]", "result-trigger-minus-abscissa", ABSCISSA_MINUS, "B:5096;B:15937"),
    length("_OVR[9]", "result-trigger-minus-abscissa-difference", ABSCISSA_MINUS, "B:5102;B:15938"),
    length("_OVR[10]", "result-trigger-plus-abscissa", ABSCISSA_PLUS, "B:5097;B:15939"),
    length("_OVR[11]", "result-trigger-plus-abscissa-difference", ABSCISSA_PLUS, "B:5103;B:15940"),
    length("_OVR[12]", "result-trigger-minus-ordinate", ORDINATE_MINUS, "B:5098;B:15941"),
    length("_OVR[13]", "result-trigger-minus-ordinate-difference", ORDINATE_MINUS, "B:5104;B:15942"),
    length("_OVR[14]", "result-trigger-plus-ordinate", ORDINATE_PLUS, "B:5099;B:15943"),
    length("_OVR[15]", "result-trigger-plus-ordinate-difference", ORDINATE_PLUS, "B:5105;B:15944"),
    length("_OVR[16]", "result-trigger-minus-applicate", APPLICATE_MINUS, "B:5100;B:15945"),
    length("_OVR[17]", "result-trigger-minus-applicate-difference", APPLICATE_MINUS, "B:5106;B:15946"),
    length("_OVR[18]", "result-trigger-plus-applicate", APPLICATE_PLUS, "B:5101;B:15947"),
    length("_OVR[19]", "result-trigger-plus-applicate-difference", APPLICATE_PLUS, "B:5107;B:15948"),
    length("_OVR[20]", "result-skew-abscissa", SKEW, "B:5108;B:15949"),
    length("_OVR[21]", "result-skew-ordinate", SKEW, "B:5109;B:15950"),
    length("_OVR[22]", "result-probe-length", LENGTH, "B:5110;B:15951"),
    angle("_OVR[24]", "result-calibration-angle", When::Always, "B:5111;B:15953"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:5112;B:15956"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:5113;B:15957"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:5114;B:15961"),
    integer("_OVI[3]", "result-variant", When::Always, "B:15962;A:16778"),
    integer("_OVI[5]", "result-probe", When::Always, "B:5115;B:15964"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:5116;B:15968"),
];
