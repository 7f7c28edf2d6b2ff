//! Subprograms that programs of older measuring cycles call, as they were: the result screen, the dialogue.

use super::{Interpreter, called};
use crate::check::upkeep;
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;

/// Shows the measuring result (B:2386, B:15278). A program of today does not call it (B:2378).
const SCREEN: &str = "CYCLE102";
/// Asks the operator for the values of the measuring call that follows; up to SW 4.5 (B:15279, B:15297-15310,
/// A:15977-16007).
const DIALOGUE: &str = "CYCLE103";

/// Carries out such a call; false: it is none.
pub fn called(run: &mut Interpreter, name: &str, place: Span) -> bool {
    let place = run.placed(place);
    match name {
        SCREEN if run.called.is_empty() => {
            run.keep(Problem::new("run-screen-empty", place, name).diagnostic(Severity::Note));
        }
        SCREEN => {
            upkeep::show(&mut run.sim);
            called::show(&mut run.called, &run.sim.control);
        }
        DIALOGUE => {
            run.keep(Problem::new("run-dialogue", place, name).diagnostic(Severity::Note));
        }
        _ => return false,
    }
    true
}
