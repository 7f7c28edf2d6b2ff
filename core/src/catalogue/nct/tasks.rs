//! What the other control can do too of the macros that measure.

use crate::catalogue::prelude::*;

/// S, T, H, U and Q mean the same in all of them (C:475-501).
const LIMITS: [(Name, Meaning); 5] = [
    (address::Q, Meaning::Reach),
    (address::S, Meaning::Zero),
    (address::T, Meaning::Tool),
    (address::H, Meaning::Half),
    (address::U, Meaning::Limit),
];

const fn with_limits<const N: usize, const M: usize>(own: [(Name, Meaning); N]) -> [(Name, Meaning); M] {
    let mut all = [(own[0].0, Meaning::Nominal); M];
    let mut i = 0;
    while i < M {
        all[i] = if i < N { own[i] } else { LIMITS[i - N] };
        i += 1;
    }
    all
}

/// A diameter.
pub const ROUND: &[(Name, Meaning)] = &with_limits::<1, 6>([(address::D, Meaning::Nominal)]);
/// A diameter from outside, with the depth in the address of the tool axis.
pub const OUTSIDE: &[(Name, Meaning)] = &with_limits::<4, 9>([
    (address::D, Meaning::Nominal),
    (address::X, Meaning::NominalInAxis),
    (address::Y, Meaning::NominalInAxis),
    (address::Z, Meaning::NominalInAxis),
]);
/// A corner, with the work offset that it moves.
pub const CORNER: &[(Name, Meaning)] = &[
    (address::X, Meaning::CornerInAxis),
    (address::Y, Meaning::CornerInAxis),
    (address::Z, Meaning::CornerInAxis),
    (address::S, Meaning::Zero),
];
/// A width or a coordinate, by the address of its axis.
pub const IN_AXIS: &[(Name, Meaning)] = &with_limits::<3, 8>([
    (address::X, Meaning::NominalInAxis),
    (address::Y, Meaning::NominalInAxis),
    (address::Z, Meaning::NominalInAxis),
]);

/// A task of a macro.
pub const fn task(task: Task, variants: &'static [i64], variant: i64, values: &'static [(Name, Meaning)]) -> Shared {
    Shared { task, when: When::Variant(variants), variant, tool: None, values }
}
