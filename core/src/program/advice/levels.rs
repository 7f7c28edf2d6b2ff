//! Program levels: a measuring cycle is called no deeper than on the fifth (B:656). The main program is the first.

use super::at;
use crate::check::{Finding, error};
use crate::diagnostic::{Code, Diagnostic};
use crate::message::Message;
use crate::program::calls::CallSite;
use crate::program::tree::{Program, WordKind};
use crate::run::programs::subprograms;
use std::collections::BTreeMap;

/// Deepest level of a call.
const DEEPEST: usize = 5;
/// Levels that a control has; what is deeper is not followed.
const LEVELS: usize = 12;

/// Calls in subprograms of the same text that are reached on too deep a level.
pub fn look(program: &Program, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    let starts = subprograms(program);
    if starts.is_empty() || sites.is_empty() {
        return;
    }
    let mut units: Vec<usize> = starts.values().copied().collect();
    units.sort_unstable();
    let unit_of = |line: usize| units.partition_point(|start| *start <= line);
    let levels = levels(&callers(program, &starts, unit_of, units.len() + 1));
    for site in sites {
        let level = levels
            .get(unit_of(site.line as usize))
            .copied()
            .unwrap_or(1);
        if level > DEEPEST && site.cycle.purpose.probe.measures() {
            let message = Message::new("advice-level").number("level", level as f64);
            let finding = error(Code::Own(138), message).hint(Message::new("advice-level-hint"));
            found.push(at(finding, site.span));
        }
    }
}

/// Which unit (0: the main program) calls which.
fn callers(
    program: &Program,
    starts: &BTreeMap<String, usize>,
    unit_of: impl Fn(usize) -> usize,
    units: usize,
) -> Vec<Vec<usize>> {
    let mut calls = vec![Vec::new(); units];
    for (line, block) in program.blocks.iter().enumerate() {
        for word in program.words_of(block) {
            let WordKind::Call { name, .. } = &word.kind else {
                continue;
            };
            if let Some(start) = starts.get(&program.name(*name))
                && let Some(list) = calls.get_mut(unit_of(line))
            {
                list.push(unit_of(*start));
            }
        }
    }
    calls
}

/// Deepest level on which each unit runs. What nothing calls may be the main program.
fn levels(calls: &[Vec<usize>]) -> Vec<usize> {
    let mut levels = vec![0; calls.len()];
    for (unit, level) in levels.iter_mut().enumerate() {
        *level = usize::from(!calls.iter().any(|called| called.contains(&unit)));
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
