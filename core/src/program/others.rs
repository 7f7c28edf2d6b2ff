//! Calls of cycles that have no form: those of newer controls alone, and of a control that is read and not run.

use super::lists::list_calls;
use crate::catalogue::newer;
use crate::diagnostic::Span;
use crate::foreign;
use crate::message::Message;
use crate::syntax::Program;

/// Such a call.
pub struct Other {
    /// Cycle, as the program calls it.
    pub name: String,
    /// What it does.
    pub title: Message,
    /// Where it is called.
    pub span: Span,
    /// What stands at its arguments, by their names in the list; without name by their places.
    pub arguments: Vec<(&'static str, String)>,
}

/// Those of a program, and of files that are joined to it.
pub fn others(program: &Program) -> impl Iterator<Item = Other> {
    let of_lists = list_calls(program).into_iter().filter_map(|call| {
        let title = newer::title(call.list)?;
        let said = call.arguments.into_iter().filter(|one| !one.text.is_empty());
        let arguments = said.map(|one| (one.argument.key(), one.text)).collect();
        Some(Other { name: call.list.name.to_owned(), title, span: call.span, arguments })
    });
    let control = foreign::control_of(&program.source);
    let calls = control.map(|control| (control.calls)(&program.source)).into_iter().flatten();
    let of_foreign = calls.filter_map(|call| {
        let title = Message::new(call.cycle?.title());
        Some(Other { name: call.name, title, span: call.span, arguments: Vec::new() })
    });
    of_lists.chain(of_foreign)
}
