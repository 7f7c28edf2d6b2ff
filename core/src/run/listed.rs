//! Calls with arguments in brackets: `CYCLE_PARA(…)`, the parameterizing calls, the lists of newer controls.

use super::datum::Datum;
use super::halt::Halt;
use super::interpret::Interpreter;
use super::statement::Call;
use super::{cycle, helper, unread};
use crate::catalogue::{CYCLES, find, list};
use crate::check::{Sort, listed, newer};
use crate::control::Value;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, ArgumentList, Cycle, Kind, Param, Style, Typed};
use crate::name::Name;
use crate::problem::Problem;
use crate::program::arguments;

/// Carries out a call with arguments; false: it is none of these.
pub fn call(run: &mut Interpreter, call: &Call) -> Result<bool, Halt> {
    if call.name == AUXILIARY {
        return auxiliary(run, call);
    }
    let number = |index: usize| call.arg(index)?.number();
    let Some((cycle, list)) = list::called(run.program.dialect, &call.name, call.args.len(), number) else {
        return without(run, call);
    };
    if let Some(finding) = refused(cycle, Some(list), call) {
        return Err(stopped(run, call, cycle.name, finding));
    }
    if helper::takes_variables(list) {
        helper::call(run, cycle, list, call)?;
        return Ok(true);
    }
    let values = values(cycle, list, call);
    if list.style == Style::Operate {
        let typed = values.iter().filter_map(|(name, value)| Some((name, Datum::from(value.as_ref()?).exact())));
        let typed: Typed = typed.map(|(name, value)| (name.to_string(), value)).collect();
        newer_list(run, cycle, list, &typed, call.span)?;
        return Ok(true);
    }
    for (name, value) in values {
        unread::written(run, name.as_str());
        let data = &mut run.sim.control.data;
        match value {
            None if list.style == Style::Direct => drop(data.remove(name.as_str())),
            value => {
                let value = value.unwrap_or_else(|| omitted(cycle, name.as_str()));
                data.insert(name.to_string(), value);
            }
        }
    }
    cycle::data(run, cycle, call.span)?;
    Ok(true)
}

/// A call whose arguments are of no list.
fn without(run: &mut Interpreter, call: &Call) -> Result<bool, Halt> {
    let cycle = find(run.program.dialect, &call.name);
    let many = cycle.and_then(|cycle| refused(cycle, None, call));
    let unmatched = || list::unmatched(&call.name, listed::count(&call.args), |index| call.number(index));
    many.or_else(unmatched).map_or(Ok(false), |finding| Err(stopped(run, call, &call.name, finding)))
}

/// Why the control refuses the arguments.
fn refused(cycle: &'static Cycle, list: Option<&'static ArgumentList>, call: &Call) -> Option<Diagnostic> {
    let found = listed::refused(cycle, list, listed::count(&call.args), |index| call.number(index));
    found.or_else(|| of_wrong_sort(cycle, list?, call))
}

/// An argument that is a text where a number belongs, or the reverse.
fn of_wrong_sort(cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Option<Diagnostic> {
    list.args.iter().enumerate().find_map(|(index, arg)| {
        let (Arg::Param(name) | Arg::Down(name)) = arg else { return None };
        wrong(cycle.param(name)?, call.arg(index)?)
    })
}

fn wrong(param: &Param, value: &Datum) -> Option<Diagnostic> {
    let sort = match value {
        Datum::Text(_) => Sort::Text,
        Datum::Number(_) => Sort::Number,
        _ => Sort::Open,
    };
    listed::sort(param, &value.shown(), sort)
}

/// The run ends with what is wrong.
fn stopped(run: &mut Interpreter, call: &Call, name: &str, finding: Diagnostic) -> Halt {
    run.diagnostics.push(finding.on(call.span));
    Problem::new("run-call", call.span, name).into()
}

/// The list of a newer control, as far as the older one does the same. What only the newer one has is told.
fn newer_list(
    run: &mut Interpreter,
    cycle: &'static Cycle,
    list: &ArgumentList,
    typed: &Typed,
    span: Span,
) -> Result<(), Halt> {
    run.fit(cycle, typed);
    let checked = newer::check_listed(cycle, list, typed, &run.sim.control);
    if checked.inputs.is_some() {
        for (name, _) in arguments::only_newer(&run.program, list, span) {
            run.tell(Severity::Warning, &Problem::new("run-not-simulated", span, name));
        }
    }
    cycle::carry_out(run, cycle, checked, span)
}

/// What is not 0 goes into the data (B:11734).
fn auxiliary(run: &mut Interpreter, call: &Call) -> Result<bool, Halt> {
    let cycles = CYCLES.iter();
    let param = |name: &str| cycles.clone().find_map(|cycle| cycle.param(name));
    let names = AUXILIARY_ARGS.iter().enumerate();
    let wrong = names.clone().find_map(|(index, name)| wrong(param(name)?, call.arg(index)?));
    let many = list::unmatched(&call.name, listed::count(&call.args), |_| None);
    if let Some(finding) = many.or(wrong) {
        return Err(stopped(run, call, &call.name, finding));
    }
    for (name, value) in AUXILIARY_ARGS.iter().zip(&call.args) {
        let number = value.as_ref().and_then(Datum::number);
        if let Some(number) = number.filter(|number| *number != 0.0) {
            unread::written(run, name);
            run.sim.control.set(*name, number);
        }
    }
    Ok(true)
}

/// The parameters of the list with what stands there, the variant put together from its selections.
fn values(cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Vec<(Name, Option<Value>)> {
    let params = list.args.iter().enumerate().filter_map(|(index, arg)| match arg {
        Arg::Param(name) => Some((*name, call.arg(index).and_then(Datum::value))),
        Arg::Down(name) => Some((*name, call.arg(index).and_then(Datum::value).map(opposite))),
        _ => None,
    });
    let mut found: Vec<_> = params.collect();
    let composed = list.composed(cycle, |index| call.number(index));
    found.extend(composed.map(|(name, variant)| (name, Some(Value::Number(variant as f64)))));
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
    let text = cycle.param(name).is_some_and(|param| matches!(param.kind, Kind::Text(_)));
    if text { Value::Text(String::new()) } else { Value::Number(0.0) }
}
