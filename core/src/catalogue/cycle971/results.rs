//! What CYCLE971 leaves in the result arrays (B:4198-4241). Trigger values count by geometry axis, not by plane
//! (B:4204-4215; the appendix names the axes of the plane, B:15937-15948). The unit of `_OVR[]` is not defined by the
//! manual; here the active unit counts.

use super::params::{ABSCISSA, APPLICATE, AUTOMATIC, CALIBRATE, MEASURE, ORDINATE, RADIUS};
use crate::catalogue::common::length;
use crate::catalogue::prelude::*;

const G17: When = When::Plane(Plane::G17);
const G18: When = When::Plane(Plane::G18);
const G19: When = When::Plane(Plane::G19);

/// The probe is calibrated in the 1st geometry axis.
const FIRST: When = When::All(&[
    CALIBRATE,
    When::Any(&[AUTOMATIC, When::All(&[G17, ABSCISSA]), When::All(&[G18, ORDINATE]), When::All(&[G19, APPLICATE])]),
]);
/// In the 2nd.
const SECOND: When = When::All(&[
    CALIBRATE,
    When::Any(&[AUTOMATIC, When::All(&[G17, ORDINATE]), When::All(&[G18, APPLICATE]), When::All(&[G19, ABSCISSA])]),
]);
/// In the 3rd.
const THIRD: When = When::All(&[
    CALIBRATE,
    When::Any(&[AUTOMATIC, When::All(&[G17, APPLICATE]), When::All(&[G18, ABSCISSA]), When::All(&[G19, ORDINATE])]),
]);
const LENGTH: When = When::All(&[MEASURE, APPLICATE]);

/// In the order of the arrays. Of a pair of directions, the one that was touched is set.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[8]", "result-trigger-minus-1", FIRST, "B:4204;A:4838"),
    length("_OVR[8]", "result-actual-l1", LENGTH, "B:4227;A:4861"),
    length("_OVR[9]", "result-trigger-minus-1-difference", FIRST, "B:4210;A:4844"),
    length("_OVR[9]", "result-difference-l1", LENGTH, "B:4229;A:4863"),
    length("_OVR[10]", "result-trigger-plus-1", FIRST, "B:4205;A:4839"),
    length("_OVR[10]", "result-actual-radius", RADIUS, "B:4228;A:4862"),
    length("_OVR[11]", "result-trigger-plus-1-difference", FIRST, "B:4211;A:4845"),
    length("_OVR[11]", "result-difference-radius", RADIUS, "B:4230;A:4864"),
    length("_OVR[12]", "result-trigger-minus-2", SECOND, "B:4206;A:4840"),
    length("_OVR[13]", "result-trigger-minus-2-difference", SECOND, "B:4212;A:4847"),
    length("_OVR[14]", "result-trigger-plus-2", SECOND, "B:4207;A:4841"),
    length("_OVR[15]", "result-trigger-plus-2-difference", SECOND, "B:4213;A:4848"),
    length("_OVR[16]", "result-trigger-minus-3", THIRD, "B:4208;A:4842"),
    length("_OVR[17]", "result-trigger-minus-3-difference", THIRD, "B:4214;A:4849"),
    length("_OVR[18]", "result-trigger-plus-3", THIRD, "B:4209;A:4843"),
    length("_OVR[19]", "result-trigger-plus-3-difference", THIRD, "B:4215;A:4850"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:4216;B:4231"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:4217;B:4232"),
    length("_OVR[29]", "result-dimensional-difference", MEASURE, "B:4233"),
    length("_OVR[30]", "result-empirical-value", MEASURE, "B:4234"),
    integer("_OVI[0]", "result-edge", MEASURE, "B:4235"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:4218;B:4236"),
    integer("_OVI[3]", "result-variant", When::Always, "B:4219;B:4237"),
    integer("_OVI[5]", "result-probe", When::Always, "B:4220;B:4238"),
    integer("_OVI[7]", "result-empirical-memory", MEASURE, "B:4239"),
    integer("_OVI[8]", "result-tool", MEASURE, "B:4240"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:4221;B:4241"),
];
