//! `EXECSTRING(TEXT)`: the block that a text holds, carried out in the place of the call.

use super::{Call, Datum, Halt, Interpreter, Next, Words, action, statement};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::program::of_control::EXECUTE_TEXT;
use crate::syntax::tree::{Program, WordKind};
use std::rc::Rc;

/// Work of reading a text, in blocks.
const READING: u64 = 10;

/// Carries out the text of a call; what is no plain block is told and passed over.
pub fn carry_out(run: &mut Interpreter, at: usize, call: &Call) -> Result<Option<Next>, Halt> {
    let Some(Datum::Text(text)) = call.arg(0) else {
        return Err(Problem::new("run-function", call.span, &*call.name).into());
    };
    run.work += READING;
    let read = run.program.again(text.as_bytes());
    if !is_plain(&read) {
        run.tell(Severity::Warning, &Problem::new("run-not-simulated", call.span, format!("{}: {text}", call.name)));
        return Ok(None);
    }
    let found = collected(run, at, call.span, read)?;
    match action::perform(run, found)? {
        Next::Block => Ok(None),
        next => Ok(Some(next)),
    }
}

/// Whether a text is one block of addresses, assignments and calls.
fn is_plain(read: &Program) -> bool {
    let plain = |kind: &WordKind| matches!(kind, WordKind::Address { .. } | WordKind::Assign { .. });
    let called = |kind: &WordKind| matches!(kind, WordKind::Call { name, .. } if !read.is(*name, EXECUTE_TEXT));
    let words = || read.words.iter().map(|word| &word.kind);
    read.errors.is_empty() && read.blocks.len() == 1 && words().all(|kind| plain(kind) || called(kind))
}

/// The words of the text, whose places are that of the call.
fn collected(run: &mut Interpreter, at: usize, span: Span, read: Program) -> Result<Words, Problem> {
    let mut found = Words::before(at, span);
    let words = read.words.clone();
    let told = run.diagnostics.len();
    let own = std::mem::replace(&mut run.program, Rc::new(read));
    let taken = words.iter().try_for_each(|word| statement::word_of(run, word, &mut found).map(|_| ()));
    run.program = own;
    let placed = run.placed(span);
    for one in run.diagnostics.iter_mut().skip(told) {
        one.span = Some(placed);
    }
    taken.map_err(|problem| Problem { span, ..problem })?;
    let Words { addresses, positioning, calls, .. } = &mut found;
    addresses.iter_mut().chain(positioning).for_each(|address| address.span = span);
    calls.iter_mut().for_each(|call| call.span = span);
    Ok(found)
}
