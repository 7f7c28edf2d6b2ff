//! Parameters that the SINUMERIK cycles share. A cycle takes one and fills in when it needs it:
//! `Param { needs: &[…], ..common::FA }`.

use super::names;
use super::{DigitGroup, Kind, Need, Param, Range, ResultField, Unit, When};
use crate::diagnostic::Code;

/// What every parameter starts from: a real number without a unit that nobody needs.
pub const PARAM: Param = Param {
    name: "",
    key: "",
    kind: Kind::Real,
    unit: Unit::None,
    default: None,
    default_inch: None,
    range: Range::ANY,
    usual: Range::ANY,
    alarm: None,
    needs: &[],
    chooses: &[],
    labels: &[],
    source: "",
};

/// Needed under this condition, for this reason.
pub const fn required(when: When, reason: &'static str) -> Need {
    Need {
        when,
        level: super::Level::Required,
        reason,
    }
}

/// Allowed under this condition, for this reason.
pub const fn optional(when: When, reason: &'static str) -> Need {
    Need {
        when,
        level: super::Level::Optional,
        reason,
    }
}

/// Third digit of `_PRNUM`.
pub const PROBE_TYPE: DigitGroup = DigitGroup {
    key: "prnum-type",
    place: 100,
    digits: 1,
    choices: &[(0, "prnum-multi"), (1, "prnum-mono")],
};
/// First and second digit of `_PRNUM`.
pub const PROBE_NUMBER: DigitGroup = DigitGroup {
    key: "prnum-number",
    place: 1,
    digits: 2,
    choices: &[],
};
/// Digits of `_PRNUM` (B:5632, A:1966: 102 is mono probe number 2).
pub const PROBE_DIGITS: &[DigitGroup] = &[PROBE_TYPE, PROBE_NUMBER];

/// Halves of `_EVNUM` (B:2325-2342).
pub const MEMORY_DIGITS: &[DigitGroup] = &[
    DigitGroup {
        key: "evnum-mean",
        place: 10_000,
        digits: 4,
        choices: &[],
    },
    DigitGroup {
        key: "evnum-empirical",
        place: 1,
        digits: 4,
        choices: &[],
    },
];

/// Required in every variant.
pub const ALWAYS_REQUIRED: &[Need] = &[required(When::Always, "need-always")];
/// Optional in every variant: its delivered value counts.
pub const ALWAYS_OPTIONAL: &[Need] = &[optional(When::Always, "need-default")];
/// The digit of `_KNUM` that tells length/radius from setup/additive offsets and `_TENV` (7th, or 9th with 5-digit D).
pub const KNUM_KIND: i64 = 1_000_000;
/// `_KNUM` has at most four digits: what it says then is the same on newer controls.
pub const SHORT_TARGET: When = When::All(&[
    knum_digit(10_000),
    knum_digit(100_000),
    knum_digit(KNUM_KIND),
]);

const fn knum_digit(place: i64) -> When {
    When::Digit {
        param: names::KNUM,
        place,
        is: &[0],
    }
}

/// A mono probe is named.
pub const MONO: When = When::Digit {
    param: names::PRNUM,
    place: 100,
    is: &[1],
};

/// With tool offset, where the third digit of `_MVAR` decides (B:5641, B:6323, B:6764).
pub const TOOL_OFFSET: When = When::Digit {
    param: names::MVAR,
    place: 100,
    is: &[0],
};
/// With ZO correction, where the third digit of `_MVAR` decides.
pub const ZERO_OFFSET: When = When::Digit {
    param: names::MVAR,
    place: 100,
    is: &[1],
};
/// A tool is corrected.
const TOOL_CORRECTED: When = When::All(&[TOOL_OFFSET, When::Given(names::KNUM)]);

/// `_MVAR`; a cycle adds the digit groups.
pub const MVAR: Param = Param {
    name: names::MVAR,
    key: "mvar",
    kind: Kind::Variant(&[]),
    alarm: Some(Code::Alarm(61307)),
    needs: ALWAYS_REQUIRED,
    source: "B:1854",
    ..PARAM
};
/// `_SETVAL`; a cycle adds range and label.
pub const SETVAL: Param = Param {
    name: names::SETVAL,
    key: "setval",
    unit: Unit::ActiveLength,
    source: "B:1744",
    ..PARAM
};
/// `_SETV[0]`.
pub const SETV0: Param = Param {
    name: names::SETV0,
    key: "setv0",
    ..SETVAL
};
/// `_SETV[1]`.
pub const SETV1: Param = Param {
    name: names::SETV1,
    key: "setv1",
    ..SETVAL
};
/// `_ID`.
pub const ID: Param = Param {
    name: names::ID,
    key: "id",
    unit: Unit::ActiveLength,
    source: "B:15636",
    ..PARAM
};
/// `_SZA`.
pub const SZA: Param = Param {
    name: names::SZA,
    key: "sza",
    unit: Unit::ActiveLength,
    range: Range::POSITIVE,
    alarm: Some(Code::Alarm(61334)),
    source: "B:15657",
    ..PARAM
};
/// `_SZO`.
pub const SZO: Param = Param {
    name: names::SZO,
    key: "szo",
    source: "B:15658",
    ..SZA
};
/// `_MA`; a cycle adds the choices.
pub const MA: Param = Param {
    name: names::MA,
    key: "ma",
    kind: Kind::Choice(&[(1, "ma-abscissa"), (2, "ma-ordinate")]),
    range: Range::closed(1.0, 2.0),
    alarm: Some(Code::Alarm(61325)),
    source: "B:15646",
    ..PARAM
};
/// `_MD`.
pub const MD: Param = Param {
    name: names::MD,
    key: "md",
    kind: Kind::Choice(&[(0, "md-plus"), (1, "md-minus")]),
    range: Range::closed(0.0, 1.0),
    alarm: Some(Code::Alarm(61326)),
    source: "B:1854;A:15867",
    ..PARAM
};
/// `_STA1`.
pub const STA1: Param = Param {
    name: names::STA1,
    key: "sta1",
    unit: Unit::Degree,
    usual: Range::closed(-360.0, 360.0),
    source: "B:15607",
    ..PARAM
};
/// `_INCA`.
pub const INCA: Param = Param {
    name: names::INCA,
    key: "inca",
    unit: Unit::Degree,
    source: "B:15749",
    ..PARAM
};
/// `_CPA`.
pub const CPA: Param = Param {
    name: names::CPA,
    key: "cpa",
    unit: Unit::ActiveLength,
    source: "B:1747",
    ..PARAM
};
/// `_CPO`.
pub const CPO: Param = Param {
    name: names::CPO,
    key: "cpo",
    unit: Unit::ActiveLength,
    source: "B:1748",
    ..PARAM
};
/// `_RF`: the delivered 0 is refused (B:6994, A:15909), so that it has to be given.
pub const RF: Param = Param {
    name: names::RF,
    key: "rf",
    unit: Unit::BasicFeed,
    range: Range::POSITIVE,
    alarm: Some(Code::Alarm(61365)),
    source: "B:6994",
    ..PARAM
};
/// `_KNUM` (B:1894-2029).
pub const KNUM: Param = Param {
    name: names::KNUM,
    key: "knum",
    kind: Kind::Knum,
    range: Range::closed(0.0, 399_999_999.0),
    needs: ALWAYS_REQUIRED,
    source: "B:1894-2029",
    ..PARAM
};
/// `_TNUM`.
pub const TNUM: Param = Param {
    name: names::TNUM,
    key: "tnum",
    kind: Kind::Integer,
    range: Range::NOT_NEGATIVE,
    alarm: Some(Code::Alarm(61320)),
    source: "B:1872-1892",
    ..PARAM
};
/// `_TNAME`.
pub const TNAME: Param = Param {
    name: names::TNAME,
    key: "tname",
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61343)),
    source: "B:15661",
    ..PARAM
};
/// `_DLNUM`.
pub const DLNUM: Param = Param {
    name: names::DLNUM,
    key: "dlnum",
    kind: Kind::Integer,
    range: Range::closed(0.0, 6.0),
    alarm: Some(Code::Alarm(61406)),
    source: "B:2031-2043",
    ..PARAM
};
/// `_TENV`.
pub const TENV: Param = Param {
    name: names::TENV,
    key: "tenv",
    kind: Kind::Text(32),
    alarm: Some(Code::Alarm(61405)),
    source: "B:2062-2102",
    ..PARAM
};
/// `_TNUM` of the cycles with [`TOOL_OFFSET`].
pub const OFFSET_TNUM: Param = Param {
    needs: &[
        required(
            When::All(&[
                TOOL_CORRECTED,
                When::Not(&When::Given(names::TNAME)),
                When::Not(&When::Given(names::TENV)),
            ]),
            "need-tool",
        ),
        optional(TOOL_CORRECTED, "need-tool-otherwise"),
    ],
    ..TNUM
};
/// `_TNAME` of the cycles with [`TOOL_OFFSET`].
pub const OFFSET_TNAME: Param = Param {
    needs: &[optional(TOOL_CORRECTED, "need-tool-name")],
    ..TNAME
};
/// `_DLNUM` of the cycles with [`TOOL_OFFSET`].
pub const OFFSET_DLNUM: Param = Param {
    needs: &[required(
        When::All(&[
            TOOL_OFFSET,
            When::Digit {
                param: names::KNUM,
                place: KNUM_KIND,
                is: &[1, 3],
            },
        ]),
        "need-additive",
    )],
    ..DLNUM
};
/// `_TENV` of the cycles with [`TOOL_OFFSET`].
pub const OFFSET_TENV: Param = Param {
    needs: &[required(
        When::All(&[
            TOOL_OFFSET,
            When::Digit {
                param: names::KNUM,
                place: KNUM_KIND,
                is: &[2, 3],
            },
        ]),
        "need-environment",
    )],
    ..TENV
};
/// `_PRNUM`.
pub const PRNUM: Param = Param {
    name: names::PRNUM,
    key: "prnum",
    kind: Kind::Digits(PROBE_DIGITS),
    default: Some(1.0),
    range: Range::closed(1.0, 199.0),
    alarm: Some(Code::Alarm(61313)),
    needs: ALWAYS_OPTIONAL,
    source: "B:5632-5633",
    ..PARAM
};
/// `_FA`: always mm, also on an inch machine (B:1790).
pub const FA: Param = Param {
    name: names::FA,
    key: "fa",
    unit: Unit::Millimetre,
    default: Some(2.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61308)),
    needs: ALWAYS_OPTIONAL,
    source: "B:15635",
    ..PARAM
};
/// `_TSA`.
pub const TSA: Param = Param {
    name: names::TSA,
    key: "tsa",
    unit: Unit::BasicLength,
    default: Some(2.0),
    range: Range::POSITIVE,
    needs: ALWAYS_OPTIONAL,
    source: "B:15666",
    ..PARAM
};
/// `_VMS`: 0 lets the cycle choose by `_FA`.
pub const VMS: Param = Param {
    name: names::VMS,
    key: "vms",
    unit: Unit::BasicFeed,
    default: Some(0.0),
    range: Range::NOT_NEGATIVE,
    usual: Range::closed(0.0, 2000.0),
    needs: ALWAYS_OPTIONAL,
    source: "B:15668",
    ..PARAM
};
/// `_NMSP`.
pub const NMSP: Param = Param {
    name: names::NMSP,
    key: "nmsp",
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 20.0),
    needs: ALWAYS_OPTIONAL,
    source: "B:15650",
    ..PARAM
};
/// `_CORA`: up to 359.5 (B:15629); 360 stands for 0 where a swivel head turns the sense (A:2300-2311).
pub const CORA: Param = Param {
    name: names::CORA,
    key: "cora",
    unit: Unit::Degree,
    default: Some(0.0),
    range: Range::closed(0.0, 360.0),
    needs: &[required(MONO, "need-mono")],
    source: "B:15629;A:2300-2311",
    ..PARAM
};
/// `_EVNUM`.
pub const EVNUM: Param = Param {
    name: names::EVNUM,
    key: "evnum",
    kind: Kind::Digits(MEMORY_DIGITS),
    default: Some(0.0),
    range: Range::closed(0.0, 99_999_999.0),
    source: "B:2303-2342",
    ..PARAM
};
/// `_K`.
pub const K: Param = Param {
    name: names::K,
    key: "k",
    kind: Kind::Integer,
    default: Some(1.0),
    range: Range::POSITIVE,
    usual: Range::closed(1.0, 100.0),
    alarm: Some(Code::Alarm(61318)),
    source: "B:2358-2366;A:15859",
    ..PARAM
};
/// `_TZL`.
pub const TZL: Param = Param {
    name: names::TZL,
    key: "tzl",
    unit: Unit::BasicLength,
    default: Some(0.001),
    range: Range::NOT_NEGATIVE,
    source: "B:15667;A:2323",
    ..PARAM
};
/// `_TMV`.
pub const TMV: Param = Param {
    name: names::TMV,
    key: "tmv",
    unit: Unit::BasicLength,
    default: Some(0.7),
    range: Range::POSITIVE,
    source: "B:15660",
    ..PARAM
};
/// `_TUL`.
pub const TUL: Param = Param {
    name: names::TUL,
    key: "tul",
    unit: Unit::ActiveLength,
    default: Some(1.0),
    source: "B:15664;A:1896",
    ..PARAM
};
/// `_TLL`.
pub const TLL: Param = Param {
    name: names::TLL,
    key: "tll",
    unit: Unit::ActiveLength,
    default: Some(-1.0),
    source: "B:15665;A:1897",
    ..PARAM
};
/// `_TDIF`.
pub const TDIF: Param = Param {
    name: names::TDIF,
    key: "tdif",
    unit: Unit::BasicLength,
    default: Some(1.2),
    range: Range::POSITIVE,
    source: "B:15659",
    ..PARAM
};

/// A length in `_OVR[]`.
pub const fn length(
    name: &'static str,
    key: &'static str,
    when: When,
    source: &'static str,
) -> ResultField {
    ResultField {
        name,
        key,
        when,
        unit: Unit::ActiveLength,
        source: crate::cited(source),
    }
}

/// An angle in `_OVR[]`.
pub const fn angle(
    name: &'static str,
    key: &'static str,
    when: When,
    source: &'static str,
) -> ResultField {
    ResultField {
        name,
        key,
        when,
        unit: Unit::Degree,
        source: crate::cited(source),
    }
}

/// A whole number in `_OVI[]`.
pub const fn integer(
    name: &'static str,
    key: &'static str,
    when: When,
    source: &'static str,
) -> ResultField {
    ResultField {
        name,
        key,
        when,
        unit: Unit::None,
        source: crate::cited(source),
    }
}

/// Alarms that the manual names for every SINUMERIK measuring cycle (A:15840-15940).
pub const EVERY_CYCLE: &[Code] = &alarms([
    61016, 61301, 61302, 61303, 61307, 61308, 61309, 61310, 61311, 61312, 61313, 61320, 61328,
    61336, 61338, 61339, 61340, 61342, 61343, 61344, 61345, 61372, 61373, 61403, 61404, 61405,
    61406, 61407, 61408, 61409, 61410, 61416, 62303,
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
