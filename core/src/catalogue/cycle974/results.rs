//! What CYCLE974 leaves in the result arrays (B:10461-10505).

use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE, TOOL_OFFSET, ZERO_OFFSET, integer, length};
use crate::entry::{ResultField, When};

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-set-position", When::Always, "B:10467"),
    length("_OVR[1]", "result-set-abscissa", ABSCISSA, "B:10468"),
    length("_OVR[2]", "result-set-ordinate", ORDINATE, "B:10469"),
    length("_OVR[3]", "result-set-applicate", APPLICATE, "B:10470"),
    length("_OVR[4]", "result-actual-position", When::Always, "B:10471"),
    length("_OVR[5]", "result-actual-abscissa", ABSCISSA, "B:10472"),
    length("_OVR[6]", "result-actual-ordinate", ORDINATE, "B:10473"),
    length("_OVR[7]", "result-actual-applicate", APPLICATE, "B:10474"),
    length("_OVR[8]", "result-upper", TOOL_OFFSET, "B:10475"),
    length("_OVR[12]", "result-lower", TOOL_OFFSET, "B:10476"),
    length("_OVR[16]", "result-difference-position", When::Always, "B:10477"),
    length("_OVR[17]", "result-difference-abscissa", ABSCISSA, "B:10478"),
    length("_OVR[18]", "result-difference-ordinate", ORDINATE, "B:10479"),
    length("_OVR[19]", "result-difference-applicate", APPLICATE, "B:10480"),
    length("_OVR[20]", "result-compensation-radius", TOOL_OFFSET, "B:10481;B:10505"),
    length("_OVR[27]", "result-zero-offset-area", TOOL_OFFSET, "B:10482"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:10483"),
    length("_OVR[29]", "result-dimensional-difference", TOOL_OFFSET, "B:10484"),
    length("_OVR[30]", "result-empirical-value", When::Always, "B:10485"),
    length("_OVR[31]", "result-mean-value", TOOL_OFFSET, "B:10486"),
    integer("_OVI[0]", "result-target", When::Always, "B:10487"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:10488"),
    integer("_OVI[3]", "result-variant", When::Always, "B:16014"),
    integer("_OVI[4]", "result-weighting", TOOL_OFFSET, "B:10489"),
    integer("_OVI[5]", "result-probe", When::Always, "B:10497"),
    integer("_OVI[6]", "result-mean-memory", TOOL_OFFSET, "B:10498"),
    integer("_OVI[7]", "result-empirical-memory", When::Always, "B:10499"),
    integer("_OVI[8]", "result-tool", When::Always, "B:10500"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:10501"),
    integer("_OVI[11]", "result-zero-status", ZERO_OFFSET, "B:10502"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:16022"),
];
