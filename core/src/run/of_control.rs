//! What the control itself answers: operator texts, alarms of the program, the tool environment.

use super::{Call, Datum, Halt, Interpreter, evaluate};
use crate::catalogue::alarms;
use crate::diagnostic::{Code, Span};
use crate::machine::Step;
use crate::problem::Problem;
use crate::program::of_control::{SET_ALARM, STORE_ENVIRONMENT};
use crate::syntax::tree::{Expr, ExprId};
use std::rc::Rc;

/// Numbers that a program may raise: those of cycles, and of users from 65000.
const NUMBERS: std::ops::RangeInclusive<u32> = 60_000..=69_999;

/// `SETAL(65000,"text")`: an alarm; from 62000 and 67000 it only shows (Job planning, alarms in the cycle area).
pub fn raise(run: &mut Interpreter, call: &Call) -> Result<(), Halt> {
    let (number, text) = match &call.args[..] {
        [Some(Datum::Number(number))] => (*number, ""),
        [Some(Datum::Number(number)), Some(Datum::Text(text))] => (*number, text.as_str()),
        _ => return Err(Problem::new("run-function", call.span, SET_ALARM).into()),
    };
    let whole = number as u32;
    if number.fract() != 0.0 || !NUMBERS.contains(&whole) {
        return Err(Problem::new("run-alarm-number", call.span, Datum::Number(number).shown()).into());
    }
    let code = Code::Alarm(whole);
    if alarms::find(&whole.to_string()).is_some() {
        run.sim.note(Step::Alarm(code));
    } else {
        run.sim.note(Step::Message { text: format!("{whole} {text}").trim_end().to_owned(), waits: false });
    }
    if matches!(whole / 1000, 62 | 67..=69) {
        return Ok(());
    }
    Err(Problem::at("run-set-alarm", call.span).number("number", f64::from(whole)).text("text", text).into())
}

/// Longest name of an environment, characters (B:2078).
const LONGEST: usize = 32;

/// Status of a stored environment.
const STORED: Datum = Datum::Number(0.0);

/// `TOOLENV("NAME")`: stores the tool environment, as a block of its own or as a function with a status (B:2062-2086).
pub fn store_environment(run: &mut Interpreter, args: &[Option<Datum>], place: Span) -> Result<Datum, Problem> {
    match args {
        [Some(Datum::Text(name))] if (1..=LONGEST).contains(&name.chars().count()) => {
            run.sim.control.store_environment(name);
            Ok(STORED)
        }
        _ => Err(Problem::new("run-function", place, STORE_ENVIRONMENT)),
    }
}

/// Status of `TOOLENV("NAME")` as the right side of an assignment; none: that is something else.
pub fn assigned(run: &mut Interpreter, value: ExprId) -> Result<Option<Datum>, Problem> {
    let program = Rc::clone(&run.program);
    let Some(Expr::Call(name, args)) = program.expr(value) else { return Ok(None) };
    if !program.is(*name, STORE_ENVIRONMENT) {
        return Ok(None);
    }
    let args = args.iter().map(|arg| evaluate(run, *arg).map(Some)).collect::<Result<Vec<_>, _>>()?;
    store_environment(run, &args, *name).map(Some)
}
