//! What CYCLE998 leaves in the result arrays (B:7326-7357). The angles are those about an axis, as the appendix words
//! them (B:16029); the chapter's "between" (B:7332) means the same.

use super::params::{ONE, TWO};
use crate::catalogue::common::{angle, integer};
use crate::entry::{ResultField, When};

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    angle("_OVR[0]", "result-set-angle", ONE, "B:7332;B:16029"),
    angle("_OVR[0]", "result-set-angle-abscissa", TWO, "B:7332;B:16029"),
    angle("_OVR[1]", "result-set-angle-ordinate", TWO, "B:7333;B:16030"),
    angle("_OVR[4]", "result-actual-angle", ONE, "B:7334;B:16033"),
    angle("_OVR[4]", "result-actual-angle-abscissa", TWO, "B:7334;B:16033"),
    angle("_OVR[5]", "result-actual-angle-ordinate", TWO, "B:7335;B:16034"),
    angle("_OVR[16]", "result-difference-angle", ONE, "B:7336;B:16049"),
    angle("_OVR[16]", "result-difference-angle-abscissa", TWO, "B:7336;B:16049"),
    angle("_OVR[17]", "result-difference-angle-ordinate", TWO, "B:7337;B:16050"),
    angle("_OVR[20]", "result-offset-angle", ONE, "B:7338;B:16054"),
    angle("_OVR[21]", "result-offset-angle-abscissa", TWO, "B:7339;B:16056"),
    angle("_OVR[22]", "result-offset-angle-ordinate", TWO, "B:7340;B:16058"),
    angle("_OVR[23]", "result-offset-angle-applicate", TWO, "B:7348;B:16060"),
    angle("_OVR[28]", "result-safe-area", When::Always, "B:7349;B:16065"),
    angle("_OVR[30]", "result-empirical-value", When::Always, "B:7350;B:16066"),
    integer("_OVI[0]", "result-target", When::Always, "B:7351;B:16069"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:7352;B:16075"),
    integer("_OVI[5]", "result-probe", When::Always, "B:7353;B:16078"),
    integer("_OVI[7]", "result-empirical-memory", When::Always, "B:7354;B:16080"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:7355;B:16082"),
    // the footnote of B:7356 leaves one angle out, which corrects a frame just as well
    integer("_OVI[11]", "result-zero-status", When::Always, "B:7356;B:16084"),
];
