//! The edits that write measuring calls of an 840C as those of today.

use super::{Assigned, Older};
use crate::diagnostic::{Edit, Span};
use crate::name::Name;
use crate::program::own_words::{Lines, emptied};
use crate::syntax::Program;

/// The edits of the whole program; none as long as something is open, or nothing is there.
pub fn edits(program: &Program, older: &Older) -> Vec<Edit> {
    if !older.is_clear() {
        return Vec::new();
    }
    let mut all: Vec<Edit> = older.calls.iter().map(|call| Edit::replace(call.name, call.cycle.name)).collect();
    let mut spare = Vec::new();
    for one in &older.assigned {
        match (one.names.is_empty(), one.read) {
            (true, false) => spare.push(one.word),
            (true, true) => {}
            _ => all.extend(named(program, one, one.names.iter().copied())),
        }
    }
    all.extend(without(program, &spare));
    separated(program, all)
}

/// The edits in their order, with a blank where a name would stick to what is beside it: R parameters are written
/// without (`N10R23=100R30=1`), names are not.
pub(super) fn separated(program: &Program, mut edits: Vec<Edit>) -> Vec<Edit> {
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    let byte = |at: Option<u32>| at.and_then(|at| program.source.get(at as usize)).copied();
    let starts: Vec<u32> = edits.iter().skip(1).map(|edit| edit.span.start).chain([u32::MAX]).collect();
    let (mut end, mut last) = (u32::MAX, None);
    for (edit, next) in edits.iter_mut().zip(starts) {
        let before = if edit.span.start == end { last } else { byte(edit.span.start.checked_sub(1)) };
        let behind = byte(Some(edit.span.end)).filter(|_| next != edit.span.end);
        let [begins, ends] = [edit.insert.bytes().next(), edit.insert.bytes().next_back()];
        if sticks(before) && sticks(begins.or(behind)) {
            edit.insert.insert(0, ' ');
        }
        if sticks(ends) && sticks(behind) {
            edit.insert.push(' ');
        }
        (end, last) = (edit.span.end, edit.insert.bytes().next_back().or(before));
    }
    edits
}

/// Whether a byte belongs to a name or number beside it.
fn sticks(byte: Option<u8>) -> bool {
    byte.is_some_and(|byte| byte.is_ascii_alphanumeric() || b"_$.".contains(&byte))
}

/// An assignment under these names. What is read elsewhere stays, and each name takes its value.
pub(super) fn named(program: &Program, one: &Assigned, names: impl Iterator<Item = Name>) -> Vec<Edit> {
    let mut names = names.peekable();
    let mut edits = Vec::new();
    let right = if one.read { format!("R{}", one.number) } else { program.written(program.place(one.value)) };
    if !one.read {
        edits.extend(names.next().map(|name| Edit::replace(one.target, name.as_str())));
    }
    let more: String = names.map(|name| format!(" {name}={right}")).collect();
    if !more.is_empty() {
        edits.push(Edit::insert(one.word.end, more));
    }
    edits
}

/// Without these words; a line that held nothing else goes with them, but for its block number: what jumps there or
/// repeats from there still finds it.
pub(super) fn without(program: &Program, spare: &[Span]) -> Vec<Edit> {
    let mut lines = Lines::new();
    for span in spare {
        if let Some(word) = program.word_at(*span) {
            lines.entry(program.line_of(span.start)).or_default().push(word);
        }
    }
    emptied(program, &lines, |_, block| block.number.is_some())
}
