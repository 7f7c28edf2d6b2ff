//! What CYCLE977 leaves in the result arrays (B:5673-5740).

use super::params::{RECTANGLE, SINGLE, TOOL, ZERO};
use crate::catalogue::common::{integer, length};
use crate::entry::{ResultField, When};

const SINGLE_TOOL: When = When::All(&[SINGLE, TOOL]);
const RECTANGLE_TOOL: When = When::All(&[RECTANGLE, TOOL]);

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-set-size", SINGLE, "B:5675;B:16091-16094;B:2205"),
    length("_OVR[1]", "result-set-centre-abscissa", SINGLE, "B:5676;B:5892;B:16096"),
    length("_OVR[2]", "result-set-centre-ordinate", SINGLE, "B:5677;B:5892;B:16098"),
    length("_OVR[4]", "result-actual-size", SINGLE, "B:5678;B:5773;B:16102-16105"),
    length("_OVR[5]", "result-actual-centre-abscissa", SINGLE, "B:5679;B:16107"),
    length("_OVR[6]", "result-actual-centre-ordinate", SINGLE, "B:5680;B:16114"),
    length("_OVR[8]", "result-upper", SINGLE_TOOL, "B:5681;B:16118;B:2211"),
    length("_OVR[12]", "result-lower", SINGLE_TOOL, "B:5682;B:16126;B:2211"),
    length("_OVR[16]", "result-difference-size", SINGLE, "B:5683;B:16134"),
    length("_OVR[17]", "result-difference-centre-abscissa", SINGLE, "B:5684;B:16139"),
    length("_OVR[18]", "result-difference-centre-ordinate", SINGLE, "B:5685;B:16141"),
    length("_OVR[20]", "result-compensation", TOOL, "B:5686;B:16144"),
    length("_OVR[27]", "result-zero-offset-area", TOOL, "B:5687;B:16156"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:5688;B:16157"),
    length("_OVR[29]", "result-dimensional-difference", TOOL, "B:5689;B:16158"),
    length("_OVR[30]", "result-empirical-value", TOOL, "B:5690;B:16159"),
    length("_OVR[31]", "result-mean-value", TOOL, "B:5691;B:16160"),
    length("_OVR[0]", "result-set-length-abscissa", RECTANGLE, "B:5709;B:16095"),
    length("_OVR[1]", "result-set-length-ordinate", RECTANGLE, "B:5710;B:16097"),
    length("_OVR[2]", "result-set-centre-abscissa", RECTANGLE, "B:5711;B:16099"),
    length("_OVR[3]", "result-set-centre-ordinate", RECTANGLE, "B:5712;B:16101"),
    length("_OVR[4]", "result-actual-length-abscissa", RECTANGLE, "B:5713;B:16106"),
    length("_OVR[5]", "result-actual-length-ordinate", RECTANGLE, "B:5714;B:16113"),
    length("_OVR[6]", "result-actual-centre-abscissa", RECTANGLE, "B:5715;B:16115"),
    length("_OVR[7]", "result-actual-centre-ordinate", RECTANGLE, "B:5716;B:16117"),
    length("_OVR[8]", "result-upper-abscissa", RECTANGLE_TOOL, "B:5717;B:16122"),
    length("_OVR[9]", "result-upper-ordinate", RECTANGLE_TOOL, "B:5718;B:16123"),
    length("_OVR[12]", "result-lower-abscissa", RECTANGLE_TOOL, "B:5719;B:16130"),
    length("_OVR[13]", "result-lower-ordinate", RECTANGLE_TOOL, "B:5720;B:16131"),
    length("_OVR[16]", "result-difference-length-abscissa", RECTANGLE, "B:5721;B:16138"),
    length("_OVR[17]", "result-difference-length-ordinate", RECTANGLE, "B:5722;B:16140"),
    length("_OVR[18]", "result-difference-centre-abscissa", RECTANGLE, "B:5723;B:16142"),
    length("_OVR[19]", "result-difference-centre-ordinate", RECTANGLE, "B:5724;B:16143"),
    integer("_OVI[0]", "result-target", When::Always, "B:5692;B:16162"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:5693;B:16164"),
    integer("_OVI[4]", "result-weighting", TOOL, "B:5694;B:16166"),
    integer("_OVI[5]", "result-probe", When::Always, "B:5695;B:16167"),
    integer("_OVI[6]", "result-mean-memory", TOOL, "B:5696;B:16168"),
    integer("_OVI[7]", "result-empirical-memory", TOOL, "B:5697;B:16169"),
    integer("_OVI[8]", "result-tool", When::Always, "B:5698;B:16170"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:5699;B:16171"),
    integer("_OVI[11]", "result-zero-status", ZERO, "B:5700;B:16172"),
    integer("_OVI[13]", "result-additive", TOOL, "B:5701;B:16174"),
    integer("_OVI[3]", "result-variant", When::Always, "B:16165;A:16962"),
];
