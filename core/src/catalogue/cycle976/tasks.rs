//! What of CYCLE976 the other control can do too.

use crate::catalogue::common::tasks::{AXIS, SET, zero};
use crate::entry::{Shared, Task, When};

/// All of them.
pub const TASKS: &[Shared] = &[
    Shared { tool: None, ..zero(Task::Ball, 8, RING, &[SET]) },
    Shared { tool: None, ..zero(Task::Length, 10_000, When::Variant(&[10_000]), &[SET, AXIS]) },
];

const RING: When = When::Variant(&[8, 108, 10_008, 10_108, 1, 101, 10_001, 10_101]);
