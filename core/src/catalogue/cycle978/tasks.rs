//! What of CYCLE978 the other control can do too.

use crate::entry::{Meaning, Shared, Task, When, names};
use crate::name::Name;

/// All of them, first those that correct a zero offset.
pub const TASKS: &[Shared] = &[
    Shared {
        task: Task::Wall,
        when: When::All(&[When::Variant(&[100, 1100]), IN_PLANE]),
        variant: 100,
        tool: Some(false),
        values: ZERO,
    },
    Shared {
        task: Task::Face,
        when: When::All(&[When::Variant(&[100, 1100]), ALONG_TOOL]),
        variant: 100,
        tool: Some(false),
        values: ZERO,
    },
    Shared {
        task: Task::Wall,
        when: When::All(&[When::Variant(&[0, 1000]), IN_PLANE]),
        variant: 0,
        tool: Some(true),
        values: TOOL,
    },
    Shared {
        task: Task::Face,
        when: When::All(&[When::Variant(&[0, 1000]), ALONG_TOOL]),
        variant: 0,
        tool: Some(true),
        values: TOOL,
    },
];

const IN_PLANE: When = When::Number { param: names::MA, is: &[1.0, 2.0] };
const ALONG_TOOL: When = When::Number { param: names::MA, is: &[3.0] };
const ZERO: &[(Name, Meaning)] = &[
    (names::SETVAL, Meaning::Nominal),
    (names::MA, Meaning::Axis),
    (names::FA, Meaning::Reach),
    (names::TSA, Meaning::Limit),
    (names::KNUM, Meaning::Zero),
];
const TOOL: &[(Name, Meaning)] = &[
    (names::SETVAL, Meaning::Nominal),
    (names::MA, Meaning::Axis),
    (names::FA, Meaning::Reach),
    (names::TUL, Meaning::Upper),
    (names::TLL, Meaning::Lower),
    (names::TDIF, Meaning::Limit),
    (names::TNUM, Meaning::Tool),
];
