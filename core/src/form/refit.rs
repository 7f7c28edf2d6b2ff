//! What of the values of a call does not fit another variant of it.

use super::{Entry, Field, fields};
use crate::check::{Parsed, parse};
use crate::control::Control;
use crate::entry::{Cycle, Typed};
use crate::name::Name;
use serde::Serialize;

/// A value that does not fit the variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Unfit {
    /// Parameter: `_KNUM`.
    pub name: Name,
    /// As it was typed.
    pub value: String,
    /// Key of the name of what it was a code of before; absent: the new variant does not take the number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub before: Option<String>,
}

/// The values of another variant of a call that do not fit it: codes of something else (D1 of a tool, and the first
/// settable zero offset), and numbers that only the variant before takes. 0 is no code of anything.
pub fn unfit(cycle: &'static Cycle, before: &Typed, after: &Typed, control: &Control) -> Vec<Unfit> {
    let known = fields(cycle, before, control);
    let now = fields(cycle, after, control);
    let with_before = now.iter().filter_map(|field| Some((known.iter().find(|old| old.name == field.name)?, field)));
    with_before.filter(|(old, field)| old.value == field.value).filter_map(|(old, now)| misfit(old, now)).collect()
}

fn misfit(old: &Field, now: &Field) -> Option<Unfit> {
    let Parsed::Number(number) = parse(&now.value) else { return None };
    if number == 0.0 {
        return None;
    }
    let unfit = |before| Some(Unfit { name: now.name, value: now.value.clone(), before });
    if old.code.zip(now.code).is_some_and(|(old, now)| old != now) {
        return unfit(Some(old.label.key.to_string()));
    }
    if takes(&old.entry, number) && !takes(&now.entry, number) { unfit(None) } else { None }
}

/// Whether a field takes a number by itself, whatever the others hold.
fn takes(entry: &Entry, number: f64) -> bool {
    match entry {
        Entry::Choice { choices } => choices.iter().any(|one| one.value as f64 == number),
        Entry::Real { range } | Entry::Integer { range } => range.contains(number),
        Entry::Digits { .. } | Entry::Text { .. } => true,
    }
}
