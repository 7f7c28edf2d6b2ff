//! Set values, axes and places that are touched.

use super::{DIFFERENTIAL, MONO};
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
pub const SETVAL: Param = Param { unit: Unit::ActiveLength, ..param(names::SETVAL, "setval", "B:1744") };

pub const SETV0: Param = Param { name: names::SETV0, key: "setv0", ..SETVAL };

pub const SETV1: Param = Param { name: names::SETV1, key: "setv1", ..SETVAL };

pub const ID: Param = Param { unit: Unit::ActiveLength, ..param(names::ID, "id", "B:15636") };

pub const SZA: Param = Param {
    unit: Unit::ActiveLength,
    range: Range::POSITIVE,
    alarm: Some(Code::Alarm(61334)),
    ..param(names::SZA, "sza", "B:15657")
};

pub const SZO: Param = Param { name: names::SZO, key: "szo", source: "B:15658", ..SZA };

/// `_MA`; a cycle adds the choices.
pub const MA: Param = Param {
    kind: Kind::Choice(&[(1, "ma-abscissa"), (2, "ma-ordinate")]),
    range: Range::closed(1.0, 2.0),
    alarm: Some(Code::Alarm(61325)),
    ..param(names::MA, "ma", "B:15646")
};

pub const MD: Param = Param {
    kind: Kind::Choice(&[(0, "md-plus"), (1, "md-minus")]),
    range: Range::closed(0.0, 1.0),
    alarm: Some(Code::Alarm(61326)),
    ..param(names::MD, "md", "B:1854;A:15867")
};

pub const STA1: Param = Param { unit: Unit::Degree, usual: TURN, ..param(names::STA1, "sta1", "B:15607") };

pub const INCA: Param = Param { unit: Unit::Degree, ..param(names::INCA, "inca", "B:15749") };

pub const CPA: Param = Param { unit: Unit::ActiveLength, ..param(names::CPA, "cpa", "B:1747") };

pub const CPO: Param = Param { unit: Unit::ActiveLength, ..param(names::CPO, "cpo", "B:1748") };

/// `_RF`: the delivered 0 is refused (B:6994, A:15909), so that it has to be given.
pub const RF: Param = Param {
    unit: Unit::BasicFeed,
    range: Range::POSITIVE,
    alarm: Some(Code::Alarm(61365)),
    ..param(names::RF, "rf", "B:6994")
};

/// `_CORA`: up to 359.5 (B:15629); 360 stands for 0 where a swivel head turns the sense (A:2300-2311).
pub const CORA: Param = Param {
    unit: Unit::Degree,
    default: Some(0.0),
    range: Range::closed(0.0, 360.0),
    needs: &[required(MONO, "need-mono")],
    ..param(names::CORA, "cora", "B:15629;A:2300-2311")
};

/// `_CORA` of a cycle that needs no calibrated probe for a differential measurement.
pub const CORA_CALIBRATED: Param =
    Param { needs: &[required(When::All(&[MONO, When::Not(&DIFFERENTIAL)]), "need-mono")], ..CORA };

/// A whole turn in either direction, degree.
pub const TURN: Range = Range::closed(-360.0, 360.0);
