//! Addresses that are written like elements of an array: `SPOS[1]=AC(90)`, `S[1]=500`, `M[1]=3`, `AX[NAME]=5`.

use super::datum::Datum;
use super::expression::evaluate;
use super::interpret::Interpreter;
use super::locals;
use super::statement::{Address, Words};
use crate::control::AXES;
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId};

/// How a position may be meant.
const MODES: [&str; 7] = ["AC", "IC", "DC", "ACP", "ACN", "CAC", "CIC"];

/// Axes that move by themselves; `POSA` does not wait for their end.
const POSITIONING: [&str; 2] = ["POS", "POSA"];

/// Takes such an address; false: it is none. Another spindle or axis than the machine's own is told and left out.
pub fn take(
    run: &mut Interpreter,
    name: &str,
    index: &[ExprId],
    value: ExprId,
    span: Span,
    found: &mut Words,
) -> Result<bool, Problem> {
    let [index] = index else { return Ok(false) };
    if POSITIONING.contains(&name) {
        return positioning(run, *index, value, span, found).map(|()| true);
    }
    let (name, simulated) = match name {
        "SPOS" | "SPOSA" | "S" | "M" => (name.to_owned(), evaluate(run, *index)?.number() == Some(1.0)),
        "AX" => (evaluate(run, *index)?.shown(), true),
        _ => return Ok(false),
    };
    if !simulated {
        run.tell(Severity::Warning, &Problem::new("run-not-simulated", span, name));
        return Ok(true);
    }
    let (mode, value) = meant(run, value)?;
    found.addresses.push(Address { name, extension: None, mode, value, span });
    Ok(true)
}

/// `POS[X]=10`, `POSA[C]=90`: a rapid motion of its own behind that of the block; rotary axes turn with it.
fn positioning(
    run: &mut Interpreter,
    index: ExprId,
    value: ExprId,
    span: Span,
    found: &mut Words,
) -> Result<(), Problem> {
    let name = axis_name(run, index)?;
    let linear = AXES.contains(&name.as_str());
    if !linear && run.sim.control.rotary_axis(&name).is_none() {
        run.tell(Severity::Warning, &Problem::new("run-not-simulated", span, name));
        return Ok(());
    }
    let (mode, value) = meant(run, value)?;
    let list = if linear { &mut found.positioning } else { &mut found.addresses };
    if linear {
        run.tell(Severity::Note, &Problem::new("run-positioning", span, &*name));
    }
    list.push(Address { name, extension: None, mode, value, span });
    Ok(())
}

/// The axis between the brackets; a name that is no variable is itself one, as `U` on a machine without it.
fn axis_name(run: &Interpreter, index: ExprId) -> Result<String, Problem> {
    match run.program.expr(index) {
        Some(Expr::Name { name, index }) if index.is_empty() && !locals::declared(run, &run.program.name(*name)) => {
            Ok(run.program.name(*name))
        }
        _ => evaluate(run, index).map(|value| value.shown()),
    }
}

/// `AC(90)` as the mode and its value.
fn meant(run: &Interpreter, value: ExprId) -> Result<(Option<String>, Datum), Problem> {
    if let Some(Expr::Call(name, args)) = run.program.expr(value)
        && let [inside] = args[..]
    {
        let mode = run.program.name(*name);
        if MODES.contains(&mode.as_str()) {
            return Ok((Some(mode), evaluate(run, inside)?));
        }
    }
    Ok((None, evaluate(run, value)?))
}
