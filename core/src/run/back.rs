//! `RET` with parameters (Job planning, parameterizable subprogram return): over several program levels, to a block of
//! the program that goes on.

use super::{Datum, Interpreter, Next, branch, expression, subprogram};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId};

/// How a program is left.
#[derive(Clone, Debug)]
pub struct Back {
    /// Label or block number where the caller goes on; none: behind its call.
    target: Option<String>,
    /// Whether it goes on in the block behind that.
    behind: bool,
    /// How many programs end.
    levels: usize,
    place: Span,
}

impl Default for Back {
    fn default() -> Back {
        Back { target: None, behind: false, levels: 1, place: Span::default() }
    }
}

/// `RET`, `RET("LABEL")`, `RET("LABEL",1,2)`: target, whether behind it, program levels. The fourth, back to the first
/// block of the main program, is not simulated.
pub fn written(run: &Interpreter, place: Span, value: Option<ExprId>) -> Result<Back, Problem> {
    let Some(Expr::List(items)) = value.and_then(|value| run.program.expr(value)) else { return Ok(Back::default()) };
    let values = expression::list(run, items)?;
    let value = |index: usize| values.get(index).and_then(Option::as_ref);
    let number = |index: usize| match value(index).map(Datum::number) {
        None => Ok(0.0),
        Some(number) => number.ok_or_else(|| Problem::new("run-not-a-number", place, "RET")),
    };
    if values.len() > 4 {
        return Err(Problem::new("run-function", place, "RET"));
    }
    if number(3)? != 0.0 {
        return Err(Problem::new("run-not-simulated", place, "RET(,,,1)"));
    }
    let levels = if value(2).is_some() { number(2)? } else { 1.0 };
    if levels < 1.0 || levels.fract() != 0.0 {
        return Err(Problem::new("run-range", place, "RET"));
    }
    let target = value(0).map(|target| branch::named(target).trim().to_owned());
    let target = target.filter(|target| !target.is_empty());
    Ok(Back { target, behind: number(1)? != 0.0, levels: levels as usize, place })
}

/// Leaves so many programs, whatever passes of them are to come; the main program ends the run.
pub fn go(run: &mut Interpreter, back: &Back) -> Result<Next, Problem> {
    if run.levels.len() <= 1 || back.target.is_none() && back.levels == 1 {
        return Ok(subprogram::leave(run));
    }
    if back.levels >= run.levels.len() {
        return Err(Problem::new("run-range", back.place, "RET"));
    }
    let Some(level) = (0..back.levels).map_while(|_| subprogram::close(run)).last() else { return Ok(Next::End) };
    let Some(target) = &back.target else { return Ok(subprogram::goes_on(run, &level)) };
    let [forward, backward] = branch::nearest(run, target, level.call);
    let block = forward.or(backward).ok_or_else(|| Problem::new("run-label", back.place, target.as_str()))?;
    Ok(Next::Jump(block + usize::from(back.behind)))
}
