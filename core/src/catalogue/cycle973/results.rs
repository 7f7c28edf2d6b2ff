//! What CYCLE973 leaves in the result arrays (B:10183-10205). The unit of `_OVR[]` is not defined by the manual; here
//! the active unit counts. Trigger values are those of the axis and directions of the last call.

use super::params::{BALL, ONE, SKEW, SURFACE, TWO};
use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE, length};
use crate::catalogue::prelude::*;

const SINGLE: When = When::Any(&[ONE, SURFACE]);
const PLUS: When = When::Any(&[TWO, When::All(&[SINGLE, common::PLUS])]);
const MINUS: When = When::Any(&[TWO, When::All(&[SINGLE, common::MINUS])]);
const ABSCISSA_MINUS: When = When::All(&[ABSCISSA, MINUS]);
const ABSCISSA_PLUS: When = When::All(&[ABSCISSA, PLUS]);
const ORDINATE_MINUS: When = When::All(&[ORDINATE, MINUS]);
const ORDINATE_PLUS: When = When::All(&[ORDINATE, PLUS]);
/// The third axis is in the general table only (B:15945-15948).
const APPLICATE_MINUS: When = When::All(&[SURFACE, APPLICATE, MINUS]);
const APPLICATE_PLUS: When = When::All(&[SURFACE, APPLICATE, PLUS]);

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[4]", "result-ball-diameter", BALL, "B:10189"),
    length("_OVR[5]", "result-ball-difference", BALL, "B:10190"),
    length("_OVR[8]", "result-trigger-minus-abscissa", ABSCISSA_MINUS, "B:10191"),
    length("_OVR[9]", "result-trigger-minus-abscissa-difference", ABSCISSA_MINUS, "B:10195"),
    length("_OVR[10]", "result-trigger-plus-abscissa", ABSCISSA_PLUS, "B:10192"),
    length("_OVR[11]", "result-trigger-plus-abscissa-difference", ABSCISSA_PLUS, "B:10196"),
    length("_OVR[12]", "result-trigger-minus-ordinate", ORDINATE_MINUS, "B:10193"),
    length("_OVR[13]", "result-trigger-minus-ordinate-difference", ORDINATE_MINUS, "B:10197"),
    length("_OVR[14]", "result-trigger-plus-ordinate", ORDINATE_PLUS, "B:10194"),
    length("_OVR[15]", "result-trigger-plus-ordinate-difference", ORDINATE_PLUS, "B:10198"),
    length("_OVR[16]", "result-trigger-minus-applicate", APPLICATE_MINUS, "B:15945"),
    length("_OVR[17]", "result-trigger-minus-applicate-difference", APPLICATE_MINUS, "B:15946"),
    length("_OVR[18]", "result-trigger-plus-applicate", APPLICATE_PLUS, "B:15947"),
    length("_OVR[19]", "result-trigger-plus-applicate-difference", APPLICATE_PLUS, "B:15948"),
    length("_OVR[20]", "result-skew-abscissa", When::All(&[SKEW, ABSCISSA]), "B:10199"),
    length("_OVR[21]", "result-skew-ordinate", When::All(&[SKEW, ORDINATE]), "B:10200"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:10201"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:10202"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:10203"),
    integer("_OVI[3]", "result-variant", When::Always, "B:15962"),
    integer("_OVI[5]", "result-probe", When::Always, "B:10204"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:10205"),
];
