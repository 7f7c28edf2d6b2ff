//! Addresses that are written like elements of an array: `SPOS[1]=AC(90)`, `S[1]=500`, `M[1]=3`, `AX[NAME]=5`,
//! `G[8]=2`.

use super::{
    Address, Call, Datum, Interpreter, Words, declare, diameters, evaluate, locals, noted, other_axes, system,
};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::tree::{Expr, ExprId, Word, WordKind};

/// How a position may be meant.
const MODES: [&str; 11] = ["AC", "IC", "DC", "ACP", "ACN", "CAC", "CIC", "DAC", "DIC", "RAC", "RIC"];

/// Axes that move by themselves; `POSA` does not wait for their end.
const POSITIONING: [&str; 2] = ["POS", "POSA"];

/// Takes such an address; false: it is none. Another spindle or axis than the machine's own is told and left out.
/// `POS[X]=10` is a rapid motion of its own behind that of the block; rotary axes (`POSA[C]=90`) turn with it.
pub fn take(run: &mut Interpreter, word: &Word, found: &mut Words) -> Result<bool, Problem> {
    let WordKind::Assign { name, index, value, .. } = &word.kind else { return Ok(false) };
    let ([index], span) = (&index[..], word.span) else { return Ok(false) };
    let name = run.program.name(*name);
    let alone = POSITIONING.contains(&&*name);
    let (name, simulated) = match &*name {
        _ if alone => {
            let axis = axis_name(run, *index)?;
            let there =
                declare::is_axis(&axis) || run.sim.control.rotary_axis(&axis).is_some() || other_axes::is_name(&axis);
            (axis, there)
        }
        "SPOS" | "SPOSA" | "S" | "M" => (name, evaluate(run, *index)?.number() == Some(1.0)),
        "G" => return by_group(run, *index, *value, span, found).map(|()| true),
        "PO" => return polynomial(run, *index, *value, span, found).map(|()| true),
        "AX" => (evaluate(run, *index)?.shown(), true),
        _ => return Ok(false),
    };
    if !simulated {
        noted::without(run, "run-passed", span, &name);
        return Ok(true);
    }
    let (mode, value) = meant(run, *value)?;
    let linear = alone && declare::is_axis(&name);
    if linear {
        run.tell(Severity::Note, &Problem::new("run-positioning", span, &*name));
    }
    let list = if linear { &mut found.positioning } else { &mut found.addresses };
    list.push(Address { name, extension: None, mode, value, span });
    Ok(true)
}

/// `G[8]=3`: the third function of group 8, G55. One that has no such number here is told and left out.
fn by_group(run: &mut Interpreter, group: ExprId, value: ExprId, span: Span, found: &mut Words) -> Result<(), Problem> {
    let [group, number] = [group, value].map(|id| evaluate(run, id));
    let (group, number) = (group?.number(), number?.number());
    if let Some(name) = group.zip(number).and_then(|(group, number)| diameters::function(group, number)) {
        found.calls.push(Call::named(name, span));
        return Ok(());
    }
    match group.zip(number).and_then(|(group, number)| system::function(group, number)) {
        Some(code) => {
            let value = Datum::Number(code.into());
            found.addresses.push(Address { name: "G".to_owned(), extension: None, mode: None, value, span });
        }
        None => noted::without(run, "run-passed", span, "G[]"),
    }
    Ok(())
}

/// `PO[X]=(10,1.5,0.2)`: where the polynomial of an axis ends, which is all that is simulated of it.
fn polynomial(run: &Interpreter, index: ExprId, value: ExprId, span: Span, found: &mut Words) -> Result<(), Problem> {
    let name = axis_name(run, index)?;
    let end = match evaluate(run, value)? {
        Datum::List(values) => values.into_iter().next().flatten(),
        value => Some(value),
    };
    let end = end.ok_or_else(|| Problem::new("run-not-a-number", span, &*name))?;
    found.addresses.push(Address { name, extension: None, mode: None, value: end, span });
    Ok(())
}

/// The axis between the brackets; a name that is no variable is itself one, as `U` on a machine without it.
pub fn axis_name(run: &Interpreter, index: ExprId) -> Result<String, Problem> {
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
