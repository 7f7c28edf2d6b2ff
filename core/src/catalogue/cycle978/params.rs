//! Parameters of CYCLE978 in the order of the manual's tables (B:6456-6468, B:6596-6612).

pub use crate::catalogue::common::{DIFFERENTIAL, TOOL_OFFSET as TOOL, ZERO_OFFSET as ZERO};
use crate::catalogue::prelude::*;

const MVAR_DIGITS: &[DigitGroup] = &[common::CORRECTION_DIGIT, common::DIFFERENTIAL_DIGIT];

/// In the order in which the snippet writes them.
pub const PARAMS: &[Param] = &[
    Param { kind: Kind::Variant(MVAR_DIGITS), example: "0", source: "B:6323-6328", ..common::MVAR },
    Param {
        needs: common::ALWAYS_REQUIRED,
        labels: &[(When::Always, "setval-position")],
        example: "100",
        source: "B:6458;B:6598;A:7342",
        ..common::SETVAL
    },
    Param {
        kind: Kind::Choice(&[(1, "ma-abscissa"), (2, "ma-ordinate"), (3, "ma-applicate")]),
        range: Range::closed(1.0, 3.0),
        needs: &[required(DIFFERENTIAL, "need-axis-differential"), required(When::Always, "need-axis-surface")],
        example: "1",
        source: "B:6459;B:15699",
        ..common::MA
    },
    Param { example: "2001", source: "B:6460-6462;B:6600-6601", ..common::KNUM },
    Param { example: "20", source: "B:6602", ..common::TNUM },
    Param { source: "B:6603-6604", ..common::TNAME },
    Param { source: "B:6605", ..common::DLNUM },
    Param { source: "B:6606", ..common::TENV },
    Param { source: "B:6301-6308", ..common::PRNUM },
    Param { example: "2", source: "B:6384;B:6388", ..common::FA },
    Param { labels: &[(When::Always, "tsa-position")], source: "B:6466;B:6486", ..common::TSA },
    Param { source: "B:6466;B:6610", ..common::VMS },
    Param { source: "B:6466;B:15705", ..common::NMSP },
    Param { source: "B:6468;B:6612", ..common::CORA_CALIBRATED },
    Param { example: "20", source: "B:6466;B:6584-6588", ..common::EVNUM },
    Param { source: "B:6610;B:15690", ..common::K },
    Param { source: "B:6610;B:6614", ..common::TZL },
    Param { source: "B:6610;B:15720", ..common::TMV },
    Param { source: "B:6610;B:15727", ..common::TUL },
    Param { source: "B:6610;B:15728", ..common::TLL },
    Param { source: "B:6610;B:15719", ..common::TDIF },
];
