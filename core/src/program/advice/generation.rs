//! The generation of the control by what a program writes, against that of the machine.

use crate::control::{Control, GENERATION, OF_LISTS};
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::Style;
use crate::own;
use crate::program::calls::CallSite;
use crate::program::lists::list_calls;
use crate::syntax::Program;

/// The first call that a control of the generation of the machine does not take as it is written; one finding for the
/// program. A machine whose generation is not told takes both.
pub fn look(program: &Program, sites: &[CallSite], control: &Control) -> Option<Diagnostic> {
    let generation = control.number(GENERATION);
    if generation == 0.0 {
        return None;
    }
    let (sentence, name, span) = if generation < OF_LISTS {
        let call = list_calls(program).into_iter().next()?;
        (own::GENERATION_LIST, call.list.name, call.span)
    } else {
        let (name, span) = sites.iter().find_map(assigned)?;
        (own::GENERATION_ASSIGNED, name, span)
    };
    Some(sentence.finding().text("cycle", name).number("generation", generation).on(span))
}

/// A call that older controls take, of a cycle that newer ones call with a list.
fn assigned(site: &CallSite) -> Option<(&'static str, Span)> {
    let listed = site.cycle.lists.iter().any(|list| list.style == Style::Operate);
    (listed && site.newer_list().is_none()).then_some((site.cycle.name, site.span))
}
