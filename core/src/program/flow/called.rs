//! Which programs a block calls: `L5`, `L5 P3`, `NAME(1)`, `PCALL NAME(1)`, `MCALL NAME`, `CALL "NAME"`,
//! `EXTCALL("NAME")`.

use super::language::is_word;
use crate::diagnostic::Span;
use crate::program::tree::{Expr, ExprId, Program, Word, WordKind};
use crate::run::programs::Programs;
use crate::run::{action, statement};

/// Words before the name of a program that say how it is called.
const MANNERS: [&str; 4] = [statement::CALL, "PCALL", "MCALL", FROM_OUTSIDE];

/// What calls a program of another memory.
const FROM_OUTSIDE: &str = "EXTCALL";

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
    let before = at.checked_sub(1).and_then(|before| words.get(before));
    let (name, certain) = match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => match from_outside(program, *name, args) {
            Some(place) => (program.name(place), true),
            None => (program.name(*name), false),
        },
        WordKind::Constant(id) if before.is_some_and(|word| is_manner(program, word)) => {
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
    let manner = MANNERS.contains(&name.as_str());
    let known = manner || action::is_of_control(&name) || is_word(&name);
    let unknown = certain || !known;
    unknown.then_some(Called::Elsewhere)
}

/// The text in `EXTCALL("NAME")`.
fn from_outside(program: &Program, name: Span, args: &[Option<ExprId>]) -> Option<Span> {
    let text = args.first().filter(|_| program.is(name, FROM_OUTSIDE))?;
    match program.expr((*text)?)? {
        Expr::Text(place) => Some(*place),
        _ => None,
    }
}

/// The name behind an `EXTCALL` of this block, in either way to write it.
pub fn named_outside(program: &Program, words: &[Word], at: usize) -> Option<Span> {
    match &words.get(at)?.kind {
        WordKind::Call { name, args, .. } => from_outside(program, *name, args),
        WordKind::Constant(id) => {
            let before = words.get(at.checked_sub(1)?)?;
            let outside = matches!(&before.kind, WordKind::Call { name, .. } if program.is(*name, FROM_OUTSIDE));
            match program.expr(*id)? {
                Expr::Text(place) if outside => Some(*place),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Which program of a text calls which, by their places in [`Programs::units`].
pub fn callers(program: &Program, programs: &Programs) -> Vec<Vec<usize>> {
    let units = programs.units.iter();
    let calls = units.map(|unit| {
        let blocks = program.blocks.get(unit.blocks.clone()).unwrap_or_default();
        let words = blocks.iter().map(|block| program.words_of(block));
        let called = words.flat_map(|words| {
            (0..words.len()).filter_map(|at| called(program, programs, words, at))
        });
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
