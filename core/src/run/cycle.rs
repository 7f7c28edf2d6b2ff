//! A measuring call of a program: values as written in data or addresses, checked like typed ones, then carried out.

use super::halt::Halt;
use super::interpret::Interpreter;
use super::statement::Words;
use super::{call, contour, unread, user_program};
use crate::check::{Checked, upkeep};
use crate::control::Value;
use crate::diagnostic::{Code, Diagnostic, Severity, Span};
use crate::entry::{Cycle, Kind, ProbeUse, Typed};
use crate::machine::Machine;
use crate::problem::Problem;
use crate::program::user_programs::{BEFORE, BEHIND};
use crate::{check, own};

/// SINUMERIK: the parameters are user data and keep their values from call to call (B:1696).
pub fn data(run: &mut Interpreter, cycle: &'static Cycle, span: Span) -> Result<(), Halt> {
    let mut typed = Typed::new();
    for param in cycle.params {
        let text = match run.sim.control.data.get(param.name.as_str()) {
            Some(Value::Number(value)) if !matches!(param.kind, Kind::Text(_)) => format!("{value}"),
            Some(Value::Text(text)) if !text.is_empty() => check::typed_text(text),
            _ => continue,
        };
        typed.insert(param.name.to_string(), text);
    }
    unread::takes(run, cycle, &typed, span)?;
    run.fit(cycle, &typed);
    carry_out(run, cycle, with_zeros(run, cycle, typed), span)
}

/// A required datum that was never written holds 0 on the control, and the cycle takes that or raises its alarm. That
/// it is missing is told beside.
fn with_zeros(run: &Interpreter, cycle: &'static Cycle, mut typed: Typed) -> Checked {
    let mut missing: Vec<Diagnostic> = Vec::new();
    loop {
        let mut checked = check::check(cycle, &typed, &run.sim.control);
        let never = |one: &&Diagnostic| one.message.key == own::MISSING.cause;
        let found: Vec<Diagnostic> = checked.diagnostics.iter().filter(never).cloned().collect();
        let names = found.iter().filter_map(|one| cycle.param(&one.param?));
        let zeros: Vec<_> =
            names.filter(|param| !matches!(param.kind, Kind::Text(_))).map(|param| param.name).collect();
        if zeros.is_empty() {
            checked.diagnostics.splice(0..0, missing);
            return checked;
        }
        typed.extend(zeros.into_iter().map(|name| (name.to_string(), "0".to_owned())));
        missing.extend(found.into_iter().map(|one| one.under(own::MISSING.code())));
    }
}

/// NCT: every address of the block is an argument.
pub fn addresses(run: &mut Interpreter, cycle: &'static Cycle, found: &Words) -> Result<(), Halt> {
    let mut typed = Typed::new();
    let by_number = found.function("G", 65.0).is_some();
    for address in &found.addresses {
        let name = address.name.as_str();
        if matches!(name, "G" | "N" | "O") || (by_number && name == "P") {
            continue;
        }
        match (cycle.params.iter().find(|param| param.name == name), address.value.number()) {
            (Some(_), Some(value)) => drop(typed.insert(name.to_owned(), format!("{value}"))),
            _ => run.tell(Severity::Error, &Problem::new("run-unknown-word", address.span, name)),
        }
    }
    run.sim.control.incremental = !run.modal.absolute;
    checked(run, cycle, &typed, found.path.span)
}

/// Whether a call is left out, which is told: logging is not simulated, and a run goes on without it.
pub fn left_out(run: &mut Interpreter, cycle: &'static Cycle, span: Span) -> bool {
    let log = cycle.purpose.probe == ProbeUse::Log && cycle.work().is_none();
    if log {
        run.tell(Severity::Warning, &Problem::new("run-log", span, cycle.name));
    }
    log
}

/// Counts how often a call is carried out where it is written; a program that does so again and again may never end.
fn count(run: &mut Interpreter, span: Span) -> Result<(), Halt> {
    let called = run.levels.last().map_or(0, |level| level.call);
    let count = run.calls.entry((called, run.at)).or_default();
    *count += 1;
    if *count <= run.limits.calls {
        return Ok(());
    }
    let limit = run.limits.calls as f64;
    Err(Problem::at("run-repeated", span).number("limit", limit).into())
}

/// The alarm of the first error stops the program, as on the control; other errors are a fault.
pub fn checked(run: &mut Interpreter, cycle: &'static Cycle, typed: &Typed, span: Span) -> Result<(), Halt> {
    run.fit(cycle, typed);
    let checked = check::check(cycle, typed, &run.sim.control);
    carry_out(run, cycle, checked, span)
}

/// What a check left of a call.
pub fn carry_out(run: &mut Interpreter, cycle: &'static Cycle, checked: Checked, span: Span) -> Result<(), Halt> {
    unread::measures(run, span)?;
    let errors: Vec<_> = checked.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    let code = errors.iter().map(|found| found.code).find(|code| !matches!(code, Code::Own(_)));
    for mut diagnostic in checked.diagnostics.iter().cloned() {
        diagnostic.span = diagnostic.span.or(Some(span));
        let known = run
            .diagnostics
            .iter()
            .any(|old| (old.span, old.param, &old.message) == (diagnostic.span, diagnostic.param, &diagnostic.message));
        if !known && run.diagnostics.len() < 1000 {
            run.diagnostics.push(diagnostic);
        }
    }
    if let Some(inputs) = &checked.inputs {
        if left_out(run, cycle, span) {
            return Ok(());
        }
        contour::leave(run)?;
        count(run, span)?;
        user_program::around(run, &BEFORE, cycle, span)?;
        run.put_part(inputs);
        call::perform(&mut run.sim, inputs).map_err(Halt::at(span))?;
        return user_program::around(run, &BEHIND, cycle, span);
    }
    match code {
        Some(code) => {
            upkeep::perform(&mut run.sim, cycle);
            leave_number(run, cycle, code);
            call::alarm(&mut run.sim, code).map_err(Halt::at(span))
        }
        None if errors.is_empty() => {
            // a list of a newer control of which not everything is known
            Err(Problem::new("run-no-simulation", span, cycle.name).into())
        }
        None => Err(Problem::new("run-call", span, cycle.name).into()),
    }
}

/// The number of the alarm is a result of the cycle also where it refuses what it was given (B:5699).
fn leave_number(run: &mut Interpreter, cycle: &'static Cycle, code: Code) {
    if let (Some(result), Code::Alarm(number)) = (cycle.alarm_result(), code) {
        run.sim.write(result.name, f64::from(number));
    }
}
