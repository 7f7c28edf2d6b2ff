//! What one program of a text names, declares and calls.

use crate::catalogue;
use crate::diagnostic::Span;
use crate::entry::AUXILIARY;
use crate::program::flow::{called_here, callers};
use crate::program::held::stem;
use crate::syntax::fold::names_in;
use crate::syntax::programs::Programs;
use crate::syntax::{ExprId, Program, Word, WordKind};
use std::collections::BTreeSet;

/// The variables of one program, by their names without index.
#[derive(Debug, Default)]
pub(super) struct Uses {
    /// Variables that it names, and all parameters of the cycles that it calls.
    pub names: BTreeSet<String>,
    /// Variables that it declares.
    pub declared: BTreeSet<String>,
    pub formal: Vec<Formal>,
    pub calls: BTreeSet<usize>,
}

/// A parameter of a program.
#[derive(Clone, Debug)]
pub(super) struct Formal {
    pub name: String,
    /// What it changes, its caller sees (`VAR`).
    pub by_reference: bool,
    pub default: Option<ExprId>,
}

/// Whether a name that is called is that of a cycle of the control.
pub(super) fn is_cycle(program: &Program, name: Span) -> bool {
    program.text(name).get(..5).is_some_and(|start| start.eq_ignore_ascii_case(b"CYCLE"))
}

/// Whether a word calls a cycle of the control.
pub(super) fn calls_cycle(program: &Program, word: &Word) -> bool {
    word.called().is_some_and(|name| is_cycle(program, name))
}

/// Whether a word calls a cycle of the control that does something.
pub(super) fn measures_itself(program: &Program, word: &Word) -> bool {
    word.called().is_some_and(|name| is_cycle(program, name) && !program.is(name, AUXILIARY))
}

/// The programs that measure, or call one that does.
pub(super) fn measuring(program: &Program, programs: &Programs) -> BTreeSet<usize> {
    if programs.units.len() < 2 {
        return BTreeSet::new();
    }
    let mut called_by: Vec<Vec<usize>> = vec![Vec::new(); programs.units.len()];
    for (from, called) in callers(program, programs).into_iter().enumerate() {
        for to in called {
            called_by.get_mut(to).into_iter().for_each(|callers| callers.push(from));
        }
    }
    let themselves = programs.units.iter().enumerate().filter(|(_, unit)| {
        let mut words = program.blocks_of(unit).iter().flat_map(|block| program.words_of(block));
        words.any(|word| measures_itself(program, word))
    });
    let mut open: Vec<usize> = themselves.map(|(at, _)| at).collect();
    let mut found = BTreeSet::new();
    while let Some(unit) = open.pop() {
        if found.insert(unit) {
            open.extend(called_by.get(unit).into_iter().flatten());
        }
    }
    found
}

/// Looks through one program.
pub(super) fn uses(program: &Program, programs: &Programs, unit: usize) -> Uses {
    let mut found = Uses::default();
    let Some(unit) = programs.units.get(unit) else { return found };
    found.formal = formal(program, program.signature(unit));
    for block in program.blocks_of(unit) {
        let words = program.words_of(block);
        words.iter().for_each(|word| found.word(program, word));
        found.calls.extend(called_here(program, programs, words).map(|(_, other)| other));
    }
    found
}

impl Uses {
    fn word(&mut self, program: &Program, word: &Word) {
        match &word.kind {
            WordKind::Assign { name, index, value, .. } => {
                self.names.insert(program.name(*name));
                index.iter().chain([value]).for_each(|id| names_in(program, *id, &mut self.names));
            }
            WordKind::Declare { name, value, .. } => {
                self.names.insert(program.name(*name));
                self.declared.insert(program.name(*name));
                value.iter().for_each(|id| names_in(program, *id, &mut self.names));
            }
            WordKind::Address { value, .. } => names_in(program, *value, &mut self.names),
            WordKind::Call { name, args, .. } => {
                args.iter().for_each(|id| names_in(program, *id, &mut self.names));
                let cycle = catalogue::find(program.dialect, &program.name(*name));
                let params = cycle.map_or(&[][..], |cycle| cycle.params).iter();
                self.names.extend(params.map(|param| stem(param.name.as_str()).to_owned()));
            }
            _ => {}
        }
    }
}

/// The parameters that a `PROC` declares; the first name is that of the program.
fn formal(program: &Program, words: &[Word]) -> Vec<Formal> {
    let (mut found, mut by_reference, mut named) = (Vec::new(), false, false);
    for word in words {
        match &word.kind {
            WordKind::Keyword { name, .. } => by_reference |= program.is(*name, "VAR"),
            WordKind::Declare { .. } if !named => named = true,
            WordKind::Declare { name, value, .. } => found.push(Formal {
                name: program.name(*name),
                by_reference: std::mem::take(&mut by_reference),
                default: *value,
            }),
            _ => {}
        }
    }
    found
}
