//! Programs of the user around a measurement (B:2476-2530): CYCLE198 at the beginning of every measuring cycle,
//! CYCLE199 when it is complete. As delivered both are empty but for a label a cycle; a text may hold its own.

use super::flow::canonical;
use super::interpret::{self, Interpreter};
use super::programs::Unit;
use super::statement::Call;
use super::subprogram;
use crate::catalogue::Cycle;
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::machine::Stop;

/// A program that the measuring cycles call.
pub struct UserProgram {
    /// Its name.
    pub name: &'static str,
    /// Key of when it is called; `.help` behind it is what it is for.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// Called before the measurement.
pub const BEFORE: UserProgram = UserProgram { name: "CYCLE198", key: "user-program-before", source: "B:2482-2498" };
/// Called when the measurement is complete.
pub const BEHIND: UserProgram = UserProgram { name: "CYCLE199", key: "user-program-behind", source: "B:2500-2508" };
/// Both.
pub const ALL: [UserProgram; 2] = [BEFORE, BEHIND];

/// Whether a program of this name is on every control, so that a call of it is right where no text has it.
pub fn delivered(name: &str) -> bool {
    ALL.iter().any(|program| program.name == name)
}

/// Runs the user's program of this text around a call of this cycle, where there is one: from the label of the cycle
/// (`_M977`), else from its first block, to its end. It does not call itself.
pub fn around(run: &mut Interpreter, program: &UserProgram, cycle: &Cycle, span: Span) -> Result<(), Stop> {
    let measures = cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe.measures();
    let unit = run.programs.named(program.name).filter(|_| measures);
    let Some(unit) = unit.cloned() else {
        return Ok(());
    };
    if run.levels.iter().any(|level| level.blocks == unit.blocks) {
        return Ok(());
    }
    let (back, depth) = (run.at, run.levels.len());
    let call = Call { name: program.name.to_owned(), args: Vec::new(), places: Vec::new(), span };
    subprogram::enter(run, back, &call, &unit, 1).map_err(|problem| run.fail(problem))?;
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
    let label = format!("_M{}", cycle.name.trim_start_matches("CYCLE"));
    let blocks = run.targets.get(&canonical(&label));
    let mut inside = blocks.into_iter().flatten();
    let found = inside.find(|block| unit.blocks.contains(block));
    found.copied().unwrap_or(unit.blocks.start)
}
