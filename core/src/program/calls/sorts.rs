//! Values of a call that are of the wrong sort, whichever way they come to it.

use super::listed::Given;
use crate::check::Sort;
use crate::check::listed::sort;
use crate::diagnostic::Diagnostic;
use crate::entry::{Cycle, Kind};
use crate::program::values::Value;
use crate::syntax::{Program, Word, WordKind};

/// Texts where numbers belong, and the reverse; names of variables that are none.
pub(super) fn of_wrong_sort(program: &Program, cycle: &'static Cycle, given: &Given) -> Vec<Diagnostic> {
    let wrong = |name: &str, value: &Value| {
        let param = cycle.param(name)?;
        let sort_of = match value.sort() {
            Sort::Open if matches!(param.kind, Kind::Text(_)) && is_undeclared(program, value) => Sort::Undeclared,
            known => known,
        };
        Some(sort(param, &value.text, sort_of)?.on(value.written_at()))
    };
    let all = given.iter().flat_map(|(name, held)| held.all().iter().map(move |value| (name, value)));
    all.filter_map(|(name, value)| wrong(name, value)).collect()
}

/// Whether a value is a bare name that the program neither declares nor writes, and without `_`, as the machine's have.
fn is_undeclared(program: &Program, value: &Value) -> bool {
    let text = value.text.as_bytes();
    let parameter = matches!(text, [b'R' | b'r', digits @ ..] if digits.iter().all(u8::is_ascii_digit));
    let name = text.first().is_some_and(u8::is_ascii_alphabetic)
        && text.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b'_');
    let declares = |word: &Word| match &word.kind {
        WordKind::Declare { name, .. } | WordKind::Assign { name, .. } => {
            program.text(*name).eq_ignore_ascii_case(text)
        }
        _ => false,
    };
    name && !parameter && !program.words.iter().any(declares)
}
