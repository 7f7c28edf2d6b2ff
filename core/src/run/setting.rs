//! Setting data of newer controls in a program: `$SNS_MEA_WP_BALL_DIAM[0]`. Those that older controls have in user data
//! are these here, as all that measures reads them there.

use super::names;
use super::{Datum, Interpreter};
use crate::diagnostic::Span;
use crate::problem::Problem;

/// Value of such a datum; none: it is none, or nobody gave it a value.
pub fn read(run: &Interpreter, key: &str, place: Span) -> Option<Result<Datum, Problem>> {
    let control = &run.sim.control;
    match control.setting(key)? {
        None => Some(Err(absent(key, place))),
        Some((_, Some(older))) => Some(names::read(run, &older, place)),
        Some((name, None)) => control.data.get(&name).map(|value| Ok(Datum::from(value))),
    }
}

/// Writes such a datum; none: it is none.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Option<Result<(), Problem>> {
    let Some((name, older)) = run.sim.control.setting(key)? else { return Some(Err(absent(key, place))) };
    let Some(stored) = value.value() else { return Some(Err(Problem::new("run-not-a-number", place, key))) };
    if let Some(older) = older
        && let Err(problem) = names::write(run, &older, value, place)
    {
        return Some(Err(problem));
    }
    run.sim.control.data.insert(name, stored);
    Some(Ok(()))
}

fn absent(key: &str, place: Span) -> Problem {
    Problem::new("run-setting-absent", place, key)
}
