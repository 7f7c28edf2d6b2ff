//! `GOTOS`: back to the first block of the program. Where nothing decides over it, it is the end of a run: from there
//! the same part would be made again and again.

use super::{Interpreter, Next};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::links::Link;

/// Where the run goes on behind it.
pub fn begin_again(run: &mut Interpreter, at: usize, place: Span) -> Next {
    let Some(level) = run.levels.last() else { return Next::End };
    if decided(run, level.blocks.start, at) {
        return Next::Jump(level.blocks.start);
    }
    run.tell(Severity::Note, &Problem::new("run-restart", place, "GOTOS"));
    Next::End
}

/// Whether a condition decides over a block: its own, or that of an `IF` around it.
fn decided(run: &Interpreter, first: usize, at: usize) -> bool {
    let own = run.program.words_at(at).iter().any(|word| run.program.is_keyword(word, &["IF", "CASE"]));
    let around = |block: usize| match run.link(block) {
        Some(Link::If(other) | Link::Else(other)) => other > at,
        _ => false,
    };
    own || (first..at).any(around)
}
