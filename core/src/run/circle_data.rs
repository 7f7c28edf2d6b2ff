//! `OK=CALCDAT(POINTS,3,RESULT)`: the circle through three points, or as near as possible to four, as CYCLE116 computes
//! it (840D sl, Job planning, "Calculate circle data").

use super::{Datum, Interpreter, evaluate, names};
use crate::geometry::fit;
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId};
use std::rc::Rc;

/// The function.
const NAME: &str = "CALCDAT";
/// How many points it takes.
const COUNTS: [usize; 2] = [3, 4];

/// Whether there is such a circle, as the right side of an assignment: abscissa, ordinate and radius are written into
/// the last argument, which stays as it is where there is none. None: it is something else.
pub fn assigned(run: &mut Interpreter, value: ExprId) -> Result<Option<Datum>, Problem> {
    let program = Rc::clone(&run.program);
    let Some(Expr::Call(place, args)) = program.expr(value) else { return Ok(None) };
    if !program.is(*place, NAME) {
        return Ok(None);
    }
    let refused = || Problem::new("run-function", *place, NAME);
    let [points, count, result] = args[..] else { return Err(refused()) };
    let Some(Expr::Name { name: result, index }) = program.expr(result) else { return Err(refused()) };
    let count = evaluate(run, count)?.number().and_then(|count| COUNTS.into_iter().find(|one| *one as f64 == count));
    let points = count.and_then(|count| places(&evaluate(run, points).ok()?, count)).ok_or_else(refused)?;
    let Some(([abscissa, ordinate], radius)) = fit::circle(&points) else { return Ok(Some(Datum::from(false))) };
    let found = [abscissa, ordinate, radius].map(|value| Some(Datum::Number(value)));
    let key = names::key(run, *result, index)?;
    names::write(run, &first(&key), &Datum::List(found.to_vec()), *place)?;
    Ok(Some(Datum::from(true)))
}

/// So many points of an array with abscissa and ordinate of each.
fn places(value: &Datum, count: usize) -> Option<Vec<[f64; 2]>> {
    let Datum::List(items) = value else { return None };
    let numbers: Option<Vec<f64>> = items.iter().take(2 * count).map(|item| item.as_ref()?.number()).collect();
    let numbers = numbers.filter(|numbers| numbers.len() == 2 * count)?;
    Some(numbers.as_chunks().0.to_vec())
}

/// The element with which a list of values begins.
fn first(key: &str) -> String {
    if key.contains('[') { key.to_owned() } else { format!("{key}[0]") }
}
