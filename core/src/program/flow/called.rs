//! Which programs a block calls: `L5 P3`, `NAME(1)`, `PCALL NAME(1)`, `MCALL NAME`, `CALL "NAME"`, `EXTCALL("NAME")`.

use crate::diagnostic::Span;
use crate::program::of_control::is_of_control;
use crate::syntax::language::{BY_TEXT, FROM_OUTSIDE, MANNERS, is_word};
use crate::syntax::programs::{Programs, bare};
use crate::syntax::{Expr, ExprId, Program, Word, WordKind};

/// What a word calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Called {
    /// A program of this text, by its place in [`Programs::units`].
    Here(usize),
    /// A program that is not in this text.
    Elsewhere,
}

/// The program that the word at this place of a block calls; none: it calls nothing, or a cycle.
pub fn called(program: &Program, programs: &Programs, words: &[Word], at: usize) -> Option<Called> {
    if !matches!(words.get(at)?.kind, WordKind::Call { .. } | WordKind::Constant(_)) {
        return None;
    }
    // a block that declares something calls nothing
    let declares = |word: &Word| program.is_keyword(word, &["PROC", "EXTERN"]) || program.is_call(word, &["DEFINE"]);
    if words.first().is_some_and(declares) {
        return None;
    }
    let two = words.get(at.saturating_sub(2)..at).unwrap_or_default();
    if two.iter().any(|word| program.is_keyword(word, &["REPEAT", "REPEATB"])) {
        return None; // the label where a part begins, and the one where it ends
    }
    let before = before(words, at);
    let (name, certain) = match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => match from_outside(program, *name, args) {
            Some(place) => (program.name(place), true),
            None => (program.name(*name), false),
        },
        WordKind::Constant(id) if before.is_some_and(|word| program.is_call(word, &MANNERS)) => {
            match program.expr(*id)? {
                Expr::Text(place) => (program.name(*place), true),
                _ => return Some(Called::Elsewhere),
            }
        }
        _ => return None,
    };
    if let Some(unit) = programs.place(&name) {
        return Some(Called::Here(unit));
    }
    let known = !certain && (MANNERS.contains(&name.as_str()) || is_word(&name));
    (!known && !is_of_control(bare(&name))).then_some(Called::Elsewhere)
}

/// The word before this one in its block.
pub fn before(words: &[Word], at: usize) -> Option<&Word> {
    words.get(at.checked_sub(1)?)
}

/// The text in `EXTCALL("NAME")`.
fn from_outside(program: &Program, name: Span, args: &[ExprId]) -> Option<Span> {
    let text = args.first().filter(|_| program.is(name, FROM_OUTSIDE))?;
    let Expr::Text(place) = program.expr(*text)? else { return None };
    Some(*place)
}

/// The name of a program that is called here and is not in the text; a variable that holds it is none.
pub fn named_outside(program: &Program, programs: &Programs, words: &[Word], at: usize) -> Option<Span> {
    if called(program, programs, words, at) != Some(Called::Elsewhere) {
        return None;
    }
    match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => {
            // behind such a word a variable holds the text that says what is called
            let variable = before(words, at).is_some_and(|word| program.is_call(word, &BY_TEXT));
            (!variable).then_some(from_outside(program, *name, args).unwrap_or(*name))
        }
        WordKind::Constant(id) => match program.expr(*id)? {
            Expr::Text(place) => Some(*place),
            _ => None,
        },
        _ => None,
    }
}

/// The programs of the text that a block calls, each behind the place of the word in the block.
pub fn called_here(program: &Program, programs: &Programs, words: &[Word]) -> impl Iterator<Item = (usize, usize)> {
    (0..words.len()).filter_map(|at| match called(program, programs, words, at) {
        Some(Called::Here(unit)) => Some((at, unit)),
        _ => None,
    })
}

/// Which program of a text calls which, by their places in [`Programs::units`].
pub fn callers(program: &Program, programs: &Programs) -> Vec<Vec<usize>> {
    let calls = |unit| {
        let words = program.blocks_of(unit).iter().map(|block| program.words_of(block));
        words.flat_map(|words| called_here(program, programs, words)).map(|(_, unit)| unit).collect()
    };
    programs.units.iter().map(calls).collect()
}
