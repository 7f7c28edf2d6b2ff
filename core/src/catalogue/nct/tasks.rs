//! What the other control can do too of the macros that measure.

use crate::entry::When;
use crate::entry::{Meaning, Shared, Task};

/// S, T, H, U and Q mean the same in all of them (C:475-501).
const LIMITS: [(&str, Meaning); 5] =
    [("Q", Meaning::Reach), ("S", Meaning::Zero), ("T", Meaning::Tool), ("H", Meaning::Half), ("U", Meaning::Limit)];

const fn with_limits<const N: usize, const M: usize>(
    own: [(&'static str, Meaning); N],
) -> [(&'static str, Meaning); M] {
    let mut all = [("", Meaning::Nominal); M];
    let mut i = 0;
    while i < M {
        all[i] = if i < N { own[i] } else { LIMITS[i - N] };
        i += 1;
    }
    all
}

/// A diameter.
pub const ROUND: &[(&str, Meaning)] = &with_limits::<1, 6>([("D", Meaning::Nominal)]);
/// A diameter from outside, with the depth in the address of the tool axis.
pub const OUTSIDE: &[(&str, Meaning)] = &with_limits::<4, 9>([
    ("D", Meaning::Nominal),
    ("X", Meaning::NominalInAxis),
    ("Y", Meaning::NominalInAxis),
    ("Z", Meaning::NominalInAxis),
]);
/// A corner, with the work offset that it moves.
pub const CORNER: &[(&str, Meaning)] =
    &[("X", Meaning::CornerInAxis), ("Y", Meaning::CornerInAxis), ("Z", Meaning::CornerInAxis), ("S", Meaning::Zero)];
/// A width or a coordinate, by the address of its axis.
pub const IN_AXIS: &[(&str, Meaning)] =
    &with_limits::<3, 8>([("X", Meaning::NominalInAxis), ("Y", Meaning::NominalInAxis), ("Z", Meaning::NominalInAxis)]);

/// A task of a macro.
pub const fn task(
    task: Task,
    variants: &'static [i64],
    variant: i64,
    values: &'static [(&'static str, Meaning)],
) -> Shared {
    Shared { task, when: When::Variant(variants), variant, tool: None, values }
}
