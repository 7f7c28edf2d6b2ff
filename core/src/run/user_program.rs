//! Programs of the user around a measurement (B:2476-2530): CYCLE198 at the beginning of every measuring cycle,
//! CYCLE199 when it is complete. As delivered both are empty but for a label a cycle; a text may hold its own.

use super::halt::Halt;
use super::interpret::Interpreter;
use super::statement::Call;
use super::{interpret, subprogram};
use crate::diagnostic::Span;
use crate::entry::Cycle;
use crate::program::user_programs::UserProgram;
use crate::syntax::links::canonical;
use crate::syntax::programs::Unit;

/// Runs the user's program of this text around a call of this cycle, where there is one: from the label of the cycle
/// (`_M977`), else from its first block, to its end. It does not call itself.
pub fn around(run: &mut Interpreter, program: &UserProgram, cycle: &Cycle, span: Span) -> Result<(), Halt> {
    let measures = cycle.is_measuring_cycle();
    let unit = run.programs.named(program.name).filter(|_| measures);
    let Some(unit) = unit.cloned() else { return Ok(()) };
    if run.levels.iter().any(|level| level.blocks == unit.blocks) {
        return Ok(());
    }
    let (back, depth) = (run.at, run.levels.len());
    let call = Call::named(program.name, span);
    subprogram::enter(run, back, &call, &unit, 1)?;
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
