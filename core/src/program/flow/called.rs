//! Which programs a block calls: `L5`, `L5 P3`, `NAME(1)`, `PCALL NAME(1)`, `MCALL NAME`, `CALL "NAME"`,
//! `EXTCALL("NAME")`.

use crate::diagnostic::Span;
use crate::program::of_control::is_of_control;
use crate::syntax::Program;
use crate::syntax::language::{BY_TEXT, FROM_OUTSIDE, MANNERS, is_word};
use crate::syntax::programs::{Programs, bare};
use crate::syntax::tree::{Expr, ExprId, Word, WordKind};

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
    if words.first().is_some_and(|word| declares(program, word)) {
        return None;
    }
    let two = words.get(at.saturating_sub(2)..at).unwrap_or_default();
    if two.iter().any(|word| repeats(program, word)) {
        return None; // the label where a part begins, and the one where it ends
    }
    let before = at.checked_sub(1).and_then(|before| words.get(before));
    let (name, certain) = match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => match from_outside(program, *name, args) {
            Some(place) => (program.name(place), true),
            None => (program.name(*name), false),
        },
        WordKind::Constant(id) if before.is_some_and(|word| is_manner(program, word)) => match program.expr(*id)? {
            Expr::Text(place) => (program.name(*place), true),
            _ => return Some(Called::Elsewhere),
        },
        _ => return None,
    };
    if let Some(unit) = programs.place(&name) {
        return Some(Called::Here(unit));
    }
    let manner = MANNERS.contains(&name.as_str());
    let known = !certain && (manner || is_word(&name));
    let of_control = is_of_control(bare(&name));
    (!known && !of_control).then_some(Called::Elsewhere)
}

/// The text in `EXTCALL("NAME")`.
fn from_outside(program: &Program, name: Span, args: &[Option<ExprId>]) -> Option<Span> {
    let text = args.first().filter(|_| program.is(name, FROM_OUTSIDE))?;
    match program.expr((*text)?)? {
        Expr::Text(place) => Some(*place),
        _ => None,
    }
}

/// Whether the names behind this word are labels.
fn repeats(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Keyword { name, .. } => program.is(*name, "REPEAT") || program.is(*name, "REPEATB"),
        _ => false,
    }
}

/// Whether a block that begins with this word declares something, so that no other word of it is called.
fn declares(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Keyword { name, .. } => program.is(*name, "PROC") || program.is(*name, "EXTERN"),
        WordKind::Call { name, .. } => program.is(*name, "DEFINE"),
        _ => false,
    }
}

/// The name of a program that is called here and is not in the text; a variable that holds it is none.
pub fn named_outside(program: &Program, programs: &Programs, words: &[Word], at: usize) -> Option<Span> {
    if called(program, programs, words, at) != Some(Called::Elsewhere) {
        return None;
    }
    match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => {
            let before = at.checked_sub(1).and_then(|before| words.get(before));
            let variable =
                before.is_some_and(|word| takes_text(program, word)) || programs.macros.contains(&program.name(*name));
            let name = from_outside(program, *name, args).unwrap_or(*name);
            (!variable).then_some(name)
        }
        WordKind::Constant(id) => match program.expr(*id)? {
            Expr::Text(place) => Some(*place),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a text, or a variable that holds one, says behind this word what is called.
fn takes_text(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Call { name, .. } => BY_TEXT.iter().any(|one| program.is(*name, one)),
        _ => false,
    }
}

/// Which program of a text calls which, by their places in [`Programs::units`].
pub fn callers(program: &Program, programs: &Programs) -> Vec<Vec<usize>> {
    let units = programs.units.iter();
    let calls = units.map(|unit| {
        let blocks = program.blocks.get(unit.blocks.clone()).unwrap_or_default();
        let words = blocks.iter().map(|block| program.words_of(block));
        let called = words.flat_map(|words| (0..words.len()).filter_map(|at| called(program, programs, words, at)));
        let here = called.filter_map(|called| match called {
            Called::Here(unit) => Some(unit),
            Called::Elsewhere => None,
        });
        here.collect()
    });
    calls.collect()
}

fn is_manner(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Call { name, .. } => MANNERS.iter().any(|manner| program.is(*name, manner)),
        _ => false,
    }
}
