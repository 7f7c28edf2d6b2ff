//! When a run is given up: all that bounds it, in one place. A program without a loop ends by itself, one that comes
//! back to what was before is told at once (`endless`); what goes on and on may do so, in bounded memory.

use super::Interpreter;
use super::mode::Mode;
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;

/// Levels of subprograms: a SINUMERIK has 12 with the main program.
const DEPTH: usize = 11;
/// Entries of the trace, of less than 200 bytes each, beside the motions of the program itself: a thousand calls make
/// up to 150,000, ten thousand holes 510,000.
const TRACE: usize = 600_000;
/// Motions of the program itself, of 37 bytes each.
const OWN: usize = 2_000_000;
/// What the program itself writes and shows beside them.
const TOLD: usize = 200_000;
/// How often a measuring call is carried out: each takes milliseconds, and thousands of points are measured. So many
/// fit into the trace.
const CALLS: usize = 3_000;
/// Data that are written, of some hundred bytes each: R parameters, user data, tools, elements of arrays.
const DATA: usize = 1_000_000;
/// Blocks between two looks at how many data there are.
const BETWEEN: usize = 4096;
/// Work that nobody watches or can stop, in blocks, beyond that of the text from its beginning to its end.
const UNWATCHED: u64 = 100_000;

/// What is told of a program that does not come to an end.
pub const NO_END: &str = "run-steps";

/// When a run is given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Work in blocks; a long one, one that writes many elements, and in a loop one close to the part count as several.
    /// None: it goes on until somebody stops it.
    pub steps: Option<u64>,
    /// Levels of subprograms.
    pub depth: usize,
    /// Entries of the trace beside the motions of the program itself; a call that needs more ends the run.
    pub trace: usize,
    /// Motions of the program itself, outside of calls. What it does behind them is done, but not recorded.
    pub own: usize,
    /// What the program itself writes and shows; behind it nothing that it does by itself is recorded either.
    pub told: usize,
    /// How often one measuring call may be carried out where it is written.
    pub calls: usize,
    /// Data that the program may write.
    pub data: usize,
    /// Whether a subprogram that is not there, and a value that only the machine has, stop the run.
    pub strict: bool,
    /// How the program is carried out.
    pub mode: Mode,
    /// Line, from 1, up to which a block search goes.
    pub target: u32,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits {
            steps: None,
            depth: DEPTH,
            trace: TRACE,
            own: OWN,
            told: TOLD,
            calls: CALLS,
            data: DATA,
            strict: false,
            mode: Mode::Automatic,
            target: 0,
        }
    }
}

impl Limits {
    /// With the work that a user permits, in blocks: how often a call is carried out and what is recorded follow it.
    pub fn permitted(self, steps: Option<u64>) -> Limits {
        let Some(steps) = steps else { return self };
        let most = usize::try_from(steps).unwrap_or(usize::MAX);
        Limits { steps: Some(steps), calls: self.calls.max(most), trace: self.trace.max(most), ..self }
    }

    /// Without a record of what the program does by itself: what calls do is recorded.
    pub fn unrecorded(self) -> Limits {
        Limits { own: 0, told: 0, ..self }
    }

    /// For a run of a program with so many blocks that nobody watches: what does not jump comes to its end.
    pub fn unwatched(blocks: usize) -> Limits {
        Limits { steps: Some(UNWATCHED + blocks as u64), ..Limits::default() }
    }
}

/// Whether one more block may be carried out.
pub fn room(run: &Interpreter, place: Option<Span>) -> Result<(), Problem> {
    let Some(limit) = run.limits.steps.filter(|limit| run.work >= *limit) else { return Ok(()) };
    Err(Problem::at(NO_END, place.unwrap_or_default()).number("limit", limit as f64))
}

/// Whether what the program wrote has room; from time to time it is counted.
pub fn data(run: &mut Interpreter, place: Span) -> Result<(), Problem> {
    if !run.blocks.is_multiple_of(BETWEEN) {
        return Ok(());
    }
    let control = &run.sim.control;
    let edges: usize = control.tools.values().map(|tool| 1 + tool.edges.len()).sum();
    let written = control.data.written() + edges + run.measured.len();
    if written <= run.limits.data { Ok(()) } else { Err(full(run, place)) }
}

/// Whether so many more elements of variables have room.
pub fn elements(run: &Interpreter, more: usize, place: Span) -> Result<(), Problem> {
    let there: usize = run.levels.iter().map(|level| level.elements).sum();
    if there + run.shared_elements + more <= run.limits.data { Ok(()) } else { Err(full(run, place)) }
}

/// Tells once that not all is recorded, where anything was to be.
pub fn tell(run: &mut Interpreter, place: Span) {
    if std::mem::take(&mut run.sim.unrecorded) && run.limits.own > 0 && !run.unrecorded {
        run.unrecorded = true;
        run.tell(Severity::Note, &Problem::at("run-trace-full", place).number("limit", run.sim.recorded() as f64));
    }
}

fn full(run: &Interpreter, place: Span) -> Problem {
    Problem::at("run-data", place).number("limit", run.limits.data as f64)
}
