//! What parameters mean to the other control, and which variants have a task that it has too.

use crate::catalogue::prelude::*;

/// Set size or position.
pub const SET: (Name, Meaning) = (names::SETVAL, Meaning::Nominal);
/// Set length of a rectangle along the abscissa.
pub const FIRST: (Name, Meaning) = (names::SETV0, Meaning::FirstSide);
/// Set length of a rectangle along the ordinate.
pub const SECOND: (Name, Meaning) = (names::SETV1, Meaning::SecondSide);
/// Measuring axis.
pub const AXIS: (Name, Meaning) = (names::MA, Meaning::Axis);
/// Infeed.
pub const DOWN: (Name, Meaning) = (names::ID, Meaning::Infeed);
/// Measuring path.
pub const REACH: (Name, Meaning) = (names::FA, Meaning::Reach);
/// Safe area.
pub const SAFE: (Name, Meaning) = (names::TSA, Meaning::Limit);
/// Zero offset that is corrected.
pub const ZERO: (Name, Meaning) = (names::KNUM, Meaning::Zero);
/// Upper tolerance.
pub const UPPER: (Name, Meaning) = (names::TUL, Meaning::Upper);
/// Lower tolerance.
pub const LOWER: (Name, Meaning) = (names::TLL, Meaning::Lower);
/// Permissible difference.
pub const MOST: (Name, Meaning) = (names::TDIF, Meaning::Limit);
/// Tool that is corrected.
pub const TOOL: (Name, Meaning) = (names::TNUM, Meaning::Tool);

/// A task of variants that correct a zero offset; `variant`: the one that is written for it.
pub const fn zero(task: Task, variant: i64, when: When, values: &'static [(Name, Meaning)]) -> Shared {
    Shared { task, when, variant, tool: Some(false), values }
}

/// A task of variants that correct a tool.
pub const fn tool(task: Task, variant: i64, when: When, values: &'static [(Name, Meaning)]) -> Shared {
    Shared { tool: Some(true), ..zero(task, variant, when, values) }
}
