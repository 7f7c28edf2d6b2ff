//! What the words of a block do together: functions first, then tool, motion, calls, and the end.

use super::{
    Call, Datum, Halt, Interpreter, Next, Words, addresses, back, cycle, files, frame, gcode, listed, macro_call,
    motion, noted, of_control, of_string, older, repeat, restart, standard, subprogram, swivel, tool, tool_memory,
    transformed, uncomputed, unread,
};
use crate::diagnostic::Span;
use crate::geometry::Degrees;
use crate::machine::{Machine, Step};
use crate::problem::Problem;
use crate::program::of_control::{EXECUTE_TEXT, RESTART, SET_ALARM, STORE_ENVIRONMENT, SWIVEL, is_frame};
use crate::program::standard::{driven, is_standard, is_step};
use crate::program::user_programs::delivered;
use crate::program::words::{hands_back, known, transforms};
use crate::syntax::language::is_word;
use crate::{catalogue, entry};
use std::rc::Rc;

/// Carries out a block whose words were collected.
pub fn perform(run: &mut Interpreter, mut found: Words) -> Result<Next, Halt> {
    let at = found.at;
    let program = Rc::clone(&run.program);
    if let Some(cycle) = measuring_macro(run, &found) {
        if is_foreign(cycle, &found) {
            unread::of_another_control(run, cycle, &found);
            return Ok(Next::Block);
        }
        unread::own(run, program.words_at(at), found.path.span)?;
        gcode::apply(run, &mut found, gcode::beside_macro)?;
        unread::functions(run, &found.addresses);
        gcode::leave(run, &mut found, false);
        cycle::addresses(run, cycle, &found)?;
        return Ok(Next::Block);
    }
    let numbered = run.program.grammar().numbered;
    if numbered && found.function("G", 65.0).is_some() {
        gcode::apply(run, &mut found, gcode::beside_macro)?;
        return Ok(macro_call::with_arguments(run, at, &found)?);
    }
    if numbered && macro_call::modal(run, &found) {
        gcode::apply(run, &mut found, gcode::beside_macro)?;
        return Ok(Next::Block);
    }
    let subprogram = numbered && found.function("M", 98.0).is_some();
    gcode::apply(run, &mut found, |_| true)?;
    transformed::apply(run, &mut found);
    // whoever does not know where it stands does not know either what is in the way
    let unwatched = unread::somewhere(run);
    unread::functions(run, &found.addresses);
    gcode::leave(run, &mut found, true);
    if !found.path.stays {
        unread::placed(run, &found.addresses);
    }
    gcode::settings(run, &mut found);
    tool::apply(run, &found)?;
    for address in &found.addresses {
        match address.name.as_str() {
            "P" if subprogram || !found.calls.is_empty() => {}
            "L" if subprogram => {}
            _ => addresses::take(run, address, &mut found.path)?,
        }
    }
    motion::turn(run, &found.path)?;
    let moves = !frame::applied(run, &found)? && found.path.moves();
    if moves {
        let still = run.sim.still;
        run.sim.still |= unwatched;
        let gone = motion::go(run, &found.path);
        run.sim.still = still;
        gone?;
    }
    for address in &found.positioning {
        motion::position_axis(run, address)?;
    }
    let end = end(run, &found)?;
    if let Some(End::Jump(next)) = end {
        return Ok(next);
    }
    if subprogram {
        return Ok(macro_call::with_variables(run, at, &found)?);
    }
    if end.is_none()
        && let Some(next) = macro_call::after_motion(run, &found)?
    {
        return Ok(next);
    }
    // P of G4, of a drilling cycle and the like is a time
    let passes = if numbered { 1 } else { repeat::passes(found.of("P").next())? };
    let mut calls = subprogram::calls(run, &found)?;
    if moves && found.path.pole.is_none() && calls.is_empty() {
        calls.extend(run.levels.last().and_then(|level| level.modal.clone()));
    }
    for call in &calls {
        if let Some(next) = carry_out(run, at, call, passes)? {
            return match end {
                None => Ok(next),
                Some(_) => Err(Problem::new("run-alone", call.span, &*call.name).into()),
            };
        }
    }
    Ok(match end {
        Some(End::Jump(next)) => next,
        Some(End::Program) => Next::End,
        Some(End::Level(back)) => back::go(run, &back)?,
        None => Next::Block,
    })
}

/// How a block ends its program.
enum End {
    /// By going there (NCT M99).
    Jump(Next),
    /// With the whole run: M2, M30 of NCT.
    Program,
    /// By going back to the call, from the main program with the whole run: M17, RET, in a subprogram also M2 and M30.
    Level(back::Back),
}

/// The NCT macro that a block calls with `G110` or `G65 P9019`; which function calls which, the machine says (C:58).
fn measuring_macro(run: &Interpreter, found: &Words) -> Option<&'static entry::Cycle> {
    if !run.program.grammar().by_address {
        return None;
    }
    if found.function("G", 65.0).is_some() {
        return catalogue::by_program(found.of("P").find_map(|address| address.value.number())?);
    }
    let mut codes = found.of("G").filter_map(|address| address.value.number());
    codes.find_map(|code| run.functions.cycle(code))
}

/// Whether the G function of a macro stands there for something else, that of another control.
fn is_foreign(cycle: &'static entry::Cycle, found: &Words) -> bool {
    let names = found.addresses.iter().map(|address| address.name.as_str());
    found.function("G", 65.0).is_none() && cycle.is_foreign(names)
}

/// M functions that stop, end or turn; the others, and those of another spindle, belong to the machine.
fn end(run: &mut Interpreter, found: &Words) -> Result<Option<End>, Problem> {
    let grammar = run.program.grammar();
    let mut end = found.leaves.clone().map(End::Level);
    for address in found.of("M") {
        let number = address.value.number().unwrap_or(-1.0);
        let other = address.extension.filter(|spindle| *spindle > 1);
        let word = other.map_or_else(|| format!("M{number}"), |spindle| format!("M{spindle}={number}"));
        match number as i64 {
            _ if other.is_some() => machine_function(run, address.span, &word),
            // M1 waits only where the operator wants it
            halt @ (0 | 1) => run.sim.note(Step::Message { text: word, waits: halt == 0 }),
            2 | 30 if grammar.ends_run => end = Some(End::Program),
            2 | 30 | 17 => end = Some(End::Level(back::Back::default())),
            98 if grammar.numbered => {}
            99 if grammar.numbered => {
                return Ok(Some(End::Jump(macro_call::back(run, found, address.span)?)));
            }
            19 => run.sim.orient(Degrees(0.0)),
            3 => run.sim.spin(motion::spindle_speed(run)),
            4 => run.sim.spin(-motion::spindle_speed(run)),
            5 => run.sim.spin(0.0),
            6..=9 => {}
            silent if run.rules().silent.contains(&silent) => {}
            _ => machine_function(run, address.span, &word),
        }
    }
    Ok(end)
}

/// Keeps that a function belongs to the machine.
pub fn machine_function(run: &mut Interpreter, span: Span, word: &str) {
    noted::without(run, "run-machine-function", span, word);
}

/// Calls: operator texts, measuring cycles, subprograms of the same text, standard cycles.
pub fn carry_out(run: &mut Interpreter, at: usize, call: &Call, passes: u32) -> Result<Option<Next>, Halt> {
    let name = call.name.as_str();
    let answers = hands_back(name) && run.programs.named(name).is_none();
    if listed::call(run, call)? || answers && (files::call(run, call)? || tool_memory::call(run, call)?) {
        return Ok(None);
    }
    if name == "MSG" {
        let text = call.arg(0).map(Datum::shown).unwrap_or_default();
        run.sim.note(Step::Message { text, waits: false });
    } else if name == STORE_ENVIRONMENT {
        of_control::store_environment(run, &call.args, call.span)?;
    } else if name == SET_ALARM {
        of_control::raise(run, call)?;
    } else if name == SWIVEL {
        swivel::swivel(run, call)?;
    } else if let Some(cycle) = catalogue::find(run.program.dialect, name) {
        cycle::data(run, cycle, call.span)?;
    } else if let Some(unit) = run.programs.named(name).cloned() {
        return Ok(Some(subprogram::enter(run, at, call, &unit, passes)?));
    } else if older::called(run, name, call.span) {
        // as on the control of that time
    } else if let Some(standard) = driven(name).filter(|standard| standard::has_values(standard, call)) {
        return standard::perform(run, at, standard, call);
    } else if delivered(name) {
        // empty as delivered
    } else if run.programs.external.contains(name) {
        subprogram::not_here(run, name, call.span)?;
    } else if name == EXECUTE_TEXT {
        return of_string::carry_out(run, at, call);
    } else if name == RESTART {
        return Ok(Some(restart::begin_again(run, at, call.span)));
    } else if uncomputed::call(run, call) {
        // told, and what it would have written is not known
    } else if known(name) || is_frame(name) || transforms(name) {
        // done, or nothing to do
    } else if is_standard(name) {
        noted::without(run, "run-standard", call.span, name);
    } else if is_step(name) {
        noted::without(run, "run-step", call.span, name);
    } else if is_word(name) {
        noted::without(run, "run-passed", call.span, name);
    } else {
        subprogram::not_here(run, name, call.span)?;
    }
    Ok(None)
}
