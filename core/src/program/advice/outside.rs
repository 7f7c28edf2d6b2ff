//! Programs that this text calls and does not hold: what they leave is not known. Told once, by the sentence with which
//! a run goes on without them.

use crate::catalogue::nct;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::dialect::Dialect;
use crate::problem::Problem;
use crate::program::flow::named_outside;
use crate::syntax::Program;
use crate::syntax::programs::{Programs, bare, numbered};
use crate::syntax::tree::{Block, Expr, WordKind};

/// Most names that are told.
const NAMES: usize = 8;

/// The programs that are not here, at the first call of one.
pub fn look(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) {
    let (mut first, mut names) = (None, Vec::new());
    for block in &program.blocks {
        for (span, name) in missing(program, programs, block) {
            first = first.or(Some(span));
            if !names.contains(&name) && names.len() <= NAMES {
                names.push(name);
            }
        }
    }
    let Some(span) = first else {
        return;
    };
    if names.len() > NAMES {
        names.truncate(NAMES);
        names.push("…".to_owned());
    }
    let problem = Problem::new("run-subprogram", span, names.join(", "));
    found.push(problem.diagnostic(Severity::Note));
}

/// What a block calls that is not here, with the place of the word.
fn missing(program: &Program, programs: &Programs, block: &Block) -> Vec<(Span, String)> {
    let words = program.words_of(block);
    if program.dialect == Dialect::Nct {
        return numbered_outside(program, programs, block).into_iter().collect();
    }
    let named = words.iter().enumerate().filter_map(|(at, word)| {
        let name = named_outside(program, programs, words, at)?;
        // a text is called at the word before it
        let manner = at.checked_sub(1).and_then(|before| words.get(before));
        let manner = manner.filter(|_| matches!(word.kind, WordKind::Constant(_)));
        let place = manner.unwrap_or(word).span;
        Some((place, bare(&program.name(name)).to_owned()))
    });
    named.collect()
}

/// NCT: the program at P that `M98` or `G65` calls, where a number stands there and no macro has it.
fn numbered_outside(program: &Program, programs: &Programs, block: &Block) -> Option<(Span, String)> {
    let number = |letter: &str| {
        let mut words = program.words_of(block).iter();
        words.find_map(|word| match &word.kind {
            WordKind::Address { name, value, .. } if program.is(*name, letter) => match program.expr(*value)? {
                Expr::Number(number, _) => Some((word.span, *number)),
                _ => None,
            },
            _ => None,
        })
    };
    let by_macro = number("G").is_some_and(|(_, code)| code == 65.0);
    if !by_macro && number("M").is_none_or(|(_, code)| code != 98.0) {
        return None;
    }
    let (span, called) = number("P")?;
    let name = numbered(called)?;
    let known = by_macro && nct::by_program(called).is_some();
    (!known && programs.place(&name).is_none()).then_some((span, name))
}
