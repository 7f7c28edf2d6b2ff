//! What CYCLE979 leaves in the result arrays (B:6779-6814).

use super::params::{TOOL, ZERO};
use crate::catalogue::common::{integer, length};
use crate::entry::{ResultField, When};

/// In the order of the arrays. The safe area stands there with a zero offset too, which it watches (B:7178; the
/// footnote of B:6799 would leave it out).
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-set-size", When::Always, "B:6781;B:16091;B:2205"),
    length("_OVR[1]", "result-set-centre-abscissa", When::Always, "B:6782;B:16096"),
    length("_OVR[2]", "result-set-centre-ordinate", When::Always, "B:6783;B:16098"),
    length("_OVR[4]", "result-actual-size", When::Always, "B:6784;B:16102"),
    length("_OVR[5]", "result-actual-centre-abscissa", When::Always, "B:6785;B:16107"),
    length("_OVR[6]", "result-actual-centre-ordinate", When::Always, "B:6786;B:16114"),
    length("_OVR[8]", "result-upper", TOOL, "B:6787;B:16118"),
    length("_OVR[12]", "result-lower", TOOL, "B:6788;B:16126"),
    length("_OVR[16]", "result-difference-size", When::Always, "B:6794;B:16134"),
    length("_OVR[17]", "result-difference-centre-abscissa", When::Always, "B:6795;B:16139"),
    length("_OVR[18]", "result-difference-centre-ordinate", When::Always, "B:6796;B:16141"),
    length("_OVR[20]", "result-compensation", TOOL, "B:6797;B:16144"),
    length("_OVR[27]", "result-zero-offset-area", TOOL, "B:6798;B:16156"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:6799;B:16157;B:7178"),
    length("_OVR[29]", "result-dimensional-difference", TOOL, "B:6800;B:16158"),
    length("_OVR[30]", "result-empirical-value", TOOL, "B:6801;B:16159"),
    length("_OVR[31]", "result-mean-value", TOOL, "B:6802;B:16160"),
    integer("_OVI[0]", "result-target", When::Always, "B:6803;B:16162"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:6804;B:16164"),
    integer("_OVI[4]", "result-weighting", TOOL, "B:6805;B:16166"),
    integer("_OVI[5]", "result-probe", When::Always, "B:6806;B:16167"),
    integer("_OVI[6]", "result-mean-memory", TOOL, "B:6807;B:16168"),
    integer("_OVI[7]", "result-empirical-memory", TOOL, "B:6808;B:16169"),
    integer("_OVI[8]", "result-tool", When::Always, "B:6809;B:16170"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:6810;B:16171"),
    integer("_OVI[11]", "result-zero-status", ZERO, "B:6811;B:16172"),
    integer("_OVI[13]", "result-additive", TOOL, "B:6812;B:16174"),
];
