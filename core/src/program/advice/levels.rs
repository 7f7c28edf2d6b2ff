//! Program levels: a measuring cycle is called no deeper than on the fifth (B:656). The main program is the first.

use super::at;
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::program::calls::CallSite;
use crate::program::flow::{LEVELS, callers};
use crate::syntax::Program;
use crate::syntax::programs::Programs;

/// Deepest level of a call.
const DEEPEST: usize = 5;

/// Calls in subprograms of the same text that are reached on too deep a level.
pub fn look(program: &Program, programs: &Programs, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    if programs.units.len() < 2 || sites.is_empty() {
        return;
    }
    let levels = levels(&callers(program, programs));
    for site in sites {
        let line = site.line as usize;
        let units = programs.units.partition_point(|unit| unit.blocks.start <= line);
        let level = units.checked_sub(1).and_then(|unit| levels.get(unit));
        let level = level.copied().unwrap_or(1);
        if level > DEEPEST && site.cycle.purpose.probe.measures() {
            let finding = own::ADVICE_LEVEL.finding().number("level", level as f64);
            found.push(at(finding, site.span));
        }
    }
}

/// Deepest level on which each unit runs. What nothing calls may be the main program.
fn levels(calls: &[Vec<usize>]) -> Vec<usize> {
    let mut levels = vec![1; calls.len()];
    for called in calls.iter().flatten() {
        levels.get_mut(*called).into_iter().for_each(|level| *level = 0);
    }
    // Each round goes one level deeper, so that a program that calls itself comes to an end too.
    for _ in 0..LEVELS {
        for (unit, called) in calls.iter().enumerate() {
            let level = levels.get(unit).copied().unwrap_or(0);
            for other in called.iter().filter(|_| (1..LEVELS).contains(&level)) {
                if let Some(deeper) = levels.get_mut(*other) {
                    *deeper = (*deeper).max(level + 1);
                }
            }
        }
    }
    levels
}
