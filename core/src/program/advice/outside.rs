//! Programs of another memory that this text does not hold (`EXTCALL`): what they leave is not known. Told once.

use super::at;
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::program::flow::{Called, called, named_outside};
use crate::program::tree::Program;
use crate::run::programs::{Programs, bare};

/// Most names that are told.
const NAMES: usize = 8;

/// The programs that are not here, at the first call of one.
pub fn look(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) {
    let (mut first, mut names) = (None, Vec::new());
    for block in &program.blocks {
        let words = program.words_of(block);
        for (index, word) in words.iter().enumerate() {
            let Some(name) = named_outside(program, words, index) else {
                continue;
            };
            if called(program, programs, words, index) == Some(Called::Elsewhere) {
                first = first.or(Some(word.span));
                let name = bare(&program.name(name)).to_owned();
                if !names.contains(&name) && names.len() <= NAMES {
                    names.push(name);
                }
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
    let finding = own::ADVICE_OUTSIDE
        .finding()
        .text("names", names.join(", "));
    found.push(at(finding, span));
}
