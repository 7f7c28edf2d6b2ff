//! Functions that compute something that is not simulated: intersections, ways that are free, frames and offsets that
//! were measured, curves. What they would have written is not known from then on, as behind a word that could not be
//! read; where one decides otherwise (a condition, a position), the run stops. 840D sl, Job planning.

use super::{Call, Interpreter, names, noted};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId};
use std::rc::Rc;

/// Such a function.
pub struct Function {
    name: &'static str,
    /// Places of the arguments that it writes.
    writes: &'static [usize],
    /// Data of the control that it changes besides.
    changes: &'static [&'static str],
}

const fn of(name: &'static str, writes: &'static [usize]) -> Function {
    Function { name, writes, changes: &[] }
}

/// By name. CALCDAT is computed as the right side of an assignment alone, as nothing else may be written.
const FUNCTIONS: [Function; 14] = [
    Function { changes: &["$P_ACTFRAME"], ..of("ADDFRAME", &[]) },
    of("AXTOINT", &[]),
    of("CALCDAT", &[2]),
    of("CALCPOSI", &[3]),
    of("CORRTC", &[]),
    of("CORRTRAFO", &[0, 1]),
    of("CTAB", &[2]),
    of("CTABINV", &[3]),
    of("GETTCOR", &[0]),
    of("GETTENV", &[1]),
    of("INTERSEC", &[2]),
    of("LENTOAX", &[0, 1]),
    of("MEAFRAME", &[2]),
    Function { changes: &["$TC_DP3", "$TC_DP4", "$TC_DP5", "$TC_DP6"], ..of("SETTCOR", &[]) },
];

/// The function of this name.
pub fn find(name: &str) -> Option<&'static Function> {
    FUNCTIONS.iter().find(|one| one.name == name)
}

/// Goes on without an assignment whose right side has such a function; false: the problem is another one.
pub fn leaves(run: &mut Interpreter, problem: &Problem, key: &str, value: ExprId) -> Result<bool, Problem> {
    let program = Rc::clone(&run.program);
    let place = problem.span;
    let name = program.name(place);
    let Some(function) = find(&name).filter(|_| problem.message.key == "run-not-simulated") else { return Ok(false) };
    run.unread.insert(key.to_owned(), place);
    let mut places = Vec::new();
    if let Some(Expr::Call(_, args)) = program.expr(value) {
        for argument in args {
            places.push(match program.expr(*argument) {
                Some(Expr::Name { name, index }) => Some(names::key(run, *name, index)?),
                _ => None,
            });
        }
    }
    passed(run, function, &places, place);
    Ok(true)
}

/// Goes on without a block that calls such a function; false: it calls something else.
pub fn call(run: &mut Interpreter, call: &Call) -> bool {
    let Some(function) = find(&call.name) else { return false };
    passed(run, function, &call.places, call.span);
    true
}

/// Tells it; what the arguments with these names would have become nobody knows.
fn passed(run: &mut Interpreter, function: &Function, places: &[Option<String>], span: Span) {
    noted::without(run, "run-passed", span, function.name);
    let written = function.writes.iter().filter_map(|at| places.get(*at)?.clone());
    let changed = function.changes.iter().map(|name| (*name).to_owned());
    run.unread.extend(written.chain(changed).map(|name| (name, span)));
}

// oracle: self (a list that is read by people)
#[test]
fn functions_are_sorted() {
    assert!(FUNCTIONS.is_sorted_by_key(|function| function.name));
}
