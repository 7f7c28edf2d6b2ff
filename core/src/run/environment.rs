//! `TOOLENV("NAME")`: stores the tool environment, as a block of its own or as a function with a status (B:2062-2086).

use super::datum::Datum;
use super::expression::evaluate;
use super::interpret::Interpreter;
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::program::of_control::STORE_ENVIRONMENT;
use crate::syntax::tree::{Expr, ExprId};

/// Longest name of an environment, characters (B:2078).
const LONGEST: usize = 32;

/// Status of a stored environment.
const STORED: Datum = Datum::Number(0.0);

/// Stores the environment under the name in the first argument.
pub fn store(run: &mut Interpreter, args: &[Option<Datum>], place: Span) -> Result<Datum, Problem> {
    match args {
        [Some(Datum::Text(name))] if (1..=LONGEST).contains(&name.chars().count()) => {
            run.sim.control.store_environment(name);
            Ok(STORED)
        }
        _ => Err(Problem::new("run-function", place, STORE_ENVIRONMENT)),
    }
}

/// The same where the right side of an assignment is the function: its status. None: it is something else.
pub fn assigned(run: &mut Interpreter, value: ExprId) -> Result<Option<Datum>, Problem> {
    let program = std::rc::Rc::clone(&run.program);
    let Some(Expr::Call(name, args)) = program.expr(value) else {
        return Ok(None);
    };
    if !program.is(*name, STORE_ENVIRONMENT) {
        return Ok(None);
    }
    let args = args.iter().map(|arg| evaluate(run, *arg).map(Some)).collect::<Result<Vec<_>, _>>()?;
    store(run, &args, *name).map(Some)
}
