//! What of CYCLE978 the other control can do too.

use crate::catalogue::common::tasks::{AXIS, LOWER, MOST, REACH, SAFE, SET, TOOL, UPPER, ZERO, tool, zero};
use crate::entry::{Meaning, Shared, Task, When, names};
use crate::name::Name;

/// All of them, first those that correct a zero offset.
pub const TASKS: &[Shared] = &[
    zero(Task::Wall, 100, When::All(&[When::Variant(&[100, 1100]), IN_PLANE]), BY_ZERO),
    zero(Task::Face, 100, When::All(&[When::Variant(&[100, 1100]), ALONG_TOOL]), BY_ZERO),
    tool(Task::Wall, 0, When::All(&[When::Variant(&[0, 1000]), IN_PLANE]), BY_TOOL),
    tool(Task::Face, 0, When::All(&[When::Variant(&[0, 1000]), ALONG_TOOL]), BY_TOOL),
];

const IN_PLANE: When = When::Number { param: names::MA, is: &[1.0, 2.0] };
const ALONG_TOOL: When = When::Number { param: names::MA, is: &[3.0] };
const BY_ZERO: &[(Name, Meaning)] = &[SET, AXIS, REACH, SAFE, ZERO];
const BY_TOOL: &[(Name, Meaning)] = &[SET, AXIS, REACH, UPPER, LOWER, MOST, TOOL];
