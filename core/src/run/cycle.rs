//! A measuring call of a program: values as written in data or addresses, checked like typed ones, then carried out.

use super::called::{self, Called};
use super::{Call, Halt, Interpreter, Words, call, contour, interpret, logged, mode, subprogram, unread};
use crate::catalogue::log;
use crate::check::{Checked, upkeep};
use crate::control::Value;
use crate::diagnostic::{Code, Diagnostic, Severity, Span};
use crate::entry::{Cycle, Inputs, Kind, Typed};
use crate::machine::Machine;
use crate::problem::Problem;
use crate::program::user_programs::{BEFORE, BEHIND, UserProgram, label};
use crate::syntax::programs::Unit;
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

/// A required datum that was never written is told and holds 0, and the cycle takes that or raises its alarm.
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
    run.fit(cycle, &typed);
    carry_out(run, cycle, check::check(cycle, &typed, &run.sim.control), found.path.span)
}

/// Counts how often a call is carried out where it is written; a program that does so again and again may never end.
fn count(run: &mut Interpreter, span: Span) -> Result<(), Problem> {
    let called = run.levels.last().map_or(0, |level| level.call);
    let count = run.calls.entry((called, run.at)).or_default();
    *count += 1;
    if *count <= run.limits.calls {
        return Ok(());
    }
    Err(Problem::at("run-repeated", span).number("limit", run.limits.calls as f64))
}

/// Carries out what a check left: the alarm of the first error stops the program as on the control, others are a fault.
pub fn carry_out(run: &mut Interpreter, cycle: &'static Cycle, checked: Checked, span: Span) -> Result<(), Halt> {
    if mode::skips(run, cycle, span) {
        return Ok(());
    }
    unread::measures(run, span)?;
    let errors = checked.diagnostics.iter().filter(|found| found.severity == Severity::Error);
    let code = errors.clone().map(|found| found.code).find(|code| !matches!(code, Code::Own(_)));
    let errors = errors.count();
    for mut found in checked.diagnostics {
        found.span = found.span.or(Some(span));
        let said =
            |one: &Diagnostic| (one.span, one.param) == (found.span, found.param) && one.message == found.message;
        if !run.diagnostics.iter().any(said) && run.diagnostics.len() < 1000 {
            run.diagnostics.push(found);
        }
    }
    if let Some(inputs) = &checked.inputs {
        contour::leave(run)?;
        count(run, span)?;
        around(run, &BEFORE, cycle, span)?;
        run.put_part(inputs);
        keep(run, inputs.clone());
        let logging = run.sim.control.bit(log::ON);
        let from = run.sim.trace.entries.len();
        call::perform(&mut run.sim, inputs).map_err(Halt::at(span))?;
        if upkeep::shows(&run.sim.control, cycle) {
            called::show(&mut run.called, &run.sim.control);
        }
        logged::called(run, inputs, span, from, logging);
        return around(run, &BEHIND, cycle, span);
    }
    match code {
        Some(code) => {
            keep(run, Inputs::new(cycle, i64::MIN));
            upkeep::perform(&mut run.sim, cycle);
            // its number is a result of the cycle also where that refuses what it was given (B:5699)
            if let (Some(result), Code::Alarm(number)) = (cycle.alarm_result(), code) {
                run.sim.write(result.name, f64::from(number));
            }
            run.known_alarm(span);
            call::alarm(&mut run.sim, code).map_err(Halt::at(span))
        }
        // a list of a newer control of which not everything is known
        None if errors == 0 => Err(Problem::new("run-no-simulation", span, cycle.name).into()),
        None => Err(Problem::new("run-call", span, cycle.name).into()),
    }
}

/// Keeps a measuring call that begins now.
fn keep(run: &mut Interpreter, inputs: Inputs) {
    if called::measures(inputs.cycle) {
        let (at, control) = (run.sim.trace.entries.len(), &run.sim.control);
        let (units, basic) = (control.active_units, control.basic_units);
        run.called.push(Called { at, inputs, units, basic, log: None, shown: Vec::new() });
    }
}

/// Runs the user's program of this text around a call of this cycle, where there is one (B:2476-2530), to its end: from
/// the label of the cycle (`_M977`), else from its first block. It does not call itself. As delivered it is empty.
fn around(run: &mut Interpreter, program: &UserProgram, cycle: &Cycle, span: Span) -> Result<(), Halt> {
    let measures = cycle.is_measuring_cycle();
    let unit = run.programs.named(program.name).filter(|_| measures);
    let Some(unit) = unit.cloned() else { return Ok(()) };
    if run.levels.iter().any(|level| level.blocks == unit.blocks) {
        return Ok(());
    }
    let (back, depth) = (run.at, run.levels.len());
    subprogram::enter(run, back, &Call::named(program.name, span), &unit, 1)?;
    run.at = start(run, &unit, cycle);
    while run.levels.len() > depth {
        interpret::one_block(run)?;
    }
    run.at = back;
    run.sim.line = Some(back as u32);
    Ok(())
}

/// The block with the label of the cycle, else the first one.
fn start(run: &Interpreter, unit: &Unit, cycle: &Cycle) -> usize {
    let blocks = run.targets().blocks(&label(cycle));
    blocks.into_iter().find(|block| unit.blocks.contains(block)).unwrap_or(unit.blocks.start)
}
