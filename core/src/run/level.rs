//! Program levels: the main program, and one more for each call that has not returned.

use super::interpret::Interpreter;
use super::locals::Locals;
use super::modal::Modal;
use super::repeat::Repetition;
use super::statement::Call;
use crate::control::{Frame, Plane, Units};
use crate::diagnostic::Span;
use crate::problem::Problem;
use std::ops::Range;

/// A program that is being carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Its variables and parameters.
    pub locals: Locals,
    /// Its blocks.
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
    /// What `SAVE` brings back at the end.
    pub saved: Option<Box<Saved>>,
}

/// Where the variables of a program come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Variables {
    /// They are its own.
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
}

impl Level {
    /// A program that a block calls once; the main program as if its first one did.
    pub fn new(blocks: Range<usize>, call: usize) -> Level {
        Level {
            locals: Locals::new(),
            blocks,
            call,
            left: 0,
            repeats: Vec::new(),
            variables: Variables::Own,
            modal: None,
            saved: None,
        }
    }
}

/// Whether one more level fits.
pub fn room(run: &Interpreter, place: Span) -> Result<(), Problem> {
    let repeats: usize = run.levels.iter().map(|level| level.repeats.len()).sum();
    if run.levels.len() + repeats <= run.limits.depth {
        return Ok(());
    }
    Err(Problem::at("run-depth", place).number("limit", run.limits.depth as f64))
}

/// What is in force now.
pub fn save(run: &Interpreter) -> Saved {
    let control = &run.sim.control;
    Saved {
        modal: run.modal,
        plane: control.plane,
        units: (control.active_units, control.data_follow),
        frame: control.program_frame,
    }
}

/// Brings back what was in force at the call; the tool stays as it is.
pub fn restore(run: &mut Interpreter, saved: Saved) {
    let tools = (run.modal.prepared, run.modal.waiting_edge);
    run.modal = saved.modal;
    (run.modal.prepared, run.modal.waiting_edge) = tools;
    run.sim.with_length(|control| control.plane = saved.plane);
    (run.sim.control.active_units, run.sim.control.data_follow) = saved.units;
    run.sim.control.program_frame = saved.frame;
}
