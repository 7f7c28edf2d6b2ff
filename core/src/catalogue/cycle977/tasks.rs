//! What of CYCLE977 the other control can do too.

use crate::catalogue::common::tasks::{AXIS, DOWN, LOWER, MOST, REACH, SAFE, SET, TOOL, UPPER, ZERO, tool, zero};
use crate::entry::{Shared, Task, When};

/// All of them, first those that correct a zero offset.
pub const TASKS: &[Shared] = &[
    zero(Task::Bore, 101, When::Variant(&[101, 1101]), &[SET, REACH, SAFE, ZERO]),
    zero(Task::Boss, 102, When::Variant(&[102, 1102]), &[SET, DOWN, REACH, SAFE, ZERO]),
    zero(Task::Pocket, 103, When::Variant(&[103, 1103]), &[SET, AXIS, REACH, SAFE, ZERO]),
    zero(Task::Web, 104, When::Variant(&[104, 1104]), &[SET, AXIS, DOWN, REACH, SAFE, ZERO]),
    tool(Task::Bore, 1, When::Variant(&[1, 1001]), &[SET, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Boss, 2, When::Variant(&[2, 1002]), &[SET, DOWN, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Pocket, 3, When::Variant(&[3, 1003]), &[SET, AXIS, REACH, UPPER, LOWER, MOST, TOOL]),
    tool(Task::Web, 4, When::Variant(&[4, 1004]), &[SET, AXIS, DOWN, REACH, UPPER, LOWER, MOST, TOOL]),
];
