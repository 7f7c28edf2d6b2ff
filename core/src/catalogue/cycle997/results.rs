//! What CYCLE997 leaves in the result arrays (B:8263-8307).

use super::params::THREE;
use crate::catalogue::common::{integer, length};
use crate::entry::{ResultField, When};

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-sphere1-set-diameter", When::Always, "B:8267;B:16029"),
    length("_OVR[1]", "result-sphere1-set-abscissa", When::Always, "B:8268;B:16030"),
    length("_OVR[2]", "result-sphere1-set-ordinate", When::Always, "B:8269;B:16031"),
    length("_OVR[3]", "result-sphere1-set-applicate", When::Always, "B:8270;B:16032"),
    length("_OVR[4]", "result-sphere1-actual-diameter", When::Always, "B:8271;B:16033"),
    length("_OVR[5]", "result-sphere1-actual-abscissa", When::Always, "B:8272;B:16034"),
    length("_OVR[6]", "result-sphere1-actual-ordinate", When::Always, "B:8273;B:16035"),
    length("_OVR[7]", "result-sphere1-actual-applicate", When::Always, "B:8277;B:16036"),
    length("_OVR[8]", "result-sphere1-difference-diameter", When::Always, "B:8278;B:16037"),
    length("_OVR[9]", "result-sphere1-difference-abscissa", When::Always, "B:8279;B:16038"),
    length("_OVR[10]", "result-sphere1-difference-ordinate", When::Always, "B:8280;B:16039"),
    length("_OVR[11]", "result-sphere1-difference-applicate", When::Always, "B:8281;B:16040"),
    length("_OVR[12]", "result-sphere2-actual-diameter", THREE, "B:8282;B:16045"),
    length("_OVR[13]", "result-sphere2-actual-abscissa", THREE, "B:8283;B:16046"),
    length("_OVR[14]", "result-sphere2-actual-ordinate", THREE, "B:8284;B:16047"),
    length("_OVR[15]", "result-sphere2-actual-applicate", THREE, "B:8285;B:16048"),
    length("_OVR[16]", "result-sphere2-difference-diameter", THREE, "B:8286;B:16049"),
    length("_OVR[17]", "result-sphere2-difference-abscissa", THREE, "B:8287;B:16050"),
    length("_OVR[18]", "result-sphere2-difference-ordinate", THREE, "B:8288;B:16051"),
    length("_OVR[19]", "result-sphere2-difference-applicate", THREE, "B:8289;B:16052"),
    length("_OVR[20]", "result-sphere3-actual-diameter", THREE, "B:8290;B:16053"),
    length("_OVR[21]", "result-sphere3-actual-abscissa", THREE, "B:8291;B:16055"),
    length("_OVR[22]", "result-sphere3-actual-ordinate", THREE, "B:8292;B:16057"),
    length("_OVR[23]", "result-sphere3-actual-applicate", THREE, "B:8293;B:16059"),
    length("_OVR[24]", "result-sphere3-difference-diameter", THREE, "B:8294;B:16061"),
    length("_OVR[25]", "result-sphere3-difference-abscissa", THREE, "B:8295;B:16062"),
    length("_OVR[26]", "result-sphere3-difference-ordinate", THREE, "B:8296;B:16063"),
    length("_OVR[27]", "result-sphere3-difference-applicate", THREE, "B:8297;B:16064"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:8298;B:16065"),
    integer("_OVI[0]", "result-target", When::Always, "B:8299;B:16069"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:8300;B:16075"),
    integer("_OVI[5]", "result-probe", When::Always, "B:8301;B:16078"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:8302;B:16082"),
    integer("_OVI[11]", "result-zero-status", When::Always, "B:8303;B:16084"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:8304;B:16085"),
];
