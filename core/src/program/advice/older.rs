//! Calls of older versions: measuring cycles of the 840C, and subprograms of the measuring cycles.

use crate::catalogue::subroutines;
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::program::r_parameters;
use crate::syntax::Program;
use crate::syntax::programs::Programs;
use std::collections::BTreeSet;

/// Tells of them, and the first bytes of the words that call them.
pub fn look(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) -> BTreeSet<u32> {
    if program.grammar().by_address {
        return BTreeSet::new();
    }
    let older = r_parameters::find(program, programs, &r_parameters::Answers::new());
    r_parameters::findings(program, programs, &older, found);
    let mut known: BTreeSet<u32> = older.calls.iter().map(|call| call.word.start).collect();
    for word in &program.words {
        let name = word.called().map(|name| program.name(name));
        let other = name.filter(|name| programs.place(name).is_none());
        if let Some(one) = other.as_deref().and_then(subroutines::find) {
            known.insert(word.span.start);
            found.push(own::OLDER_SUBROUTINE.finding().text("name", one.name).text("what", one.key).on(word.span));
        }
    }
    known
}
