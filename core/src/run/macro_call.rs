//! Calls of programs on NCT: `M98 P110 L2`, `G65 P9110 A1. B2.` with arguments, and the way back, `M99`.

use super::macro_variables::{holding, local};
use super::{
    Address, Call, Datum, Halt, Interpreter, Locals, Next, Words, branch, cycle, repeat, subprogram,
    subprogram::Variables,
};
use crate::catalogue;
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::programs;

/// The addresses of `G65`, each at the place whose number, counted from 1, is that of the local variable it fills.
const ARGUMENTS: &str = "ABCIJKDEF-H-M---QRSTUVWXYZ";

/// Last local variable.
const LAST: u32 = 33;

/// `G65 P…`: a program of the text with variables of its own, filled from the addresses of the block.
pub fn with_arguments(run: &mut Interpreter, at: usize, found: &Words) -> Result<Next, Problem> {
    let arguments = arguments(run, found)?;
    let next = call(run, at, found)?;
    if let (Next::Jump(_), Some(level)) = (next, run.levels.last_mut()) {
        level.locals = arguments.clone();
        level.variables = Variables::Arguments(arguments);
    }
    Ok(next)
}

/// `G66 P…` is called after each block that moves up to `G67`, in the program that contains it.
pub fn modal(run: &mut Interpreter, found: &Words) -> bool {
    let begins = found.function("G", 66.0).is_some();
    let ends = found.function("G", 67.0).is_some();
    if let Some(level) = run.levels.last_mut().filter(|_| begins || ends) {
        let called = |address: &Address| match address.name.as_str() {
            "G" if address.value.number() == Some(66.0) => {
                Some(Address { value: Datum::Number(65.0), ..address.clone() })
            }
            "G" => None,
            _ => Some(address.clone()),
        };
        level.after_motion = begins.then(|| found.addresses.iter().filter_map(called).collect());
    }
    begins
}

/// Calls what `G66` named, where the block has moved; none: nothing is called.
pub fn after_motion(run: &mut Interpreter, found: &Words) -> Result<Option<Next>, Halt> {
    if !(found.path.moves() || found.path.elsewhere) {
        return Ok(None);
    }
    let Some(addresses) = run.levels.last().and_then(|level| level.after_motion.clone()) else { return Ok(None) };
    let mut call = Words::before(found.at, found.path.span);
    call.addresses = addresses;
    let number = call.of("P").last().and_then(|address| address.value.number());
    match number.and_then(catalogue::by_program) {
        Some(cycle) => cycle::addresses(run, cycle, &call).map(|()| None),
        None => Ok(Some(with_arguments(run, call.at, &call)?)),
    }
}

/// `M98 P…`: a program of the text that works with the variables of its caller.
pub fn with_variables(run: &mut Interpreter, at: usize, found: &Words) -> Result<Next, Problem> {
    let next = call(run, at, found)?;
    if let (Next::Jump(_), [.., caller, called]) = (next, &mut run.levels[..]) {
        called.variables = Variables::Caller;
        called.locals = std::mem::take(&mut caller.locals);
    }
    Ok(next)
}

/// Begins the program at P, L times; one that is not in the text is left out, which is told.
fn call(run: &mut Interpreter, at: usize, found: &Words) -> Result<Next, Problem> {
    let passes = repeat::passes(found.of("L").last())?;
    let Some(address) = found.of("P").last() else { return Err(Problem::new("run-no-program", found.path.span, "P")) };
    let name = address.value.number().and_then(programs::numbered);
    let unit = name.as_ref().and_then(|name| run.programs.named(name));
    let Some(unit) = unit.cloned() else {
        let name = name.unwrap_or_else(|| format!("P{}", address.value.shown()));
        subprogram::not_here(run, &name, address.span)?;
        return Ok(Next::Block);
    };
    subprogram::enter(run, at, &Call::named(name.unwrap_or_default(), address.span), &unit, passes)
}

/// The local variables that the addresses of a block fill; I, J and K that come again fill the next three.
fn arguments(run: &mut Interpreter, found: &Words) -> Result<Locals, Problem> {
    let mut locals = Locals::new();
    for address in &found.addresses {
        let name = address.name.as_str();
        if matches!(name, "G" | "N" | "O" | "P" | "L") {
            continue;
        }
        let Some(first) = ARGUMENTS.find(name).filter(|_| name.len() == 1) else {
            run.tell(Severity::Error, &Problem::new("run-unknown-word", address.span, name));
            continue;
        };
        let number = super::addresses::number(address)?;
        let mut place = first as u32 + 1;
        while matches!(name, "I" | "J" | "K") && locals.contains_key(&local(place)) {
            place += 3;
        }
        if place > LAST {
            return Err(Problem::new("run-arguments", address.span, "G65"));
        }
        locals.insert(local(place), holding(number, address.span));
    }
    Ok(locals)
}

/// `M99`: back to the caller, with P to that block of it. The main program begins anew.
pub fn back(run: &mut Interpreter, found: &Words, span: Span) -> Result<Next, Problem> {
    let target = found.of("P").last();
    let main = run.levels.len() <= 1;
    if let Some(level) = run.levels.last_mut().filter(|_| target.is_some()) {
        level.left = 0;
    }
    let next = match (main, run.levels.first()) {
        (true, Some(level)) => Next::Jump(level.blocks.start),
        _ => subprogram::leave(run),
    };
    let Some(address) = target else { return Ok(next) };
    let label = format!("N{}", address.value.shown());
    let block = branch::places(run, &label).first().copied();
    block.map(Next::Jump).ok_or_else(|| Problem::new("run-label", span, label))
}
