//! Parameters of the program itself, where it is run as main program: nothing calls it, so their values are given, or
//! they have their defaults.

use super::subprogram::{Parameter, parameters};
use super::{Datum, Interpreter, Local, declare, expression};
use crate::control::Value;
use crate::problem::Problem;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The parameters of the main program.
fn own(run: &Interpreter) -> Result<Vec<Parameter>, Problem> {
    let program = Rc::clone(&run.program);
    let words = run.main().map_or(&[][..], |main| program.signature(main));
    if words.is_empty() { Ok(Vec::new()) } else { parameters(run, words) }
}

/// Gives those that have a default its value. What is wrong with one is told where it is read.
pub fn begin(run: &mut Interpreter) {
    for parameter in own(run).unwrap_or_default() {
        let default = parameter.default.and_then(|default| expression::evaluate(run, default).ok());
        if let Some(value) = default {
            _ = give(run, &parameter, &value);
        }
    }
}

/// Gives the values that somebody says.
pub fn bind(run: &mut Interpreter, mut given: BTreeMap<String, Value>) -> Result<(), Problem> {
    if given.is_empty() {
        return Ok(());
    }
    for parameter in own(run)? {
        if let Some(value) = given.remove(&run.program.name(parameter.name)) {
            give(run, &parameter, &Datum::from(&value))?;
        }
    }
    let main = run.main().and_then(|main| run.program.signature(main).first());
    let place = main.map(|word| word.span).unwrap_or_default();
    given.into_keys().next().map_or(Ok(()), |name| Err(Problem::new("run-argument-unknown", place, name)))
}

fn give(run: &mut Interpreter, parameter: &Parameter, value: &Datum) -> Result<(), Problem> {
    let name = run.program.name(parameter.name);
    let variable = declare::variable(run, parameter.name, parameter.kind, &parameter.sizes)?;
    let value = variable.kind.converted(value).filter(|_| variable.sizes.is_empty() && !declare::is_axis(&name));
    let value = value.ok_or_else(|| Problem::new("run-argument", parameter.name, &*name))?;
    let local = Local::Own(super::Variable { values: vec![value], ..variable });
    run.levels.first_mut().map(|main| main.locals.insert(name, local));
    Ok(())
}

/// Makes a parameter of the main program that is written before anything gave it a value; false: it is none.
pub fn make(run: &mut Interpreter, name: &str) -> Result<bool, Problem> {
    let all = if run.levels.len() == 1 { own(run)? } else { Vec::new() };
    let Some(parameter) = all.into_iter().find(|one| run.program.is(one.name, name)) else { return Ok(false) };
    let variable = declare::variable(run, parameter.name, parameter.kind, &parameter.sizes)?;
    if let Some(main) = run.levels.first_mut() {
        main.elements += variable.values.len();
        main.locals.insert(name.to_owned(), Local::Own(variable));
    }
    Ok(true)
}
