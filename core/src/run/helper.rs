//! Helper cycles, which compute with variables of the program and hand back what went wrong instead of stopping it
//! (B:2422-2448, B:8557-8584).

use super::datum::Datum;
use super::halt::Halt;
use super::interpret::Interpreter;
use super::statement::Call;
use super::{call, cycle, names};
use crate::check;
use crate::entry::{Arg, ArgumentList, Cycle, Typed};
use crate::problem::Problem;

/// Whether the arguments of a list are variables of the program.
pub fn takes_variables(list: &ArgumentList) -> bool {
    let variable = |arg: &Arg| matches!(arg, Arg::Variable(_) | Arg::Output(_));
    list.args.iter().any(variable)
}

/// Carries out the call: values in, results out.
pub fn call(run: &mut Interpreter, cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Result<(), Halt> {
    if cycle::left_out(run, cycle, call.span) {
        return Ok(());
    }
    let typed = values(run, cycle, list, call)?;
    let inputs = check::read(cycle, &typed, &run.sim.control, &mut Vec::new());
    call::perform(&mut run.sim, &inputs).map_err(Halt::at(call.span))?;
    Ok(hand_back(run, cycle, list, call)?)
}

/// What stands in the variables and arguments, by the name of the parameter. What is wrong with a value is the cycle's
/// affair, which hands its number back.
fn values(run: &Interpreter, cycle: &'static Cycle, list: &ArgumentList, call: &Call) -> Result<Typed, Problem> {
    let mut typed = Typed::new();
    for (index, arg) in list.args.iter().enumerate() {
        match arg {
            Arg::Variable(array) => {
                let variable = variable(call, index, array)?;
                for (name, rest) in elements(cycle.params.iter().map(|one| one.name.as_str()), array) {
                    let value = names::read(run, &format!("{variable}{rest}"), call.span)?;
                    typed.insert(name.to_owned(), value.exact());
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
            let value = Datum::from(&value);
            let variable = format!("{}{rest}", variable(call, index, stem)?);
            names::write(run, &variable, &in_frame(run, rest, value), call.span)?;
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
    let place = call.places.get(index).and_then(Option::as_deref);
    place.ok_or_else(|| Problem::new("run-argument", call.span, name))
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
