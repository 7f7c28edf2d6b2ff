//! Addresses that are written like elements of an array: `SPOS[1]=AC(90)`, `S[1]=500`, `M[1]=3`, `AX[NAME]=5`.

use super::datum::Datum;
use super::expression::evaluate;
use super::interpret::Interpreter;
use super::problem::Problem;
use super::statement::Address;
use crate::diagnostic::{Severity, Span};
use crate::program::tree::{Expr, ExprId};

/// How a position may be meant.
const MODES: [&str; 7] = ["AC", "IC", "DC", "ACP", "ACN", "CAC", "CIC"];

/// Takes such an address; false: it is none of these. Another spindle than the first is told and left out; a positioning axis
/// stops the run, as nobody knows then where it stands.
pub fn take(
    run: &mut Interpreter,
    name: &str,
    index: &[ExprId],
    value: ExprId,
    span: Span,
    addresses: &mut Vec<Address>,
) -> Result<bool, Problem> {
    let [index] = index else {
        return Ok(false);
    };
    let (name, simulated) = match name {
        "POS" | "POSA" | "POSP" => return Err(Problem::new("run-not-simulated", span, name)),
        "SPOS" | "SPOSA" | "S" | "M" => (
            name.to_owned(),
            evaluate(run, *index)?.number() == Some(1.0),
        ),
        "AX" => (evaluate(run, *index)?.shown(), true),
        "FA" => (name.to_owned(), false),
        _ => return Ok(false),
    };
    if !simulated {
        run.tell(
            Severity::Warning,
            &Problem::new("run-not-simulated", span, name),
        );
        return Ok(true);
    }
    let (mode, value) = meant(run, value)?;
    addresses.push(Address {
        name,
        extension: None,
        mode,
        value,
        span,
    });
    Ok(true)
}

/// `AC(90)` as the mode and its value.
fn meant(run: &Interpreter, value: ExprId) -> Result<(Option<String>, Datum), Problem> {
    if let Some(Expr::Call(name, args)) = run.program.expr(value)
        && let [inside] = args[..]
    {
        let mode = run.program.name(*name).to_string();
        if MODES.contains(&mode.as_str()) {
            return Ok((Some(mode), evaluate(run, inside)?));
        }
    }
    Ok((None, evaluate(run, value)?))
}
