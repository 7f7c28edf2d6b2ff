//! Set values, axes and places that are touched.

use super::{DIFFERENTIAL, MONO, PARAM, required};
use crate::catalogue::prelude::*;

const fn axis(is: &'static [i64]) -> When {
    When::Digit { param: names::MA, place: 1, is }
}
/// Measured in the abscissa.
pub const ABSCISSA: When = axis(&[1]);
/// Measured in the ordinate.
pub const ORDINATE: When = axis(&[2]);
/// Measured in the applicate.
pub const APPLICATE: When = axis(&[3]);
/// Touched in plus direction.
pub const PLUS: When = When::Digit { param: names::MD, place: 1, is: &[0] };
/// Touched in minus direction.
pub const MINUS: When = When::Digit { param: names::MD, place: 1, is: &[1] };

/// `_SETVAL`; a cycle adds range and label.
pub const SETVAL: Param =
    Param { name: names::SETVAL, key: "setval", unit: Unit::ActiveLength, source: "B:1744", ..PARAM };

pub const SETV0: Param = Param { name: names::SETV0, key: "setv0", ..SETVAL };

pub const SETV1: Param = Param { name: names::SETV1, key: "setv1", ..SETVAL };

pub const ID: Param = Param { name: names::ID, key: "id", unit: Unit::ActiveLength, source: "B:15636", ..PARAM };

pub const SZA: Param = Param {
    name: names::SZA,
    key: "sza",
    unit: Unit::ActiveLength,
    range: Range::POSITIVE,
    alarm: Some(Code::Alarm(61334)),
    source: "B:15657",
    ..PARAM
};

pub const SZO: Param = Param { name: names::SZO, key: "szo", source: "B:15658", ..SZA };

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

pub const MD: Param = Param {
    name: names::MD,
    key: "md",
    kind: Kind::Choice(&[(0, "md-plus"), (1, "md-minus")]),
    range: Range::closed(0.0, 1.0),
    alarm: Some(Code::Alarm(61326)),
    source: "B:1854;A:15867",
    ..PARAM
};

pub const STA1: Param =
    Param { name: names::STA1, key: "sta1", unit: Unit::Degree, usual: TURN, source: "B:15607", ..PARAM };

pub const INCA: Param = Param { name: names::INCA, key: "inca", unit: Unit::Degree, source: "B:15749", ..PARAM };

pub const CPA: Param = Param { name: names::CPA, key: "cpa", unit: Unit::ActiveLength, source: "B:1747", ..PARAM };

pub const CPO: Param = Param { name: names::CPO, key: "cpo", unit: Unit::ActiveLength, source: "B:1748", ..PARAM };

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

/// `_CORA` of a cycle that needs no calibrated probe for a differential measurement.
pub const CORA_CALIBRATED: Param =
    Param { needs: &[required(When::All(&[MONO, When::Not(&DIFFERENTIAL)]), "need-mono")], ..CORA };

/// A whole turn in either direction, degree.
pub const TURN: Range = Range::closed(-360.0, 360.0);
