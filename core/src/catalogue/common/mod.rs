//! What entries start from, and parameters that the SINUMERIK cycles share. A cycle takes one and fills in when it
//! needs it: `Param { needs: &[…], ..common::FA }`.

pub mod args;
mod limits;
mod place;
mod results;
mod target;
pub mod tasks;

use crate::catalogue::prelude::*;
pub use limits::{EVNUM, K, TDIF, TLL, TMV, TSA, TUL, TZL};
pub use place::{
    ABSCISSA, APPLICATE, CORA, CORA_CALIBRATED, CPA, CPO, ID, INCA, MA, MD, MINUS, ORDINATE, PLUS, RF, SETV0, SETV1,
    SETVAL, STA1, SZA, SZO, TURN,
};
pub use results::{angle, integer, length};
pub use target::{DLNUM, KNUM, KNUM_ZERO, TENV, TNAME, TNUM};

use crate::dialect::Dialect;

/// What an entry starts from: of a cycle on SINUMERIK that measures workpieces on milling machines and draws nothing.
pub const CYCLE: Cycle = Cycle {
    dialect: Dialect::Sinumerik,
    name: "",
    key: "",
    variants: &[],
    params: &[],
    purpose: Purpose::MILLING,
    aims: Aims::NONE,
    lists: &[],
    settings: &[],
    results: &[],
    alarms: &[],
    checks: |_, _, _| {},
    help: Help::new(&[]),
    picture: Drawing::new(|_| Picture { view: View::Plane, shapes: Vec::new() }),
    examples: &[],
    simulation: None,
    source: "",
};

/// What every parameter starts from: a real number without a unit that nobody needs.
pub const PARAM: Param = Param {
    name: Name::new(""),
    key: "",
    kind: Kind::Real,
    unit: Unit::None,
    default: None,
    default_inch: None,
    range: Range::ANY,
    usual: Range::ANY,
    watches: false,
    alarm: None,
    needs: &[],
    chooses: &[],
    labels: &[],
    example: "",
    columns: None,
    source: "",
};

/// A parameter by its name, the stem of its message keys and its place in the manual; the rest as in [`PARAM`].
pub const fn param(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { name, key, source, ..PARAM }
}

/// Needed under this condition, for this reason.
pub const fn required(when: When, reason: &'static str) -> Need {
    Need { when, level: crate::entry::Level::Required, reason }
}

/// Allowed under this condition, for this reason.
pub const fn optional(when: When, reason: &'static str) -> Need {
    Need { when, level: crate::entry::Level::Optional, reason }
}

/// First and second digit of `_PRNUM`.
pub const PROBE_NUMBER: DigitGroup = DigitGroup::number("prnum-number", 1, 2);

/// Digits of `_PRNUM` (B:5632, A:1966: 102 is mono probe number 2).
const PROBE_DIGITS: &[DigitGroup] = &[PROBE_TYPE, PROBE_NUMBER];

/// Required in every variant.
pub const ALWAYS_REQUIRED: &[Need] = &[required(When::Always, "need-always")];
/// Optional in every variant: its delivered value counts.
pub const ALWAYS_OPTIONAL: &[Need] = &[optional(When::Always, "need-default")];
/// A mono probe is named.
pub const MONO: When = When::Digit { param: names::PRNUM, place: 100, is: &[1] };

/// With tool offset, where the third digit of `_MVAR` decides (B:5641, B:6323, B:6764).
pub const TOOL_OFFSET: When = mvar(100, &[0]);

/// With ZO correction, where the third digit of `_MVAR` decides.
pub const ZERO_OFFSET: When = mvar(100, &[1]);

/// Values of a call that measures only (B:1894-1896).
pub const UNCORRECTED: &[(Name, &str)] = &[(names::KNUM, "0")];
/// What is corrected by a cycle that corrects a tool or a zero offset.
pub const CORRECTED: &[MayCorrect] = &[
    (TOOL_OFFSET, Corrects::Tool, &[]),
    (ZERO_OFFSET, Corrects::Zero, &[]),
    (ZERO_OFFSET, Corrects::Nothing, UNCORRECTED),
];
/// What is corrected by a cycle that corrects zero offsets alone.
pub const ZERO_CORRECTED: &[MayCorrect] =
    &[(When::Always, Corrects::Zero, &[]), (When::Always, Corrects::Nothing, UNCORRECTED)];

/// Digit of `_MVAR`: what is corrected.
pub const CORRECTION_DIGIT: DigitGroup =
    DigitGroup::one("mvar-correction", 100, &[(0, "correction-tool"), (1, "correction-zero")]);
/// Digit of `_MVAR` in a cycle that corrects zero offsets alone.
pub const ZERO_DIGIT: DigitGroup = DigitGroup::one("mvar-correction", 100, &[(1, "correction-zero")]);
/// Differential measurement, each point with the spindle at 180 and 0 degree.
pub const DIFFERENTIAL: When = mvar(1000, &[1]);
/// Digit of `_MVAR`: differential measurement.
pub const DIFFERENTIAL_DIGIT: DigitGroup =
    DigitGroup::one("mvar-differential", 1000, &[(0, "differential-without"), (1, "differential-with")]);
/// Digit of `_MVAR`: whether the ball is determined.
pub const BALL_DIGIT: DigitGroup =
    DigitGroup::one("calibrate-ball", 100, &[(0, "calibrate-ball-without"), (1, "calibrate-ball-with")]);

/// `_MVAR`; a cycle adds the digit groups.
pub const MVAR: Param = Param {
    kind: Kind::Variant(&[]),
    alarm: Some(Code::Alarm(61307)),
    needs: ALWAYS_REQUIRED,
    ..param(names::MVAR, "mvar", "B:1854")
};

/// `_PRNUM`.
pub const PRNUM: Param = Param {
    kind: Kind::Digits(PROBE_DIGITS),
    default: Some(1.0),
    range: Range::closed(1.0, 199.0),
    alarm: Some(Code::Alarm(61313)),
    needs: ALWAYS_OPTIONAL,
    example: "1",
    ..param(names::PRNUM, "prnum", "B:5632-5633")
};

/// `_FA`: always mm, also on an inch machine (B:1790).
pub const FA: Param = Param {
    unit: Unit::Millimetre,
    default: Some(2.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61308)),
    needs: ALWAYS_OPTIONAL,
    ..param(names::FA, "fa", "B:15635")
};

/// `_VMS`: 0 lets the cycle choose by `_FA`.
pub const VMS: Param = Param {
    unit: Unit::BasicFeed,
    default: Some(0.0),
    range: Range::NOT_NEGATIVE,
    usual: Range::closed(0.0, 2000.0),
    needs: ALWAYS_OPTIONAL,
    example: "0",
    ..param(names::VMS, "vms", "B:15668")
};

/// `_NMSP`.
pub const NMSP: Param = Param {
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 20.0),
    needs: ALWAYS_OPTIONAL,
    example: "1",
    ..param(names::NMSP, "nmsp", "B:15650")
};

/// Alarms that the manual names for every SINUMERIK measuring cycle (A:15840-15940).
pub const EVERY_CYCLE: &[Code] = &alarms([
    61016, 61301, 61302, 61303, 61307, 61308, 61309, 61310, 61311, 61312, 61313, 61320, 61328, 61336, 61338, 61339,
    61340, 61342, 61343, 61344, 61345, 61372, 61373, 61403, 61404, 61405, 61406, 61407, 61408, 61409, 61410, 61416,
    62303,
]);

/// Alarms of the cycles that correct tools and zero offsets by `_KNUM` (A:15859-15865).
pub const CORRECTION: &[Code] = &alarms([61318, 61319, 61321, 61322, 61323, 61324]);
/// Alarms of the tolerance chain (A:15845, A:15941-15943).
pub const TOLERANCE: &[Code] = &alarms([61306, 62304, 62305, 62306]);

/// Alarm numbers as codes.
pub const fn alarms<const N: usize>(numbers: [u32; N]) -> [Code; N] {
    let mut codes = [Code::Alarm(0); N];
    let mut index = 0;
    while index < N {
        codes[index] = Code::Alarm(numbers[index]);
        index += 1;
    }
    codes
}
