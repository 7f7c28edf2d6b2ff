//! Parameters and conditions. Abscissa and ordinate of a turning machine are Z and X, as G18 makes them (B:8718).

use crate::catalogue::common::{ABSCISSA, APPLICATE, ORDINATE};
use crate::catalogue::prelude::*;

/// Measured in the transverse axis X, where dimensions are diameters with DIAMON (B:10623, B:10975).
const IN_X: When = When::Any(&[
    When::All(&[When::Plane(Plane::G18), ORDINATE]),
    When::All(&[When::Plane(Plane::G17), ABSCISSA]),
    When::All(&[When::Plane(Plane::G19), APPLICATE]),
]);
/// Measured in X by CYCLE974 or CYCLE994, where `_CHBIT[19]` = 1 lets Y count like X in G18 (B:14023-14027).
pub const TRANSVERSE: When = When::Any(&[
    IN_X,
    When::All(&[When::Plane(Plane::G18), APPLICATE, When::Setting { name: "_CHBIT[19]", is: &[1.0] }]),
]);

/// The setpoint is a diameter.
pub const DIAMETER: When = When::All(&[TRANSVERSE, When::Diameters]);
/// The setpoint is a diameter, in a cycle to which Y is never X.
pub const DIAMETER_IN_X: When = When::All(&[IN_X, When::Diameters]);

/// `_PRNUM`: a probe in the turret has no digit for its type (B:2277, B:15555-15556).
pub const PRNUM: Param =
    Param { kind: Kind::Digits(&[common::PROBE_NUMBER]), labels: &[(When::Always, "prnum-lathe")], ..common::PRNUM };

/// `_MA` with a third axis, where the machine has it (B:10354, B:10545).
pub const MA: Param = Param {
    kind: Kind::Choice(&[(1, "ma-lathe-abscissa"), (2, "ma-lathe-ordinate"), (3, "ma-lathe-applicate")]),
    range: Range::closed(1.0, 3.0),
    needs: common::ALWAYS_REQUIRED,
    ..common::MA
};
