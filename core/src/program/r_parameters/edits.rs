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
    all.sort_by_key(|edit| (edit.span.start, edit.span.end));
    all
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

/// Without these words; a line that held nothing else goes with them.
pub(super) fn without(program: &Program, spare: &[Span]) -> Vec<Edit> {
    let mut lines = Lines::new();
    for span in spare {
        if let Some(word) = program.word_at(*span) {
            lines.entry(program.line_of(span.start)).or_default().push(word);
        }
    }
    emptied(program, &lines, u32::MAX)
}
