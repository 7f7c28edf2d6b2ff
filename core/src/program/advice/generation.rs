//! The generation of the control by what a program writes, against that of the machine.

use crate::control::setting_data::{SETTING_DATA, is_of_program, replaces_array};
use crate::control::{Control, GENERATION, OF_LISTS};
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::Style;
use crate::own;
use crate::program::calls::CallSite;
use crate::program::lists::list_calls;
use crate::syntax::tree::Expr;
use crate::syntax::{Program, WordKind};

/// What a control of the generation of the machine does not take as it is written: the first call, else the first datum
/// that this generation does not have; one finding for the program. A machine whose generation is not told takes all.
pub fn look(program: &Program, sites: &[CallSite], control: &Control) -> Option<Diagnostic> {
    let generation = control.number(GENERATION);
    if generation == 0.0 {
        return None;
    }
    let call = match generation < OF_LISTS {
        true => list_calls(program).into_iter().next().map(|call| (own::GENERATION_LIST, call.list.name, call.span)),
        false => sites.iter().find_map(assigned).map(|(name, span)| (own::GENERATION_ASSIGNED, name, span)),
    };
    if let Some((sentence, name, span)) = call {
        return Some(sentence.finding().text("cycle", name).number("generation", generation).on(span));
    }
    let newer = control.has_setting_data();
    let sentence = if newer { own::GENERATION_USER_DATA } else { own::GENERATION_SETTING_DATA };
    let (name, span) = data(program).find(|(name, _)| if newer { replaces_array(name) } else { is_setting(name) })?;
    Some(sentence.finding().text("name", name).number("generation", generation).on(span))
}

/// A call that older controls take, of a cycle that newer ones call with a list.
fn assigned(site: &CallSite) -> Option<(&'static str, Span)> {
    let listed = site.cycle.lists.iter().any(|list| list.style == Style::Operate);
    (listed && site.newer_list().is_none()).then_some((site.cycle.name, site.span))
}

fn is_setting(name: &str) -> bool {
    is_of_program(name) && SETTING_DATA.iter().any(|datum| datum.identifier() == name)
}

/// The variables of a program by their names without index: first those that it writes, then those that it reads. What
/// it declares itself is none of the control's.
fn data(program: &Program) -> impl Iterator<Item = (String, Span)> {
    let declared: Vec<String> = program.words.iter().filter_map(|word| Some(program.name(word.declared()?))).collect();
    let written = program.words.iter().filter_map(|word| match &word.kind {
        WordKind::Assign { name, .. } => Some(*name),
        _ => None,
    });
    let read = program.exprs.iter().filter_map(|expr| match expr {
        Expr::Name { name, .. } => Some(*name),
        _ => None,
    });
    let all = written.chain(read).map(|place| (program.name(place), program.placed(place)));
    all.filter(move |(name, _)| !declared.contains(name))
}
