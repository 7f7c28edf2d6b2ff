//! Synchronised actions (`WHEN … DO`, `ID=1 WHENEVER … DO`) and interrupts: nothing watches their conditions here. One
//! note tells that. Where a loop would wait without end for what such an action writes, its condition is taken as met.

use super::{Interpreter, evaluate, names, noted};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::tree::{Word, WordKind};
use std::rc::Rc;

/// Most actions that are kept.
const MOST: usize = 100;

/// Blocks with actions that did not act yet.
pub type Actions = Vec<usize>;

/// Keeps the action of a block.
pub fn keep(run: &mut Interpreter, at: usize, place: Span, word: &str) {
    noted::without(run, "run-synchronous", place, word);
    if run.actions.len() < MOST && !run.actions.contains(&at) {
        run.actions.push(at);
    }
}

/// Lets those act that write something, as their conditions would be met some day; false: there is none.
pub fn act(run: &mut Interpreter) -> bool {
    let mut acted = false;
    for at in std::mem::take(&mut run.actions) {
        let program = Rc::clone(&run.program);
        let words = program.words_at(at);
        let from = words.iter().position(|word| program.is_keyword(word, &["DO"])).map_or(words.len(), |at| at + 1);
        for word in words.iter().skip(from) {
            acted |= write(run, word);
        }
    }
    acted
}

/// Writes what a word of an action assigns; false: it is no assignment, or not possible.
fn write(run: &mut Interpreter, word: &Word) -> bool {
    let WordKind::Assign { name, index, value } = &word.kind else { return false };
    let Ok(key) = names::key(run, *name, index) else { return false };
    let written = evaluate(run, *value).and_then(|value| {
        names::write(run, &key, &value, word.span)?;
        Ok(value)
    });
    if let Ok(value) = &written {
        let told = Problem::new("run-waits", word.span, key);
        run.tell(Severity::Note, &told.number("value", value.number().unwrap_or_default()));
    }
    written.is_ok()
}
