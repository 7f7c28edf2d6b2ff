//! Parameters of CYCLE971 (B:4410-4432, B:4636-4656, B:4830-4859).

pub use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::params as tool_probe;
pub use crate::catalogue::tool_probe::params::{CALIBRATE, MEASURE, WORKPIECE};
use crate::support;

/// With the spindle turning.
pub const ROTATING: When = mvar(1, &[2]);
/// The tool is in front of the probe; nothing but the measuring block is travelled.
pub const INCREMENTAL: When = mvar(10_000, &[1]);
/// All sides one after the other.
pub const AUTOMATIC: When = mvar(100_000, &[1]);
/// Measured in the plane (B:15395-15401).
pub const IN_PLANE: When = When::Digit { param: names::MA, place: 1, is: &[1, 2] };
/// The radius is measured.
pub const RADIUS: When = When::All(&[MEASURE, IN_PLANE]);

const MVAR_DIGITS: &[DigitGroup] = &[
    DigitGroup::one("mvar-task", 1, &[(0, "task-calibrate"), (1, "task-still"), (2, "task-rotating")]),
    tool_probe::REFERENCE,
    DigitGroup {
        choices: &[(0, "approach-normal"), (1, "approach-incremental"), (10, "approach-automatic")],
        ..DigitGroup::number("mvar-approach", 10_000, 2)
    },
];

const AXES: &[(i64, &str)] = &[(1, "ma-abscissa"), (2, "ma-ordinate"), (3, "ma-applicate")];
const CALIBRATED_AXES: &[(i64, &str)] = &[
    (1, "ma-abscissa"),
    (2, "ma-ordinate"),
    (3, "ma-applicate"),
    (201, "ma-abscissa-centred"),
    (102, "ma-ordinate-centred"),
    (103, "ma-applicate-abscissa"),
    (203, "ma-applicate-ordinate"),
];
const TOOL_AXES: &[(i64, &str)] = &[
    (1, "ma-radius-abscissa"),
    (2, "ma-radius-ordinate"),
    (3, "ma-length"),
    (103, "ma-length-abscissa"),
    (203, "ma-length-ordinate"),
];

/// The form has fields for feed and speed: it is that of the control's own support, and asks for them (B:12537-12539).
const OWN_SPEEDS: &[Need] = &[optional(
    When::All(&[
        ROTATING,
        When::Setting { name: support::FORMS, is: &[1.0] },
        When::Setting { name: SPEEDS_IN_FORM, is: &[1.0] },
    ]),
    "need-own-speeds",
)];

/// The entry of the mask that gives the form these fields.
pub const SPEEDS_IN_FORM: &str = "_MZ_MASK[7]";

/// Speed of one probing, 1/min; 0 ends the probings (B:13515-13520).
const fn speed(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { name, key, range: Range::NOT_NEGATIVE, needs: OWN_SPEEDS, source, ..common::PARAM }
}

/// Feed of one probing.
const fn feed(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { unit: Unit::BasicFeed, ..speed(name, key, source) }
}

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param {
        kind: Kind::Variant(MVAR_DIGITS),
        example: "1",
        source: "B:4186-4196;B:4621-4622;B:15403-15414",
        ..common::MVAR
    },
    Param {
        kind: Kind::ChoiceBy(&[(INCREMENTAL, AXES), (CALIBRATE, CALIBRATED_AXES), (When::Always, TOOL_AXES)]),
        range: Range::closed(1.0, 203.0),
        needs: &[required(When::Not(&AUTOMATIC), "need-axis-tool-probe")],
        key: "ma-measure-tool",
        labels: &[(CALIBRATE, "ma-calibrate")],
        example: "103",
        source: "B:4419-4420;B:4842-4846;B:15395-15401;A:16199",
        ..common::MA
    },
    Param {
        range: Range::NOT_NEGATIVE,
        needs: &[
            required(MEASURE, "need-offset-edge"),
            optional(AUTOMATIC, "need-offset-wide"),
            optional(When::All(&[When::Not(&INCREMENTAL), APPLICATE]), "need-offset-wide"),
        ],
        key: "id-radius",
        labels: &[(CALIBRATE, "id-calibrate"), (APPLICATE, "id-length")],
        example: "2.2",
        source: "B:4426;B:4654-4656;B:4849;B:15391",
        ..common::ID
    },
    tool_probe::PRNUM,
    Param {
        range: Range::ANY, // signed with incremental calibration; see the checks
        usual: Range::closed(-100.0, 100.0),
        needs: &[required(INCREMENTAL, "need-signed-path"), optional(When::Always, "need-default")],
        key: "fa-tool",
        labels: &[(INCREMENTAL, "fa-incremental")],
        example: "3",
        source: "B:4421-4424;B:2221;B:15389-15390;A:15847",
        ..common::FA
    },
    Param {
        needs: &[optional(When::Not(&INCREMENTAL), "need-default")],
        key: "tsa-tool",
        labels: &[(CALIBRATE, "tsa-tool-probe")],
        example: "2",
        source: "B:4326;B:4432;B:15431;A:15844",
        ..common::TSA
    },
    Param {
        needs: &[optional(When::Not(&ROTATING), "need-default")],
        source: "B:2164-2170;B:4789;B:15433",
        ..common::VMS
    },
    tool_probe::NMSP,
    speed(names::MFS[0], "mfs-speed-1", "B:13515"),
    feed(names::MFS[1], "mfs-feed-1", "B:13516"),
    speed(names::MFS[2], "mfs-speed-2", "B:13517"),
    feed(names::MFS[3], "mfs-feed-2", "B:13518"),
    speed(names::MFS[4], "mfs-speed-3", "B:13519"),
    feed(names::MFS[5], "mfs-feed-3", "B:13520"),
    Param { needs: &[optional(MEASURE, "need-memory-empirical")], ..tool_probe::EVNUM },
    Param { needs: &[optional(When::Not(&INCREMENTAL), "need-default")], example: "0.04", ..tool_probe::TZL },
    Param { needs: &[optional(MEASURE, "need-default")], example: "1.6", ..tool_probe::TDIF },
];
