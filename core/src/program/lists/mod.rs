//! Calls in the argument lists of newer controls: what stands at each argument, and changes of one. Also of cycles that
//! the older control does not have.

pub mod findings;

use super::arguments::{put, texts};
use super::change::Edit;
use crate::catalogue::newer::arguments::Argument;
use crate::catalogue::newer::{self, LISTS};
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::entry::ArgumentList;
use crate::message::Message;
use crate::syntax::{Program, Word, WordKind};

/// A call in such a list.
pub struct ListCall {
    /// The list.
    pub list: &'static ArgumentList,
    /// The call.
    pub span: Span,
    /// Its arguments as far as it goes; more than the list has, where it has more.
    pub arguments: Vec<ListArgument>,
}

/// An argument of a call.
pub struct ListArgument {
    /// What is known of it.
    pub argument: Argument,
    /// Its place; empty where it is omitted.
    pub place: Span,
    /// What the control reads there: with what macros say; empty where it is omitted.
    pub text: String,
}

impl ListCall {
    /// Index of an argument by its name there; of one without a name by its place.
    pub fn index(&self, name: &str) -> Option<usize> {
        Argument::all(self.list).position(|one| !name.is_empty() && one.key().eq_ignore_ascii_case(name))
    }

    /// The argument at an offset of the text.
    pub fn at(&self, offset: u32) -> Option<&ListArgument> {
        self.arguments.iter().find(|one| one.place.start <= offset && offset <= one.place.end)
    }
}

/// Every call in such a list, in the order of the text.
pub fn list_calls(program: &Program) -> Vec<ListCall> {
    if program.dialect != Dialect::Sinumerik {
        return Vec::new();
    }
    program.words.iter().filter_map(|word| list_call(program, word)).collect()
}

/// Cycles that only newer controls have, each with what it does.
pub fn without_form() -> impl Iterator<Item = (&'static str, Message)> {
    LISTS.iter().filter_map(|list| Some((list.name, newer::title(list)?)))
}

/// A word as such a call.
pub fn list_call(program: &Program, word: &Word) -> Option<ListCall> {
    let WordKind::Call { name, args } = &word.kind else { return None };
    if args.is_empty() {
        return None; // the bare name takes assignments
    }
    let list = LISTS.iter().find(|list| program.is(*name, list.name))?;
    let list = newer::of_count(list, args.len());
    let arguments = texts(program, word.span).into_iter().enumerate();
    let arguments =
        arguments.map(|(index, (place, text))| ListArgument { argument: Argument::at(list, index), place, text });
    Some(ListCall { list, span: word.span, arguments: arguments.collect() })
}

/// The edit that gives an argument this text; an empty one omits it. None: nothing changes, or it is no single one.
pub fn set(program: &Program, call: &ListCall, index: usize, text: &str) -> Option<Edit> {
    let text = text.trim();
    let shared = |place: Span| program.is_of_macro(place);
    let own = !shared(call.span) && !call.arguments.get(index).is_some_and(|one| shared(one.place));
    let own = own && is_one_argument(text);
    own.then(|| put(program, call.span, index, text))?
}

/// Whether a text stands between two commas as one argument: quotes and brackets are closed, no comment begins.
fn is_one_argument(text: &str) -> bool {
    let (mut depth, mut quoted) = (0_i64, false);
    for one in text.chars() {
        match one {
            '\n' | '\r' => return false,
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ';' => return false,
            ',' if depth == 0 => return false,
            _ => {}
        }
        if depth < 0 {
            return false;
        }
    }
    depth == 0 && !quoted
}

#[cfg(test)]
mod tests;
