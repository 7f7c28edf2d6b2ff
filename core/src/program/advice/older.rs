//! Calls of older versions: measuring cycles of the 840C, and subprograms of the measuring cycles.

use crate::catalogue::subroutines::{self, Subroutine};
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::program::r_parameters;
use crate::syntax::programs::Programs;
use crate::syntax::{Program, Word};
use std::collections::BTreeSet;

/// Tells of them, and the first bytes of the words that call them.
pub fn look(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) -> BTreeSet<u32> {
    if program.grammar().by_address {
        return BTreeSet::new();
    }
    let older = r_parameters::find(program, programs, &r_parameters::Answers::new());
    r_parameters::findings(program, programs, &older, found);
    for (word, one) in subroutines_of(program, programs) {
        found.push(own::OLDER_SUBROUTINE.finding().text("name", one.name).text("what", one.key).on(word.span));
    }
    known(program, programs, &older)
}

/// The first bytes of the words that call measuring cycles of the 840C, or subprograms of measuring cycles.
pub fn known(program: &Program, programs: &Programs, older: &r_parameters::Older) -> BTreeSet<u32> {
    let calls = older.calls.iter().map(|call| call.word.start);
    calls.chain(subroutines_of(program, programs).map(|(word, _)| word.span.start)).collect()
}

fn subroutines_of<'a>(
    program: &'a Program,
    programs: &'a Programs,
) -> impl Iterator<Item = (&'a Word, &'static Subroutine)> {
    program.words.iter().filter_map(|word| {
        let name = program.name(word.called()?);
        let other = Some(name).filter(|name| programs.place(name).is_none())?;
        Some((word, subroutines::find(&other)?))
    })
}
