//! What of CYCLE961 the other control can do too.

use crate::catalogue::common::tasks::{ZERO, zero};
use crate::entry::{Meaning, Shared, Task, When, names};
use crate::name::Name;

/// All of them, first those whose corner is one of a rectangle: there the zero may lie beside it.
pub const TASKS: &[Shared] = &[
    zero(Task::InnerCorner, 105, When::Variant(&[105]), BESIDE),
    zero(Task::OuterCorner, 106, When::Variant(&[106]), BESIDE),
    zero(Task::InnerCorner, 107, When::Variant(&[107, 117]), &[ZERO]),
    zero(Task::OuterCorner, 108, When::Variant(&[108, 118]), &[ZERO]),
];

const BESIDE: &[(Name, Meaning)] = &[
    (names::STA1, Meaning::EdgeAngle),
    (names::SETV4, Meaning::ZeroAtCorner),
    (names::SETV2, Meaning::ZeroAbscissa),
    (names::SETV3, Meaning::ZeroOrdinate),
    ZERO,
];
