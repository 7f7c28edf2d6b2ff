//! What an NCT control tells its programs, and takes from them, by numbers from #3000: #3001 by C:90, signal positions
//! and length offset by N 183, the others as on controls with this macro language.

use super::{Datum, FeedType, Interpreter, macro_variables::local, unread::Unread};
use crate::control::{AXES, Control, NCT, Units};
use crate::diagnostic::Span;
use crate::machine::{Machine, Step};
use crate::problem::Problem;
use crate::program::nct_functions::is_open;

/// Stops with an alarm of the program, whose text is the comment of the block.
const ALARM: u32 = 3000;
/// Internal clock, ms (C:90). A block takes one of them here.
const CLOCK: u32 = 3001;
/// Hours for which programs have run.
const HOURS: u32 = 3002;
/// Whether single blocks halt, feed hold, override and exact stop count: an operator's affair, without effect here.
const OPERATING: std::ops::RangeInclusive<u32> = 3003..=3004;
/// Milliseconds of an hour.
const HOUR: f64 = 3_600_000.0;
/// Stops until START and shows the comment of the block.
const STOP: u32 = 3006;
/// First axis of the common work offset; those of G54 to G59 follow, 20 numbers apart.
const OFFSETS: u32 = 5201;
/// Numbers from one work offset to the next.
const APART: u32 = 20;

/// Whether a number belongs here.
pub fn is(run: &Interpreter, number: u32) -> bool {
    [ALARM, CLOCK, HOURS, STOP].contains(&number)
        || OPERATING.contains(&number)
        || modal(run, number).is_some()
        || position(number).is_some()
        || offset(number).is_some()
}

/// Value of a number: lengths in the active unit, angles and codes as they are.
pub fn read(run: &Interpreter, number: u32) -> Datum {
    let control = &run.sim.control;
    if [CLOCK, HOURS].contains(&number) {
        run.clock_asked.set(true);
    }
    let value = match number {
        CLOCK => Some(run.work as f64 - run.clocks[0]),
        HOURS => Some((run.work as f64 - run.clocks[1]) / HOUR),
        _ if OPERATING.contains(&number) => Some(control.number(&local(number))),
        _ => modal(run, number)
            .or_else(|| stands(run, number))
            .or_else(|| Some(control.variable(&offset(number)?.1)? / control.active_factor())),
    };
    value.map_or(Datum::Vacant, Datum::Number)
}

pub fn write(run: &mut Interpreter, number: u32, value: f64, place: Span) -> Result<(), Problem> {
    match (number, offset(number)) {
        (ALARM, _) => {
            return Err(Problem::at("run-set-alarm", place).number("number", value).text("text", comment(run)));
        }
        (STOP, _) => run.sim.note(Step::Message { text: comment(run), waits: true }),
        (CLOCK, _) => run.clocks[0] = run.work as f64 - value,
        (HOURS, _) => run.clocks[1] = run.work as f64 - value * HOUR,
        _ if OPERATING.contains(&number) => run.sim.control.set(local(number), value),
        (_, Some((system, name))) => {
            run.sim.write_correction(name, value * run.sim.control.active_factor());
            run.sim.control.offset_written(system);
        }
        _ => return Err(Problem::new("run-read-only", place, local(number))),
    }
    Ok(())
}

/// The comment of the present block without its parentheses.
fn comment(run: &Interpreter) -> String {
    let block = run.program.blocks.get(run.at);
    let span = block.and_then(|block| block.comment).unwrap_or_default();
    run.program.written(span).trim_matches(['(', ')']).trim().to_owned()
}

/// Active G functions by group, and the last D, F, H, S and T.
fn modal(run: &Interpreter, number: u32) -> Option<f64> {
    let (control, modal) = (&run.sim.control, &run.modal);
    Some(match number {
        4001 => f64::from(modal.motion as u8),
        4002 => f64::from(control.plane.code()),
        4003 => one_of(modal.absolute, 90.0, 91.0),
        4005 if modal.feed_type == FeedType::Inverse => 93.0,
        4005 => one_of(modal.feed_type == FeedType::Minute, 94.0, 95.0),
        4006 => one_of(control.active_units == Units::Inch, 20.0, 21.0),
        4007 => f64::from(40 + modal.compensation as u8),
        4008 => one_of(control.active_edge().is_some(), 43.0, 49.0),
        4014 => 53.0 + control.settable.max(1) as f64,
        4107 => modal.radius as f64,
        4109 => modal.feed,
        4111 => control.edge as f64,
        4119 => modal.speed,
        4120 => modal.prepared.unwrap_or(control.tool) as f64,
        _ => return None,
    })
}

fn one_of(first: bool, yes: f64, no: f64) -> f64 {
    if first { yes } else { no }
}

/// Which of the words that a program left unread decides over the value of a number.
pub fn left_open(unread: &Unread, number: u32) -> Option<&Span> {
    let function = |name: &str| unread.iter().find(|(open, _)| open.as_str() == name).map(|(_, span)| span);
    match position(number) {
        Some((5080, _)) => function("G10"),
        Some((group, axis)) => {
            let frame = || unread.iter().find(|(name, _)| is_open(name)).map(|(_, span)| span);
            unread.get(AXES[axis]).or_else(|| frame().filter(|_| group != 5020))
        }
        None if offset(number).is_some() => function("G10"),
        None if number == 4014 => function("G54.1"),
        None => None,
    }
}

/// A group of positions and the axis in it.
fn position(number: u32) -> Option<(u32, usize)> {
    let axis = (number % APART).checked_sub(1)? as usize;
    let group = number - number % APART;
    (axis < 3 && matches!(group, 5000 | 5020 | 5040 | 5060 | 5080)).then_some((group, axis))
}

/// #5001: tool tip in the work offset at the end of the last block; #5041: the spindle nose there, #5021: in machine
/// coordinates; #5061: tool tip at the last signal or the end of a measuring motion without (N 183); #5081: length.
fn stands(run: &Interpreter, number: u32) -> Option<f64> {
    let (group, axis) = position(number)?;
    let control: &Control = &run.sim.control;
    let (at, length) = (run.sim.position, control.active_length());
    let value = match group {
        5000 => control.to_workpiece(at)[axis],
        5020 => at[axis] + length[axis],
        5060 => run.sim.skipped?[axis],
        5040 => control.to_workpiece(at)[axis] + length[axis],
        _ => length[axis],
    };
    Some(value / control.active_factor())
}

/// A work offset (0 common, 1 to 6) and the name of its component.
fn offset(number: u32) -> Option<(usize, String)> {
    let way = number.checked_sub(OFFSETS)?;
    let (system, axis) = ((way / APART) as usize, (way % APART) as usize);
    let axis = ["X", "Y", "Z"].get(axis)?;
    (system <= 6).then(|| (system, format!("{} {axis}", NCT.settable_name(system))))
}
