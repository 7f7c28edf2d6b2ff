//! Calls of programs of the same text: by name, by a text that names one, or again after each motion (`MCALL`);
//! parameters by value and by reference, passes, `SAVE`, the way back.

use super::{
    Address, Call, Datum, Interpreter, Local, Locals, Modal, Next, Variable, Words, declare, declare::Declaring,
    expression, limits, locals, names, noted, repeat, repeat::Repetition,
};
use crate::control::{Frame, Plane, Transverse, Units};
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::language::{BY_PATH, CALL, FROM_OUTSIDE, MODAL};
use crate::syntax::programs::{Unit, bare};
use crate::syntax::tree::{Expr, ExprId, Word, WordKind};
use std::ops::Range;
use std::rc::Rc;

/// A program that is being carried out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Variables and parameters of the program.
    pub locals: Locals,
    /// How many values they hold together.
    pub elements: usize,
    /// Which parameters the call gives (`$P_SUBPAR[1]`).
    pub given: Vec<bool>,
    pub blocks: Range<usize>,
    /// Block of the call.
    pub call: usize,
    /// Passes that are still to come (`P3`).
    pub left: u32,
    /// Program parts that are being repeated (`REPEAT LABEL`), innermost last.
    pub repeats: Vec<Repetition>,
    /// Where its variables come from.
    pub variables: Variables,
    /// What is called after each block that moves (`MCALL`).
    pub modal: Option<Call>,
    /// NCT: the macro that is called after each block that moves (`G66 P4000 A10`), by its addresses.
    pub after_motion: Option<Vec<Address>>,
    /// Whether the block of the call goes on where it was left: the modal program of a pattern of holes.
    pub again: bool,
    /// What `SAVE` brings back at the end.
    pub saved: Option<Box<Saved>>,
}

/// Where the variables of a program come from.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Variables {
    #[default]
    Own,
    /// NCT `M98`: from the caller, which gets them back.
    Caller,
    /// NCT `G65`: each pass begins with these.
    Arguments(Locals),
}

/// Modal functions and programmed frame at the time of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    modal: Modal,
    plane: Plane,
    units: (Units, bool),
    frame: Frame,
    transverse: Transverse,
}

/// Whether one more level fits.
pub fn room(run: &Interpreter, place: Span) -> Result<(), Problem> {
    let repeats: usize = run.levels.iter().map(|level| level.repeats.len()).sum();
    if run.levels.len() + repeats <= run.limits.depth {
        return Ok(());
    }
    Err(Problem::at("run-depth", place).number("limit", run.limits.depth as f64))
}

/// What is active now.
fn save(run: &Interpreter) -> Saved {
    let control = &run.sim.control;
    Saved {
        modal: run.modal,
        plane: control.plane,
        units: (control.active_units, control.data_follow),
        frame: control.program_frame,
        transverse: control.transverse,
    }
}

/// Brings back what was active at the call; the tool stays as it is.
fn restore(run: &mut Interpreter, saved: Saved) {
    let Modal { prepared, waiting_edge, .. } = run.modal;
    run.modal = Modal { prepared, waiting_edge, ..saved.modal };
    run.sim.with_length(|control| control.plane = saved.plane);
    (run.sim.control.active_units, run.sim.control.data_follow) = saved.units;
    run.sim.control.program_frame = saved.frame;
    run.sim.control.transverse = saved.transverse;
}

/// The calls of a block that are carried out now.
pub fn calls(run: &mut Interpreter, found: &Words) -> Result<Vec<Call>, Problem> {
    let [first, rest @ ..] = &found.calls[..] else { return Ok(Vec::new()) };
    match first.name.as_str() {
        // a part of another program, from one label to another
        CALL if rest.iter().any(|word| word.name == "BLOCK") => {
            noted::without(run, "run-passed", first.span, "CALL … BLOCK");
            Ok(Vec::new())
        }
        CALL | FROM_OUTSIDE => Ok(vec![named_by_text(run, first, rest)?]),
        BY_PATH => Ok(rest.to_vec()),
        MODAL => {
            if let Some(level) = run.levels.last_mut() {
                level.modal = rest.first().cloned();
            }
            Ok(Vec::new())
        }
        _ => Ok(found.calls.clone()),
    }
}

/// `CALL "NAME"`, `CALL VARIABLE`, `EXTCALL("NAME")`: the program that the text names.
fn named_by_text(run: &Interpreter, call: &Call, rest: &[Call]) -> Result<Call, Problem> {
    let text = match (&call.args[..], rest) {
        ([Some(text)], []) => text.clone(),
        ([], [variable]) => names::read(run, &variable.name, variable.span)?,
        _ => return Err(Problem::new("run-function", call.span, &*call.name)),
    };
    Ok(Call::named(text.shown().to_ascii_uppercase(), call.span))
}

/// Begins a program: its parameters, its level.
pub fn enter(run: &mut Interpreter, at: usize, call: &Call, unit: &Unit, passes: u32) -> Result<Next, Problem> {
    if passes == 0 {
        return Ok(Next::Block);
    }
    room(run, call.span)?;
    let program = Rc::clone(&run.program);
    let words = program.signature(unit);
    let parameters = parameters(run, words)?;
    if call.args.len() > parameters.len() {
        return Err(Problem::new("run-arguments", call.span, &*call.name));
    }
    let saved = words.iter().any(|word| program.is_call(word, &["SAVE"])).then(|| Box::new(save(run)));
    let (mut bound, mut elements) = (Locals::new(), 0);
    for (i, parameter) in parameters.iter().enumerate() {
        let local = bind(run, parameter, call, i)?;
        let name = run.program.name(parameter.name);
        if declare::is_axis(&name) {
            return Err(Problem::new("run-axis-name", parameter.name, name));
        }
        elements += local.own().map_or(0, |variable| variable.values.len());
        limits::elements(run, elements, call.span)?;
        bound.insert(name, local);
    }
    let given = (0..parameters.len()).map(|i| call.arg(i).is_some()).collect();
    let (locals, blocks, left) = (bound, unit.blocks.clone(), passes - 1);
    run.sim.files.begin(unit.file.as_deref());
    run.levels.push(Level { locals, elements, given, blocks, call: at, left, saved, ..Level::default() });
    Ok(Next::Jump(unit.blocks.start))
}

/// Ends a pass of the present program: its next one, or the block behind the call; the main program ends the run.
pub fn leave(run: &mut Interpreter) -> Next {
    if run.levels.len() <= 1 {
        return Next::End;
    }
    if let Some(level) = run.levels.last_mut().filter(|level| level.left > 0) {
        level.left -= 1;
        level.repeats.clear();
        if let Variables::Arguments(arguments) = &level.variables {
            level.locals = arguments.clone();
        }
        return Next::Jump(level.blocks.start);
    }
    let Some(level) = close(run) else { return Next::End };
    goes_on(run, &level)
}

/// Where the caller goes on behind a program that has ended.
pub fn goes_on(run: &mut Interpreter, level: &Level) -> Next {
    Next::Jump(if level.again { level.call } else { repeat::after(run, level.call) })
}

/// Ends the present program, whatever passes are to come; what it saved is active again.
pub fn close(run: &mut Interpreter) -> Option<Level> {
    let mut level = run.levels.pop()?;
    run.sim.files.end();
    if let Some(saved) = level.saved.take() {
        restore(run, *saved);
    }
    if let (Variables::Caller, Some(caller)) = (&level.variables, run.levels.last_mut()) {
        caller.locals = std::mem::take(&mut level.locals);
    }
    Some(level)
}

/// A parameter of a `PROC`.
pub struct Parameter {
    pub name: Span,
    pub kind: super::datum::Type,
    by_reference: bool,
    pub sizes: Box<[ExprId]>,
    pub default: Option<ExprId>,
}

/// The parameters that a `PROC` declares; the first name is that of the program.
pub fn parameters(run: &Interpreter, words: &[Word]) -> Result<Vec<Parameter>, Problem> {
    let (mut found, mut declaring) = (Vec::new(), Declaring::default());
    let (mut by_reference, mut named) = (false, false);
    for word in words {
        match &word.kind {
            WordKind::Keyword { name, value } => {
                by_reference |= run.program.is(*name, "VAR");
                declaring.take(run, &run.program.name(*name), *value)?;
            }
            WordKind::Declare { .. } if !named => named = true,
            WordKind::Declare { name, index, value } => {
                let missing = || Problem::new("run-type", *name, run.program.name(*name));
                found.push(Parameter {
                    name: *name,
                    kind: declaring.kind.take().ok_or_else(missing)?,
                    by_reference: std::mem::take(&mut by_reference),
                    sizes: index.clone(),
                    default: *value,
                });
            }
            _ => {}
        }
    }
    Ok(found)
}

/// What a parameter is in the called program.
fn bind(run: &mut Interpreter, parameter: &Parameter, call: &Call, i: usize) -> Result<Local, Problem> {
    let argument = call.arg(i);
    let place = call.places.get(i).and_then(Option::as_ref);
    let name = run.program.name(parameter.name);
    if parameter.by_reference && argument.is_some() {
        let place = place.ok_or_else(|| Problem::new("run-argument", call.span, name))?;
        return Ok(Local::Other(locals::home(run, place)));
    }
    let mut variable = sized(run, parameter, place)?;
    let kind = variable.kind;
    let refused = || Problem::new("run-argument", call.span, run.program.name(parameter.name));
    match argument {
        Some(Datum::List(items)) if items.len() == variable.values.len() => {
            let items = items.iter().map(|item| kind.converted(item.as_ref()?));
            variable.values = items.collect::<Option<_>>().ok_or_else(refused)?;
        }
        Some(value) => variable.values = vec![kind.converted(value).ok_or_else(refused)?],
        None => {
            if let Some(default) = parameter.default {
                variable.values = vec![kind.converted(&expression::evaluate(run, default)?).ok_or_else(refused)?];
            }
        }
    }
    if variable.values.len() != variable.sizes.iter().product::<usize>() {
        return Err(refused());
    }
    Ok(Local::Own(variable))
}

/// A variable of the parameter's sizes; an array that names none (`REAL F[,]`) has those of its argument.
fn sized(run: &mut Interpreter, parameter: &Parameter, place: Option<&String>) -> Result<Variable, Problem> {
    if !parameter.sizes.iter().any(|size| matches!(run.program.expr(*size), Some(Expr::Omitted))) {
        return declare::variable(run, parameter.name, parameter.kind, &parameter.sizes);
    }
    let sizes = place.and_then(|place| locals::sizes(run, &locals::home(run, place))).unwrap_or_default();
    Ok(Variable::new(parameter.kind, sizes, parameter.name))
}

/// A program is called that is not there: the run goes on without it, which is told at the first call, or stops.
pub fn not_here(run: &mut Interpreter, name: &str, span: Span) -> Result<(), Problem> {
    let name = bare(name);
    let problem = Problem::new("run-subprogram", span, name);
    if run.limits.strict {
        return Err(problem);
    }
    if !run.passed.iter().any(|passed| passed.word == name) {
        run.tell(Severity::Note, &problem);
    }
    Ok(())
}
