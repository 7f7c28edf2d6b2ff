//! Parameters of CYCLE972 (B:8856-8862, B:9010-9018).

use crate::catalogue::common;
use crate::catalogue::common::optional;
use crate::catalogue::tool_probe::params as tool_probe;
use crate::entry::{Kind, Param, When, names};

/// The probe is calibrated.
pub const CALIBRATE: When = When::Variant(&[0]);
/// A tool is measured.
pub const MEASURE: When = When::Variant(&[1]);
/// In the abscissa.
pub const ABSCISSA: When = When::Number { param: names::MA, is: &[1.0] };
/// In the ordinate.
pub const ORDINATE: When = When::Number { param: names::MA, is: &[2.0] };

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { source: "B:8766-8771;B:15455-15456", ..common::MVAR },
    Param {
        kind: Kind::ChoiceBy(&[
            (CALIBRATE, &[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate")]),
            (MEASURE, &[(1, "ma-lathe-l2"), (2, "ma-lathe-l1")]),
        ]),
        needs: common::ALWAYS_REQUIRED,
        key: "ma-lathe-length",
        labels: &[(CALIBRATE, "ma-calibrate")],
        source: "B:8859;B:9014;B:15453",
        ..common::MA
    },
    tool_probe::PRNUM,
    Param { key: "fa-tool", source: "B:2221;B:9057;B:15448", ..common::FA },
    Param { key: "tsa-tool", labels: &[(CALIBRATE, "tsa-tool-probe")], source: "B:8849;B:15472", ..common::TSA },
    Param { source: "B:2164-2170;B:15474", ..common::VMS },
    tool_probe::NMSP,
    Param { needs: &[optional(MEASURE, "need-memory-empirical")], ..tool_probe::EVNUM },
    tool_probe::TZL,
    Param { needs: &[optional(MEASURE, "need-default")], ..tool_probe::TDIF },
];
