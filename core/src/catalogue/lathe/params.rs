//! Parameters and conditions. Abscissa and ordinate of a turning machine are Z and X, as G18 makes them (B:8718).

use crate::catalogue::common;
use crate::catalogue::common::{optional, required};
use crate::control::Plane;
use crate::entry::{Kind, Need, Param, When, names};
use crate::range::Range;

const fn axis(is: &'static [i64]) -> When {
    When::Digit { param: names::MA, place: 1, is }
}
/// Measured in the abscissa.
pub const ABSCISSA: When = axis(&[1]);
/// Measured in the ordinate.
pub const ORDINATE: When = axis(&[2]);
/// Measured in the applicate.
pub const APPLICATE: When = axis(&[3]);

/// Measured in the transverse axis X, where dimensions are diameters with DIAMON (B:10623, B:10975).
const IN_X: When = When::Any(&[
    When::All(&[When::Plane(Plane::G18), ORDINATE]),
    When::All(&[When::Plane(Plane::G17), ABSCISSA]),
    When::All(&[When::Plane(Plane::G19), APPLICATE]),
]);
/// The same in CYCLE974 and CYCLE994, where `_CHBIT[19]` = 1 lets Y count like X in G18 (B:14023-14027).
pub const TRANSVERSE: When = When::Any(&[
    IN_X,
    When::All(&[When::Plane(Plane::G18), APPLICATE, When::Setting { name: "_CHBIT[19]", is: &[1.0] }]),
]);

/// The setpoint is a diameter.
pub const DIAMETER: When = When::All(&[TRANSVERSE, When::Diameters]);
/// The same in a cycle to which Y is never X.
pub const DIAMETER_IN_X: When = When::All(&[IN_X, When::Diameters]);

/// With tool offset.
pub const TOOL: When = When::Digit { param: names::MVAR, place: 100, is: &[0] };
/// With ZO correction.
pub const ZERO: When = When::Digit { param: names::MVAR, place: 100, is: &[1] };
const CORRECTED: When = When::All(&[TOOL, When::Given(names::KNUM)]);
const fn kind_of_offset(is: &'static [i64]) -> When {
    When::Digit { param: names::KNUM, place: common::KNUM_KIND, is }
}
const LOCATION: When = When::All(&[TOOL, kind_of_offset(&[1, 3])]);
const ENVIRONMENT: When = When::All(&[TOOL, kind_of_offset(&[2, 3])]);

/// Belongs to the tool offset.
const TOLERANCE: &[Need] = &[optional(TOOL, "need-tolerance")];
const MEMORY: &[Need] = &[optional(TOOL, "need-memory")];

/// `_MA` with a third axis, where the machine has it (B:10354, B:10545).
pub const MA: Param = Param {
    kind: Kind::Choice(&[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate"), (3, "ma-lathe-applicate")]),
    range: Range::closed(1.0, 3.0),
    needs: common::ALWAYS_REQUIRED,
    ..common::MA
};
/// `_KNUM`.
pub const KNUM: Param = Param { labels: &[(TOOL, "knum-tool"), (ZERO, "knum-zero")], ..common::KNUM };
/// `_TNUM`.
pub const TNUM: Param = Param {
    needs: &[
        required(
            When::All(&[CORRECTED, When::Not(&When::Given(names::TNAME)), When::Not(&When::Given(names::TENV))]),
            "need-tool",
        ),
        optional(CORRECTED, "need-tool-otherwise"),
    ],
    ..common::TNUM
};
/// `_TNAME`.
pub const TNAME: Param = Param { needs: &[optional(CORRECTED, "need-tool-name")], ..common::TNAME };
/// `_DLNUM`.
pub const DLNUM: Param = Param { needs: &[required(LOCATION, "need-additive")], ..common::DLNUM };
/// `_TENV`.
pub const TENV: Param = Param { needs: &[required(ENVIRONMENT, "need-environment")], ..common::TENV };
/// `_EVNUM`.
pub const EVNUM: Param =
    Param { needs: &[optional(TOOL, "need-memory"), optional(ZERO, "need-memory-empirical")], ..common::EVNUM };
/// `_K`.
pub const K: Param = Param { needs: MEMORY, ..common::K };
/// `_TZL`.
pub const TZL: Param = Param { needs: TOLERANCE, ..common::TZL };
/// `_TMV`.
pub const TMV: Param = Param { needs: TOLERANCE, ..common::TMV };
/// `_TUL`.
pub const TUL: Param = Param { needs: TOLERANCE, ..common::TUL };
/// `_TLL`.
pub const TLL: Param = Param { needs: TOLERANCE, ..common::TLL };
/// `_TDIF`.
pub const TDIF: Param = Param { needs: TOLERANCE, ..common::TDIF };
