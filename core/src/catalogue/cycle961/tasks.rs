//! What of CYCLE961 the other control can do too.

use crate::catalogue::When;
use crate::catalogue::names;
use crate::catalogue::task::{Meaning, Shared, Task};

/// All of them.
pub const TASKS: &[Shared] = &[
    corner(Task::InnerCorner, 105, &[105, 107, 117]),
    corner(Task::OuterCorner, 106, &[106, 108, 118]),
];

const fn corner(task: Task, variant: i64, all: &'static [i64]) -> Shared {
    Shared {
        task,
        when: When::Variant(all),
        variant,
        tool: Some(false),
        values: &[(names::KNUM, Meaning::Zero)],
    }
}
