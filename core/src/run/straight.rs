//! A block that is a straight motion and nothing else, read when it comes; see [`Program::straight`]. Most of them are
//! driven at once, as nothing but the axes and the feed is concerned.
//!
//! [`Program::straight`]: crate::syntax::Program::straight

use super::{
    Address, Coordinate, Datum, Halt, Interpreter, Motion, Next, Path, Words, action, locals, motion, names, statement,
    transformed::Axes,
};
use crate::diagnostic::Span;
use crate::syntax::{Straight, straight::Part};

/// Carries out such a block.
pub fn block(run: &mut Interpreter, at: usize, span: Span, straight: &Straight) -> Result<Next, Halt> {
    if moves_alone(run, straight) {
        drive(run, span, straight)?;
        return Ok(Next::Block);
    }
    let mut found = Words::before(at, span);
    for part in straight.parts() {
        let address = address(part);
        if statement::hidden(run, &address.name, part.span) {
            names::write(run, &address.name, &address.value, part.span)?;
        } else {
            found.addresses.push(address);
        }
    }
    action::perform(run, found)
}

/// A part as an address word.
pub fn address(part: &Part) -> Address {
    let (name, value) = (char::from(part.letter).to_string(), Datum::Number(part.value));
    Address { name, extension: None, mode: None, value, span: part.span }
}

/// Whether nothing is concerned but the axes and the feed: the position is known, the axes move as they are
/// written, no program is called behind each motion, and G and F are no variables.
fn moves_alone(run: &Interpreter, straight: &Straight) -> bool {
    let variable = |part: &Part| match part.letter {
        b'G' => locals::declared(run, "G"),
        b'F' => locals::declared(run, "F"),
        _ => false,
    };
    let calls = run.levels.last().is_some_and(|level| level.modal.is_some());
    run.unread.is_empty() && !calls && run.modal.axes == Axes::Move && !straight.parts().any(variable)
}

fn drive(run: &mut Interpreter, span: Span, straight: &Straight) -> Result<(), Halt> {
    let control = &run.sim.control;
    let (factor, feed_factor) = (control.active_factor(), control.data_factor());
    let mut path = Path { span, ..Path::default() };
    for part in straight.parts() {
        match part.letter {
            b'G' => run.modal.motion = if part.value == 0.0 { Motion::Rapid } else { Motion::Line },
            b'F' => (run.modal.feed, run.modal.feed_factor) = (part.value, feed_factor),
            axis => {
                if let Some(place) = path.axes.get_mut(usize::from(axis.wrapping_sub(b'X'))) {
                    *place = Some(Coordinate { value: part.value * factor, absolute: None });
                }
            }
        }
    }
    if path.moves() { motion::go(run, &path) } else { Ok(()) }
}
