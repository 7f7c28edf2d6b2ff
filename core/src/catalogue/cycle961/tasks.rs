//! What of CYCLE961 the other control can do too.

use crate::entry::{Meaning, Shared, Task, When, names};
use crate::name::Name;

/// All of them, first those whose corner is one of a rectangle: there the zero may lie beside it.
pub const TASKS: &[Shared] = &[
    corner(Task::InnerCorner, 105, &[105], BESIDE),
    corner(Task::OuterCorner, 106, &[106], BESIDE),
    corner(Task::InnerCorner, 107, &[107, 117], ITSELF),
    corner(Task::OuterCorner, 108, &[108, 118], ITSELF),
];

const ZERO: (Name, Meaning) = (names::KNUM, Meaning::Zero);
const ITSELF: &[(Name, Meaning)] = &[ZERO];
const BESIDE: &[(Name, Meaning)] = &[
    (names::STA1, Meaning::EdgeAngle),
    (names::SETV4, Meaning::ZeroAtCorner),
    (names::SETV2, Meaning::ZeroAbscissa),
    (names::SETV3, Meaning::ZeroOrdinate),
    ZERO,
];

const fn corner(task: Task, variant: i64, all: &'static [i64], values: &'static [(Name, Meaning)]) -> Shared {
    Shared { task, when: When::Variant(all), variant, tool: Some(false), values }
}
