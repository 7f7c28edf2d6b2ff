//! How a block calls a program: by its name, by a text that names it, or again after each motion (`MCALL`).

use super::interpret::Interpreter;
use super::names;
use super::statement::{Call, Words};
use crate::problem::Problem;
use crate::syntax::language::{BY_PATH, CALL, FROM_OUTSIDE, MODAL};

/// The calls of a block that are carried out now.
pub fn calls(run: &mut Interpreter, found: &Words) -> Result<Vec<Call>, Problem> {
    let [first, rest @ ..] = &found.calls[..] else {
        return Ok(Vec::new());
    };
    match first.name.as_str() {
        CALL | FROM_OUTSIDE => Ok(vec![named_by_text(run, first, rest)?]),
        BY_PATH => Ok(rest.to_vec()),
        MODAL => {
            if let Some(level) = run.levels.last_mut() {
                level.modal = rest.first().cloned();
            }
            Ok(Vec::new())
        }
        _ => Ok(found.calls.clone()),
    }
}

/// The call that follows a motion of the present program.
pub fn after_motion(run: &Interpreter) -> Option<Call> {
    run.levels.last().and_then(|level| level.modal.clone())
}

/// `CALL "NAME"`, `CALL VARIABLE`, `EXTCALL("NAME")`: the program that the text names.
fn named_by_text(run: &Interpreter, call: &Call, rest: &[Call]) -> Result<Call, Problem> {
    let text = match (&call.args[..], rest) {
        ([Some(text)], []) => text.clone(),
        ([], [variable]) => names::read(run, &variable.name, variable.span)?,
        _ => return Err(Problem::new("run-function", call.span, &*call.name)),
    };
    Ok(Call { name: text.shown().to_ascii_uppercase(), args: Vec::new(), places: Vec::new(), span: call.span })
}
