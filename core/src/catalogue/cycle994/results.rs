//! What CYCLE994 leaves in the result arrays (B:10936-10975): diameters in the transverse axis with DIAMON, else radii.

use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE, integer, length};
use crate::entry::{ResultField, When};

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    length("_OVR[0]", "result-set-two", When::Always, "B:10941"),
    length("_OVR[1]", "result-set-two-abscissa", ABSCISSA, "B:10942"),
    length("_OVR[2]", "result-set-two-ordinate", ORDINATE, "B:10943"),
    length("_OVR[3]", "result-set-two-applicate", APPLICATE, "B:10944"),
    length("_OVR[4]", "result-actual-two", When::Always, "B:10945"),
    length("_OVR[5]", "result-actual-two-abscissa", ABSCISSA, "B:10946"),
    length("_OVR[6]", "result-actual-two-ordinate", ORDINATE, "B:10947"),
    length("_OVR[7]", "result-actual-two-applicate", APPLICATE, "B:10948"),
    length("_OVR[8]", "result-upper", When::Always, "B:10949"),
    length("_OVR[12]", "result-lower", When::Always, "B:10950"),
    length("_OVR[16]", "result-difference-two", When::Always, "B:10951"),
    length("_OVR[17]", "result-difference-two-abscissa", ABSCISSA, "B:10952"),
    length("_OVR[18]", "result-difference-two-ordinate", ORDINATE, "B:10953"),
    length("_OVR[19]", "result-difference-two-applicate", APPLICATE, "B:10954"),
    length("_OVR[20]", "result-compensation-radius", When::Always, "B:10955;B:10969"),
    length("_OVR[27]", "result-zero-offset-area", When::Always, "B:10956"),
    length("_OVR[28]", "result-safe-area", When::Always, "B:10957"),
    length("_OVR[29]", "result-dimensional-difference", When::Always, "B:10958"),
    length("_OVR[30]", "result-empirical-value", When::Always, "B:10959"),
    length("_OVR[31]", "result-mean-value", When::Always, "B:10960"),
    integer("_OVI[0]", "result-edge", When::Always, "B:10961"),
    integer("_OVI[2]", "result-cycle", When::Always, "B:10962"),
    integer("_OVI[3]", "result-variant", When::Always, "B:16014"),
    integer("_OVI[4]", "result-weighting", When::Always, "B:10963"),
    integer("_OVI[5]", "result-probe", When::Always, "B:10964"),
    integer("_OVI[6]", "result-mean-memory", When::Always, "B:10965"),
    integer("_OVI[7]", "result-empirical-memory", When::Always, "B:10966"),
    integer("_OVI[8]", "result-tool", When::Always, "B:10967"),
    integer("_OVI[9]", "result-alarm", When::Always, "B:10968"),
    integer("_OVI[12]", "result-internal-error", When::Always, "B:16022"),
];
