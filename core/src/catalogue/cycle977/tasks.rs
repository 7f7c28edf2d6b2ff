//! What of CYCLE977 the other control can do too.

use crate::entry::{Meaning, Shared, Task, When, names};
use crate::name::Name;

/// All of them, first those that correct a zero offset.
pub const TASKS: &[Shared] = &[
    zero(Task::Bore, 101, &[101, 1101], ROUND_ZERO),
    zero(Task::Boss, 102, &[102, 1102], BOSS_ZERO),
    zero(Task::Pocket, 103, &[103, 1103], STRAIGHT_ZERO),
    zero(Task::Web, 104, &[104, 1104], WEB_ZERO),
    tool(Task::Bore, 1, &[1, 1001], ROUND_TOOL),
    tool(Task::Boss, 2, &[2, 1002], BOSS_TOOL),
    tool(Task::Pocket, 3, &[3, 1003], STRAIGHT_TOOL),
    tool(Task::Web, 4, &[4, 1004], WEB_TOOL),
];

const AXIS: (Name, Meaning) = (names::MA, Meaning::Axis);
const SET: (Name, Meaning) = (names::SETVAL, Meaning::Nominal);
const DOWN: (Name, Meaning) = (names::ID, Meaning::Infeed);
const REACH: (Name, Meaning) = (names::FA, Meaning::Reach);
const SAFE: (Name, Meaning) = (names::TSA, Meaning::Limit);
const ZERO: (Name, Meaning) = (names::KNUM, Meaning::Zero);
const UPPER: (Name, Meaning) = (names::TUL, Meaning::Upper);
const LOWER: (Name, Meaning) = (names::TLL, Meaning::Lower);
const MOST: (Name, Meaning) = (names::TDIF, Meaning::Limit);
const TOOL: (Name, Meaning) = (names::TNUM, Meaning::Tool);

const ROUND_ZERO: &[(Name, Meaning)] = &[SET, REACH, SAFE, ZERO];
const STRAIGHT_ZERO: &[(Name, Meaning)] = &[SET, AXIS, REACH, SAFE, ZERO];
const ROUND_TOOL: &[(Name, Meaning)] = &[SET, REACH, UPPER, LOWER, MOST, TOOL];
const STRAIGHT_TOOL: &[(Name, Meaning)] = &[SET, AXIS, REACH, UPPER, LOWER, MOST, TOOL];

const BOSS_ZERO: &[(Name, Meaning)] = &[SET, DOWN, REACH, SAFE, ZERO];
const WEB_ZERO: &[(Name, Meaning)] = &[SET, AXIS, DOWN, REACH, SAFE, ZERO];
const BOSS_TOOL: &[(Name, Meaning)] = &[SET, DOWN, REACH, UPPER, LOWER, MOST, TOOL];
const WEB_TOOL: &[(Name, Meaning)] = &[SET, AXIS, DOWN, REACH, UPPER, LOWER, MOST, TOOL];

const fn zero(task: Task, variant: i64, all: &'static [i64], values: &'static [(Name, Meaning)]) -> Shared {
    Shared { task, when: When::Variant(all), variant, tool: Some(false), values }
}

const fn tool(task: Task, variant: i64, all: &'static [i64], values: &'static [(Name, Meaning)]) -> Shared {
    Shared { tool: Some(true), ..zero(task, variant, all, values) }
}
