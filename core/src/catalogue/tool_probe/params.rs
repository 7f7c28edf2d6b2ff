//! Parameters of the cycles at a tool probe. A cycle fills in when it needs them.

use crate::catalogue::prelude::*;

/// The probe is calibrated.
pub const CALIBRATE: When = mvar(1, &[0]);
/// A tool is measured.
pub const MEASURE: When = When::Not(&CALIBRATE);
/// The data are those of `_TPW`, which count in the active workpiece system.
pub const WORKPIECE: When = mvar(10, &[1]);

/// Second digit of `_MVAR`: whether the probe is in the machine (`_TP`) or in the active workpiece system (`_TPW`)
/// (B:4186-4196, B:9224-9260).
pub const REFERENCE: DigitGroup =
    DigitGroup::one("mvar-reference", 10, &[(0, "reference-machine"), (1, "reference-workpiece")]);

/// `_PRNUM`: a tool probe has no digit for its type (B:2277, B:15416).
pub const PRNUM: Param = Param {
    kind: Kind::Integer,
    range: Range::closed(1.0, 99.0),
    key: "prnum-tool",
    source: "B:2277;B:15416-15417;A:15852",
    ..common::PRNUM
};
/// `_EVNUM`: tool measurement forms no mean value, so that only the lower four digits count (B:2328, B:4322).
pub const EVNUM: Param = Param {
    kind: Kind::Integer,
    key: "evnum-tool",
    labels: &[],
    example: "0",
    source: "B:2303-2342;B:4322",
    ..common::EVNUM
};
/// `_TZL`.
pub const TZL: Param =
    Param { needs: common::ALWAYS_OPTIONAL, key: "tzl-tool", source: "B:1382-1394;B:4324-4326", ..common::TZL };
/// `_TDIF`.
pub const TDIF: Param = Param { key: "tdif-tool", source: "B:1335-1340;B:4937;A:15943", ..common::TDIF };
/// `_NMSP`.
pub const NMSP: Param = Param { source: "B:2344-2356", ..common::NMSP };
