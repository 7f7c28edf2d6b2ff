//! What of CYCLE976 the other control can do too.

use crate::entry::{Meaning, Shared, Task, When, names};

/// All of them.
pub const TASKS: &[Shared] = &[
    Shared {
        task: Task::Ball,
        when: When::Variant(&[8, 108, 10_008, 10_108, 1, 101, 10_001, 10_101]),
        variant: 8,
        tool: None,
        values: &[(names::SETVAL, Meaning::Nominal)],
    },
    Shared {
        task: Task::Length,
        when: When::Variant(&[10_000]),
        variant: 10_000,
        tool: None,
        values: &[(names::SETVAL, Meaning::Nominal), (names::MA, Meaning::Axis)],
    },
];
