//! Calls with arguments in brackets: `CYCLE_PARA(…)`, the parameterizing calls, the lists of newer controls.

use super::names::{read as read_name, write as write_name};
use super::{Call, Datum, Halt, Interpreter, call, cycle, noted};
use crate::catalogue::{Argument, CYCLES, find, list};
use crate::check::{self, Sort, listed, newer};
use crate::control::{Plane, Value};
use crate::diagnostic::Diagnostic;
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, ArgumentList, Cycle, Inputs, Kind, Param, Style, Typed, names};
use crate::machine::Machine;
use crate::name::Name;
use crate::own;
use crate::problem::Problem;

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
    if list.args.iter().any(|arg| matches!(arg, Arg::Variable(_) | Arg::Output(_))) {
        return helper(run, cycle, list, call).map(|()| true);
    }
    if list.style == Style::Operate {
        return newer_list(run, cycle, list, call).map(|()| true);
    }
    for (name, value) in values(cycle, list, call) {
        run.unread.remove(name.as_str());
        let data = &mut run.sim.control.data;
        match value.or_else(|| (list.style != Style::Direct).then(|| omitted(cycle, name.as_str()))) {
            Some(value) => data.insert(name.to_string(), value),
            None => data.remove(name.as_str()),
        };
    }
    cycle::data(run, cycle, call.span)?;
    Ok(true)
}

/// A call whose arguments are of no list.
fn without(run: &mut Interpreter, call: &Call) -> Result<bool, Halt> {
    let cycle = find(run.program.dialect, &call.name);
    let many = cycle.and_then(|cycle| refused(cycle, None, call));
    let unmatched = || list::unmatched(&call.name, listed::count(&call.args), |index| call.number(index));
    if let Some(finding) = many.or_else(unmatched) {
        return Err(stopped(run, call, &call.name, finding));
    }
    match list::newer_alone(&call.name) {
        // it shows and logs what was measured, and moves nothing
        Some((list, false)) if run.programs.named(&call.name).is_none() => {
            noted::without(run, "run-result-screen", call.span, list.name);
            Ok(true)
        }
        Some((list, true)) if !call.args.is_empty() => {
            run.diagnostics.push(own::NEWER_ALONE.finding().text("cycle", list.name).on(call.span));
            Err(Problem::new("run-no-simulation", call.span, list.name).into())
        }
        _ => Ok(false),
    }
}

/// Why the control refuses the arguments.
fn refused(cycle: &'static Cycle, list: Option<&'static ArgumentList>, call: &Call) -> Option<Diagnostic> {
    let found = listed::refused(cycle, list, listed::count(&call.args), |index| call.number(index));
    found.or_else(|| of_wrong_sort(cycle, list?, call))
}

/// An argument that is a text where a number belongs, or the reverse.
fn of_wrong_sort(cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Option<Diagnostic> {
    list.args.iter().enumerate().find_map(|(index, arg)| wrong(cycle.param(arg.param()?.as_str())?, call.arg(index)?))
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
    list: &'static ArgumentList,
    call: &Call,
) -> Result<(), Halt> {
    let values = values(cycle, list, call).into_iter();
    let typed: Typed =
        values.filter_map(|(name, value)| Some((name.to_string(), Datum::from(&value?).exact()))).collect();
    let typed = newer::with_omitted(cycle, &typed);
    run.fit(cycle, &typed);
    let mut checked = newer::check_simulated(cycle, list, &typed, &run.sim.control);
    if checked.inputs.is_none() {
        checked.diagnostics.extend(newer::not_simulated(cycle, list, &typed, &run.sim.control));
    }
    let away = checked.inputs.as_ref().and_then(|inputs| leads_away(run, list, call, inputs));
    if let Some(direction) = away {
        checked.inputs = None;
        let name = Name::new(newer::DIRECTION);
        checked.diagnostics.push(own::NEWER_AWAY.finding().number("value", direction).at(name));
    }
    if let Some(why) = newer::unsure(cycle, list, &typed, &run.sim.control) {
        checked.inputs = None;
        checked.diagnostics.push(why);
    }
    for name in unsimulated(run, list, call) {
        checked.inputs = None;
        checked.diagnostics.push(own::NEWER_UNSIMULATED.finding().text("param", name).at(Name::new(name)));
    }
    checked.diagnostics = checked.diagnostics.into_iter().map(|one| newer::at_argument(list, one)).collect();
    let before = run.sim.control.number(newer::COARSE);
    run.sim.control.set(newer::COARSE, f64::from(u8::from(newer::is_coarse(&typed))));
    let done = cycle::carry_out(run, cycle, checked, call.span);
    run.sim.control.set(newer::COARSE, before);
    done
}

/// The arguments without a counterpart that say something: what the control makes of it is not simulated. The measuring
/// direction is; the modes that every program has say nothing, in the plane in which programs have them.
fn unsimulated(run: &Interpreter, list: &'static ArgumentList, call: &Call) -> Vec<&'static str> {
    let says = |argument: &Argument| match call.arg(argument.place - 1) {
        Some(Datum::Text(text)) => !text.is_empty(),
        Some(value) => {
            let usual = match argument.name {
                newer::MODE => true,
                newer::PLANE => run.sim.control.plane == Plane::G17,
                _ => false,
            };
            value.number().is_none_or(|number| number != 0.0 && !(usual && number == 1.0))
        }
        None => false,
    };
    let own = Argument::all(list).filter(|one| one.param.is_none() && one.name != newer::DIRECTION && says(one));
    own.map(|one| one.key()).filter(|key| !key.is_empty()).collect()
}

/// The measuring direction that is written, where it does not lead from where the probe is to the set position. The
/// older control measures towards that position; what the newer one does then is not published.
fn leads_away(run: &Interpreter, list: &ArgumentList, call: &Call, inputs: &Inputs) -> Option<f64> {
    let index = list.args.iter().position(|arg| matches!(arg, Arg::Newer(newer::DIRECTION, _)));
    let direction = call.number(index?).filter(|direction| *direction != 0.0)?;
    let axis = run.sim.control.plane.axes().get((inputs.integer(names::MA) % 10 - 1) as usize).copied()?;
    let minus = inputs.number(names::SETVAL) < run.sim.position()[axis];
    (direction != if minus { newer::MINUS } else { 1.0 }).then_some(direction)
}

/// What is not 0 goes into the data (B:11734).
fn auxiliary(run: &mut Interpreter, call: &Call) -> Result<bool, Halt> {
    let param = |name: &str| CYCLES.iter().find_map(|cycle| cycle.param(name));
    let wrong = AUXILIARY_ARGS.iter().enumerate().find_map(|(index, name)| wrong(param(name)?, call.arg(index)?));
    if let Some(finding) = list::unmatched(&call.name, listed::count(&call.args), |_| None).or(wrong) {
        return Err(stopped(run, call, &call.name, finding));
    }
    for (name, value) in AUXILIARY_ARGS.iter().zip(&call.args) {
        let number = value.as_ref().and_then(Datum::number);
        if let Some(number) = number.filter(|number| *number != 0.0) {
            run.unread.remove(name.as_str());
            run.sim.control.set(*name, number);
        }
    }
    Ok(true)
}

/// The parameters of the list with what stands there, the variant put together from its selections.
fn values(cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Vec<(Name, Option<Value>)> {
    let params = list.args.iter().enumerate().filter_map(|(index, arg)| {
        let value = call.arg(index).and_then(Datum::value);
        match (arg, value) {
            (Arg::Down(name), Some(Value::Number(number))) => Some((*name, Some(Value::Number(-number)))),
            (arg, value) => Some((arg.param()?, value)),
        }
    });
    let composed = list.composed(cycle, |index| call.number(index));
    params.chain(composed.map(|(name, variant)| (name, Some(Value::Number(variant as f64))))).collect()
}

/// What a called program finds in an argument that is omitted.
fn omitted(cycle: &Cycle, name: &str) -> Value {
    let text = cycle.param(name).is_some_and(|param| matches!(param.kind, Kind::Text(_)));
    if text { Value::Text(String::new()) } else { Value::Number(0.0) }
}

/// Carries out a helper cycle, which hands back what went wrong (B:2422-2448, B:8557-8584): values in, results out.
fn helper(run: &mut Interpreter, cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Result<(), Halt> {
    let typed = taken(run, cycle, list, call)?;
    if list.args.iter().any(|arg| matches!(arg, Arg::Variable(_))) {
        // what is wrong with its variables it hands back in them itself
        let inputs = check::read(cycle, &typed, &run.sim.control, &mut Vec::new());
        call::perform(&mut run.sim, &inputs).map_err(Halt::at(call.span))?;
    } else {
        let checked = check::check(cycle, &typed, &run.sim.control);
        cycle::carry_out(run, cycle, checked, call.span)?;
    }
    Ok(hand_back(run, cycle, list, call)?)
}

/// What is in the variables and arguments, by parameter.
fn taken(run: &Interpreter, cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Result<Typed, Problem> {
    let mut typed = Typed::new();
    for (index, arg) in list.args.iter().enumerate() {
        match arg {
            Arg::Variable(array) => {
                let variable = variable(call, index, array)?;
                for (name, rest) in elements(cycle.params.iter().map(|one| one.name.as_str()), array) {
                    typed.insert(name.to_owned(), read_name(run, &format!("{variable}{rest}"), call.span)?.exact());
                }
            }
            Arg::Param(name) => typed.extend(call.arg(index).map(|value| (name.to_string(), value.exact()))),
            _ => {}
        }
    }
    Ok(typed)
}

/// Copies the results into the variables; under the names of the cycle they are gone afterwards.
fn hand_back(run: &mut Interpreter, cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Result<(), Problem> {
    for (index, arg) in list.args.iter().enumerate() {
        let (Arg::Variable(stem) | Arg::Output(stem)) = arg else { continue };
        for (name, rest) in elements(cycle.results.iter().map(|one| one.name), stem) {
            let Some(value) = run.sim.control.data.remove(name) else { continue };
            let variable = format!("{}{rest}", variable(call, index, stem)?);
            write_name(run, &variable, &in_frame(run, rest, Datum::from(&value)), call.span)?;
        }
    }
    Ok(())
}

/// The names that are `stem` or an element of it, with what stands behind the stem.
fn elements(
    names: impl Iterator<Item = &'static str>,
    stem: &str,
) -> impl Iterator<Item = (&'static str, &'static str)> {
    names.filter_map(move |name| {
        let rest = name.strip_prefix(stem)?;
        (rest.is_empty() || rest.starts_with('[')).then_some((name, rest))
    })
}

/// The variable that stands at an argument.
fn variable<'a>(call: &'a Call, index: usize, name: &str) -> Result<&'a str, Problem> {
    call.places.get(index).and_then(Option::as_deref).ok_or_else(|| Problem::new("run-argument", call.span, name))
}

/// A length in the unit in which the program has translations of frames.
fn in_frame(run: &Interpreter, component: &str, value: Datum) -> Datum {
    let control = &run.sim.control;
    match value {
        Datum::Number(length) if component.ends_with(",TR]") => {
            Datum::Number(length * control.active_factor() / control.data_factor())
        }
        value => value,
    }
}
