//! A block that is a motion and nothing else, read when it comes; see [`Program::plain`]. Most of them are driven at
//! once, as nothing but the axes and the feed is concerned.
//!
//! [`Program::plain`]: crate::syntax::Program::plain

use super::{
    Address, Coordinate, Datum, Halt, Interpreter, Motion, Next, Path, Words, action, locals, motion, statement,
    transformed::Axes,
};
use crate::diagnostic::Span;
use crate::syntax::{Plain, plain::Part};

/// Carries out such a block.
pub fn block(run: &mut Interpreter, at: usize, span: Span, plain: &Plain) -> Result<Next, Halt> {
    if moves_alone(run, plain) {
        drive(run, span, plain)?;
        return Ok(Next::Block);
    }
    let mut found = Words::before(at, span);
    for part in plain.parts() {
        let address = address(part);
        if statement::hidden(run, &address.name, part.span) {
            statement::tell_letter(run, &address.name, part.span);
        }
        found.addresses.push(address);
    }
    action::perform(run, found)
}

/// A part as an address word.
pub fn address(part: &Part) -> Address {
    let (name, value) = (char::from(part.letter).to_string(), Datum::Number(part.value));
    Address { name, extension: None, mode: None, value, span: part.span }
}

/// Whether nothing is concerned but the axes and the feed: the position is known, the axes move as they are
/// written, no program is called behind each motion, and no letter but those of the axes is a variable.
fn moves_alone(run: &Interpreter, plain: &Plain) -> bool {
    let variable = |part: &Part| match part.letter {
        b'G' => locals::declared(run, "G"),
        b'F' => locals::declared(run, "F"),
        b'I' => locals::declared(run, "I"),
        b'J' => locals::declared(run, "J"),
        b'K' => locals::declared(run, "K"),
        _ => false,
    };
    let calls = run.levels.last().is_some_and(|level| level.modal.is_some() || level.after_motion.is_some());
    let ordinary = run.modal.axes == Axes::Move && run.modal.drilling.is_none();
    run.unread.is_empty() && !calls && ordinary && !plain.parts().any(variable)
}

fn drive(run: &mut Interpreter, span: Span, plain: &Plain) -> Result<(), Halt> {
    let control = &run.sim.control;
    let (factor, feed_factor) = (control.active_factor(), control.data_factor());
    let mut path = Path { span, ..Path::default() };
    for part in plain.parts() {
        let coordinate = Some(Coordinate { value: part.value * factor, absolute: None, diameter: None });
        let place = match part.letter {
            b'G' => {
                run.modal.motion = function(part.value);
                continue;
            }
            b'F' => {
                (run.modal.feed, run.modal.feed_factor) = (part.value, feed_factor);
                continue;
            }
            centre @ b'I'..=b'K' => path.centre.get_mut(usize::from(centre - b'I')),
            axis => path.axes.get_mut(usize::from(axis.wrapping_sub(b'X'))),
        };
        if let Some(place) = place {
            *place = coordinate;
        }
    }
    if path.moves() { motion::go(run, &path) } else { Ok(()) }
}

/// The motion of G0 to G3.
fn function(code: f64) -> Motion {
    match code {
        0.0 => Motion::Rapid,
        1.0 => Motion::Line,
        2.0 => Motion::Clockwise,
        _ => Motion::Counter,
    }
}
