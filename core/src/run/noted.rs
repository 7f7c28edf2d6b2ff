//! What a run goes on without and what many blocks share: one note each, which lists the words.

use super::Interpreter;
use crate::diagnostic::{Severity, Span};
use crate::message::{Arg, Message, printable};
use crate::problem::Problem;

/// Words by the key of their note, each once with its first place in the text.
pub type Noted = Vec<(&'static str, Vec<(String, Span)>)>;

/// Words of a note that are kept.
const MOST: usize = 100;
/// Words that a note names.
const NAMED: usize = 20;

/// Takes a word into the note with this key; true: it is new there.
pub fn add(run: &mut Interpreter, key: &'static str, span: Span, word: &str) -> bool {
    let span = run.placed(span);
    let at = run.noted.iter().position(|(known, _)| *known == key).unwrap_or_else(|| {
        run.noted.push((key, Vec::new()));
        run.noted.len() - 1
    });
    let Some((_, words)) = run.noted.get_mut(at) else { return false };
    let new = words.len() < MOST && !words.iter().any(|(known, _)| known == word);
    if new {
        words.push((printable(word), span));
    }
    new
}

/// Takes a word that the run goes on without.
pub fn without(run: &mut Interpreter, key: &'static str, span: Span, word: &str) {
    if add(run, key, span, word) {
        run.pass_over(word.to_owned(), span);
    }
}

/// Tells all notes, each at its first word.
pub fn tell(run: &mut Interpreter) {
    for (key, words) in std::mem::take(&mut run.noted) {
        let Some((_, place)) = words.first() else { continue };
        let named = words.iter().take(NAMED).map(|(word, _)| word.as_str());
        let more = (words.len() > NAMED).then_some("…");
        let listed = named.chain(more).collect::<Vec<_>>().join(", ");
        // each of them is short already, and each is to be named
        let message = Message { args: vec![("word", Arg::Text(listed))], ..Message::new(key) };
        run.keep(Problem { span: *place, message }.diagnostic(Severity::Note));
    }
}
