//! What CYCLE978 leaves in the result arrays (B:6336-6370).

use super::params::{TOOL, ZERO};
use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE, integer, length};
use crate::entry::{ResultField, When};

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-set-position", When::Always, "B:6336;B:16091"),
    length("_OVR[1]", "result-set-abscissa", ABSCISSA, "B:6337;B:16096"),
    length("_OVR[2]", "result-set-ordinate", ORDINATE, "B:6338;B:16098"),
    length("_OVR[3]", "result-set-applicate", APPLICATE, "B:6339;B:16100"),
    length("_OVR[4]", "result-actual-position", When::Always, "B:6340;B:16102"),
    length("_OVR[5]", "result-actual-abscissa", ABSCISSA, "B:6341;B:16107"),
    length("_OVR[6]", "result-actual-ordinate", ORDINATE, "B:6342;B:16114"),
    length("_OVR[7]", "result-actual-applicate", APPLICATE, "B:6343;B:16116"),
    length("_OVR[8]", "result-upper", TOOL, "B:6344;B:16118"),
    length("_OVR[12]", "result-lower", TOOL, "B:6345;B:16126"),
    length("_OVR[16]", "result-difference-position", When::Always, "B:6346;B:16134"),
    length("_OVR[17]", "result-difference-abscissa", ABSCISSA, "B:6347;B:16139"),
    length("_OVR[18]", "result-difference-ordinate", ORDINATE, "B:6348;B:16141"),
    length("_OVR[19]", "result-difference-applicate", APPLICATE, "B:6349;B:16143"),
    length("_OVR[20]", "result-compensation", TOOL, "B:6350;B:16144"),
    length("_OVR[27]", "result-zero-offset-area", TOOL, "B:6351;B:16156"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:6357;B:16157"),
    length("_OVR[29]", "result-dimensional-difference", TOOL, "B:6358;B:16158"),
    length("_OVR[30]", "result-empirical-value", When::Always, "B:6359;B:16159"),
    length("_OVR[31]", "result-mean-value", TOOL, "B:6360;B:16160"),
    integer("_OVI[0]", "result-target", When::Always, "B:6361;B:16162"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:6362;B:16164"),
    integer("_OVI[4]", "result-weighting", TOOL, "B:6363;B:16166"),
    integer("_OVI[5]", "result-probe", When::Always, "B:6364;B:16167"),
    integer("_OVI[6]", "result-mean-memory", TOOL, "B:6365;B:16168"),
    integer("_OVI[7]", "result-empirical-memory", When::Always, "B:6366;B:16169;A:7221"),
    integer("_OVI[8]", "result-tool", When::Always, "B:6367;B:16170"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:6368;B:16171"),
    integer("_OVI[11]", "result-zero-status", ZERO, "B:6369;B:16172"),
    integer("_OVI[13]", "result-additive", TOOL, "B:6370;B:16174"),
];
