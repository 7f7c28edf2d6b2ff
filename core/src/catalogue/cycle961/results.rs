//! What CYCLE961 leaves in the result arrays (B:7871-7889). The chapter names abscissa and WCS once too often; the
//! appendix has them right (B:16033-16057).

use crate::catalogue::common::{angle, integer, length};
use crate::entry::{ResultField, When};

const ALWAYS: When = When::Always;

/// In the order of the arrays.
pub const RESULTS: &[ResultField] = &[
    angle("_OVR[4]", "result-edge-angle", ALWAYS, "B:7879;B:16033"),
    length("_OVR[5]", "result-corner-abscissa", ALWAYS, "B:7880;B:16034"),
    length("_OVR[6]", "result-corner-ordinate", ALWAYS, "B:16035;A:8871"),
    angle("_OVR[20]", "result-edge-angle-machine", ALWAYS, "B:16053;A:8872"),
    length("_OVR[21]", "result-corner-abscissa-machine", ALWAYS, "B:7883;B:16055"),
    length("_OVR[22]", "result-corner-ordinate-machine", ALWAYS, "B:7884;B:16057"),
    integer("_OVI[2]", "result-cycle", ALWAYS, "B:7885;B:16075"),
    integer("_OVI[3]", "result-variant", ALWAYS, "B:7886;B:16076"),
    integer("_OVI[5]", "result-probe", ALWAYS, "B:7887;B:16078"),
    integer("_OVI[9]", "result-alarm", ALWAYS, "B:7888;B:16082"),
];
