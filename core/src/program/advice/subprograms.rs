//! Programs among each other: calls of some that are not here, misleading names, measuring calls on too deep a level.

use crate::catalogue;
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::own;
use crate::problem::Problem;
use crate::program::calls::CallSite;
use crate::program::flow::{LEVELS, before, callers, named_outside};
use crate::syntax::programs::{Programs, bare, numbered};
use crate::syntax::{Block, Program, Word, WordKind};
use std::collections::BTreeSet;

/// Most names that are told.
const NAMES: usize = 8;

/// Deepest level on which a measuring cycle is called (B:656). The main program is the first.
const DEEPEST: usize = 5;

/// Programs whose `PROC` has another name than their file, by which a call finds them, at the name behind `PROC`.
pub fn misnamed(program: &Program, programs: &Programs, found: &mut Vec<Diagnostic>) {
    for unit in &programs.units {
        let declared = program.signature(unit).iter().find_map(Word::declared);
        if let Some((file, place)) =
            unit.file.as_deref().zip(declared).filter(|(file, place)| program.name(*place) != *file)
        {
            found.push(own::PROGRAM_NAMES.finding().text("file", file).text("proc", program.name(place)).on(place));
        }
    }
}

/// The programs that the text calls and does not hold, at the first call of one, in the words of a run without them;
/// `known`: the first bytes of calls of which something else is told already.
pub fn outside(program: &Program, programs: &Programs, known: &BTreeSet<u32>, found: &mut Vec<Diagnostic>) {
    let (mut first, mut names) = (None, Vec::new());
    for block in &program.blocks {
        let missing = missing(program, programs, block).into_iter();
        for (span, name) in missing.filter(|(span, _)| !known.contains(&span.start)) {
            first = first.or(Some(span));
            if !names.contains(&name) && names.len() <= NAMES {
                names.push(name);
            }
        }
    }
    let Some(span) = first else { return };
    if names.len() > NAMES {
        names.truncate(NAMES);
        names.push("…".to_owned());
    }
    found.push(Problem::new("run-subprogram", span, names.join(", ")).diagnostic(Severity::Note));
}

/// What a block calls that is not here, with the place of the word.
fn missing(program: &Program, programs: &Programs, block: &Block) -> Vec<(Span, String)> {
    let words = program.words_of(block);
    if program.grammar().numbered {
        return numbered_outside(program, programs, block).into_iter().collect();
    }
    let named = words.iter().enumerate().filter_map(|(at, word)| {
        let name = named_outside(program, programs, words, at)?;
        // a cycle of newer controls is no program of the user
        if catalogue::list::newer_alone(&program.name(name)).is_some() {
            return None;
        }
        // a text is called at the word before it
        let manner = before(words, at).filter(|_| matches!(word.kind, WordKind::Constant(_)));
        Some((manner.unwrap_or(word).span, bare(&program.name(name)).to_owned()))
    });
    named.collect()
}

/// NCT: the program at P that `M98` or `G65` calls, where a number stands there and no macro has it.
fn numbered_outside(program: &Program, programs: &Programs, block: &Block) -> Option<(Span, String)> {
    let number = |letter: &str| {
        program.words_of(block).iter().find_map(|word| Some((word.span, program.literal(word, letter)?)))
    };
    let by_macro = program.words_of(block).iter().any(|word| super::nct::calls_macro(program, word));
    if !by_macro && number("M").is_none_or(|(_, code)| code != 98.0) {
        return None;
    }
    let (span, called) = number("P")?;
    let name = numbered(called)?;
    let known = by_macro && catalogue::by_program(called).is_some();
    (!known && programs.place(&name).is_none()).then_some((span, name))
}

/// Calls in subprograms of the same text that are reached on too deep a level.
pub fn too_deep(program: &Program, programs: &Programs, sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    if programs.units.len() < 2 || sites.is_empty() {
        return;
    }
    let levels = levels(&callers(program, programs));
    for site in sites {
        let units = programs.units.partition_point(|unit| unit.blocks.start <= site.line as usize);
        let level = units.checked_sub(1).and_then(|unit| levels.get(unit)).copied().unwrap_or(1);
        if level > DEEPEST && site.cycle.purpose.probe.measures() {
            found.push(own::ADVICE_LEVEL.finding().number("level", level as f64).on(site.span));
        }
    }
}

/// Deepest level on which each unit runs. What nothing calls may be the main program.
pub(super) fn levels(calls: &[Vec<usize>]) -> Vec<usize> {
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
