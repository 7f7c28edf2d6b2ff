//! Calls with arguments in brackets: `CYCLE_PARA(…)`, the parameterizing calls, the lists of newer controls.

use super::datum::Datum;
use super::interpret::Interpreter;
use super::statement::Call;
use super::{Stop, cycle, helper};
use crate::catalogue::{Arg, ArgumentList, Cycle, Dialect, Kind, Style, list};
use crate::check::Typed;
use crate::control::Value;

/// Carries out a call with arguments; false: it is none of these.
pub fn call(run: &mut Interpreter, call: &Call) -> Result<bool, Stop> {
    if call.name == list::AUXILIARY {
        auxiliary(run, call);
        return Ok(true);
    }
    let number = |index: usize| call.args.get(index)?.as_ref()?.number();
    let listed = list::called(Dialect::Sinumerik, &call.name, call.args.len(), number);
    let Some((cycle, list)) = listed else {
        return Ok(false);
    };
    if helper::takes_variables(list) {
        helper::call(run, cycle, list, call)?;
        return Ok(true);
    }
    let values = values(cycle, list, call);
    if list.style == Style::Operate {
        let typed: Typed = values
            .iter()
            .filter_map(|(name, value)| {
                Some(((*name).to_owned(), Datum::from(value.as_ref()?).exact()))
            })
            .collect();
        cycle::checked(run, cycle, &typed, call.span)?;
        return Ok(true);
    }
    let data = &mut run.sim.control.data;
    for (name, value) in values {
        match value {
            None if list.style == Style::Direct => drop(data.remove(name)),
            value => {
                let value = value.unwrap_or_else(|| omitted(cycle, name));
                data.insert(name.to_owned(), value);
            }
        }
    }
    cycle::data(run, cycle, call.span)?;
    Ok(true)
}

/// What is not 0 goes into the data (B:11734).
fn auxiliary(run: &mut Interpreter, call: &Call) {
    for (name, value) in list::AUXILIARY_ARGS.iter().zip(&call.args) {
        let number = value.as_ref().and_then(Datum::number);
        if let Some(number) = number.filter(|number| *number != 0.0) {
            run.sim.control.set(*name, number);
        }
    }
}

/// The parameters of the list with what stands there, the variant put together from its selections.
fn values(
    cycle: &'static Cycle,
    list: &ArgumentList,
    call: &Call,
) -> Vec<(&'static str, Option<Value>)> {
    let at = |index: usize| call.args.get(index).and_then(Option::as_ref);
    let params = list
        .args
        .iter()
        .enumerate()
        .filter_map(|(index, arg)| match arg {
            Arg::Param(name) => Some((*name, at(index).and_then(Datum::value))),
            Arg::Down(name) => Some((*name, at(index).and_then(Datum::value).map(opposite))),
            _ => None,
        });
    let mut found: Vec<_> = params.collect();
    let number = |index| at(index).map_or(Some(0.0), |value| value.number());
    if let Some((name, variant)) = list.composed(cycle, number) {
        found.push((name, Some(Value::Number(variant as f64))));
    }
    found
}

/// A length with the other sign.
fn opposite(value: Value) -> Value {
    match value {
        Value::Number(number) => Value::Number(-number),
        text => text,
    }
}

/// What a called program finds in an argument that is omitted.
fn omitted(cycle: &Cycle, name: &str) -> Value {
    let text = cycle
        .param(name)
        .is_some_and(|param| matches!(param.kind, Kind::Text(_)));
    if text {
        Value::Text(String::new())
    } else {
        Value::Number(0.0)
    }
}
