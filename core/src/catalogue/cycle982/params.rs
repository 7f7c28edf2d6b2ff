//! Parameters of CYCLE982 and the conditions that its variant and the tool in use make (B:9369-9375, B:9507-9525,
//! B:9723-9731, B:9835-9841, B:9960-9973).

use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::params as tool_probe;
pub use crate::catalogue::tool_probe::params::{CALIBRATE, MEASURE, WORKPIECE};
use crate::control::machine_data::TOOL_LENGTH_TYPE;

const fn axis(is: &'static [f64]) -> When {
    When::Number { param: names::MA, is }
}

/// All that the tool allows is measured one after the other.
pub const AUTOMATIC: When = mvar(1, &[2]);
/// In the active workpiece system: as digit 2 says, or with `_CBIT[5]`, from before that digit, with the data `_TP`
/// (B:13602-13610).
pub const IN_WORKPIECE: When = When::Any(&[WORKPIECE, BY_SETTING]);
const BY_SETTING: When = When::Setting { name: "_CBIT[5]", is: &[1.0] };
/// Each point is touched twice, the spindle turned in between.
pub const REVERSAL: When = mvar(100, &[1]);
/// Only the radius is measured.
pub const RADIUS: When = mvar(1000, &[1]);
/// Length and radius, from two sides.
pub const BOTH: When = mvar(1000, &[2]);
/// The upper cutting edge, that is the one at the shank.
pub const UPPER: When = mvar(1000, &[3, 4]);
/// The same, with the length measured against the way of approach.
pub const OPPOSITE: When = mvar(1000, &[4]);
/// The radius is measured, alone or with a length.
pub const WITH_RADIUS: When = mvar(1000, &[1, 2, 3, 4]);
/// The tool axis lies along the ordinate; otherwise along the abscissa.
pub const RADIAL: When = mvar(10_000, &[1]);
/// Nothing but the measuring motion is travelled.
pub const INCREMENTAL: When = mvar(100_000, &[1]);
/// Positioned by the cycle.
pub const POSITIONED: When = When::Not(&INCREMENTAL);

/// Measured in the abscissa.
pub const ABSCISSA: When = axis(&[1.0]);
/// Measured in the ordinate.
pub const ORDINATE: When = axis(&[2.0]);
/// A milling tool is in use; 711 to 799 are treated like it (B:9336).
pub const MILLING: When = When::Any(&[When::ToolType(100, 199), When::ToolType(711, 799)]);
/// A drill is in use (B:9334).
pub const DRILL: When = When::ToolType(200, 299);
/// A turning tool is in use (B:9330).
pub const TURNING: When = When::ToolType(500, 599);
/// A drill whose length counts along the applicate; it is measured there (B:10096-10122).
pub const DRILL_ALONG_APPLICATE: When = When::All(&[DRILL, When::Setting { name: TOOL_LENGTH_TYPE, is: &[0.0] }]);
/// The spindle is not turned to the start angle (B:10088).
pub const SPINDLE_AS_IT_IS: When = When::Setting { name: "_CHBIT[20]", is: &[1.0] };

const MEASURED_ONCE: When = When::All(&[MEASURE, POSITIONED]);
const SPINDLE_TURNED: When = When::All(&[MEASURE, When::Not(&TURNING), When::Not(&SPINDLE_AS_IT_IS)]);
const REVERSED: When = When::All(&[MEASURE, REVERSAL, When::Not(&TURNING)]);

/// The digits of `_MVAR`, units first (B:9224-9260, A:10287-10310).
const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one("mvar-task", 1, &[(0, "task-calibrate"), (1, "task-measure-axis"), (2, "task-measure-all")]),
    DigitGroup { renamed: &[(BY_SETTING, 0, "reference-setting")], ..tool_probe::REFERENCE },
    DigitGroup::one("mvar-edges", 100, &[(0, "second-edge-without"), (1, "second-edge-with")]),
    DigitGroup::one("mvar-extent", 1000, EXTENTS),
    DigitGroup::one("mvar-tool-axis", 10_000, &[(0, "tool-axis-axial"), (1, "tool-axis-radial")]),
    DigitGroup::one("mvar-approach", 100_000, &[(0, "approach-normal"), (1, "approach-incremental")]),
];
const EXTENTS: &[(i64, &str)] = &[
    (0, "extent-plain"),
    (1, "extent-radius"),
    (2, "extent-length-radius"),
    (3, "extent-upper"),
    (4, "extent-upper-opposite"),
];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param {
        kind: Kind::Variant(MVAR_DIGITS),
        example: "12001",
        source: "B:9224-9279;B:15814-15817;A:10287-10319",
        ..common::MVAR
    },
    Param {
        kind: Kind::ChoiceBy(&[
            (CALIBRATE, &[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate")]),
            (When::All(&[RADIUS, RADIAL]), &[(1, "ma-lathe-radius")]),
            (RADIUS, &[(2, "ma-lathe-radius-ordinate")]),
            (When::All(&[BOTH, RADIAL]), &[(1, "ma-lathe-l2-radius")]),
            (BOTH, &[(2, "ma-lathe-l1-radius")]),
            (When::Always, &[(1, "ma-lathe-l2"), (2, "ma-lathe-l1")]),
        ]),
        needs: &[
            optional(When::All(&[MEASURE, DRILL_ALONG_APPLICATE]), "need-axis-ignored"),
            required(When::Not(&AUTOMATIC), "need-axis-tool-probe"),
        ],
        key: "ma-lathe-measured",
        labels: &[(CALIBRATE, "ma-calibrate")],
        example: "1",
        source: "B:9279;B:9371;B:9516;B:10122;B:15812;A:16586",
        ..common::MA
    },
    Param {
        needs: &[required(INCREMENTAL, "need-direction-incremental")],
        key: "md-incremental",
        source: "B:9838;B:9967;B:15813",
        ..common::MD
    },
    Param {
        range: Range::closed(0.0, 360.0),
        needs: &[
            required(When::All(&[SPINDLE_TURNED, MILLING]), "need-start-angle-spindle"),
            optional(SPINDLE_TURNED, "need-start-angle-milling"),
        ],
        key: "sta1-milling-spindle",
        example: "15",
        source: "B:9519;B:9968;B:15828",
        ..common::STA1
    },
    Param {
        needs: &[required(When::All(&[REVERSED, MILLING]), "need-second-edge"), optional(REVERSED, "need-second-edge")],
        key: "cora-second-edge",
        source: "B:9521;B:9602;B:15803",
        ..common::CORA
    },
    tool_probe::PRNUM,
    Param {
        key: "fa-tool",
        labels: &[(INCREMENTAL, "fa-present-position")],
        example: "3",
        source: "B:9738;B:9825;B:15807",
        ..common::FA
    },
    Param {
        needs: &[optional(POSITIONED, "need-default")],
        key: "tsa-tool",
        labels: &[(CALIBRATE, "tsa-tool-probe")],
        example: "3",
        source: "B:9840;B:9972;B:15837",
        ..common::TSA
    },
    Param { source: "B:2164-2170;B:9610;B:15839", ..common::VMS },
    tool_probe::NMSP,
    Param { needs: &[optional(MEASURED_ONCE, "need-memory-empirical")], ..tool_probe::EVNUM },
    Param { needs: &[optional(POSITIONED, "need-default")], example: "0.001", ..tool_probe::TZL },
    Param { needs: &[optional(MEASURED_ONCE, "need-default")], example: "2.5", ..tool_probe::TDIF },
];
