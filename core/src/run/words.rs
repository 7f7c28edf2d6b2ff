//! Words without a value that set something.

use super::interpret::Interpreter;
use super::modal::Motion;
use super::path::Suppress;
use super::statement::Words;
use crate::diagnostic::Severity;
use crate::problem::Problem;
use crate::program::words::{Setting, setting};

/// Takes the settings of a block.
pub fn apply(run: &mut Interpreter, found: &mut Words) {
    for call in &found.calls {
        match setting(&call.name) {
            Some(Setting::Suppress) => found.path.suppress = Suppress::All,
            Some(Setting::Transverse(transverse)) => run.sim.control.transverse = transverse,
            Some(Setting::Through) => run.modal.motion = Motion::Through,
            Some(Setting::Spline) => {
                run.modal.motion = Motion::Spline;
                run.tell(Severity::Warning, &Problem::new("run-spline", call.span, &*call.name));
            }
            Some(Setting::Approach) => {
                let problem = Problem::new("run-contour-approach", call.span, &*call.name);
                run.tell(Severity::Note, &problem);
            }
            Some(Setting::EndOfSpline) | None => {}
        }
    }
}
