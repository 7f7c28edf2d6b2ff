//! A program followed as it runs, without running it: its blocks in order, into the programs of the same text that it
//! calls, and past its branches. What only a run can know (which branch is taken) is left open.

mod called;
mod force;
mod language;
mod state;
mod structure;

pub use called::{Called, called, callers};
pub use force::{Force, Way, in_force};
pub use state::{Mode, State, Tool};

use super::tree::{Block, Program, Word};
use crate::run::programs::{Programs, programs};
use std::collections::HashMap;
use structure::Branches;

/// Levels that a control has; what is deeper is not followed.
pub const LEVELS: usize = 12;

/// States with which a program is followed anew; a call in yet another one is taken to end as the last did.
const ENTRIES: usize = 8;

/// What is kept while a program is followed.
pub trait Follow {
    /// What holds at a place of the program.
    type State: Clone + PartialEq;
    /// Takes in the words of a block, calls excepted: functions count before calls.
    fn block(&mut self, state: &mut Self::State, words: &[Word]);
    /// Meets a word of the block that calls something.
    fn call(&mut self, state: &mut Self::State, word: &Word);
    /// A program that is not in this text was called, or calls this one.
    fn elsewhere(&self, state: &mut Self::State);
    /// What holds where two ways meet.
    fn meet(&self, one: &Self::State, other: &Self::State) -> Self::State;
    /// A program that saves its functions (`SAVE`) has ended.
    fn restore(&self, before: &Self::State, after: &mut Self::State);
    /// The whole program ends.
    fn end(&mut self, state: &Self::State);
}

/// Follows every program of the text: those that nothing here calls from a state of their own, the others from where
/// they are called.
pub fn follow<F: Follow>(program: &Program, rules: &mut F, begin: &F::State) {
    let programs = programs(program);
    let roots = roots(program, &programs);
    let mut walk = Walk {
        program,
        programs,
        rules,
        open: Vec::new(),
        seen: HashMap::new(),
    };
    for unit in roots {
        let main = walk.is_main(unit);
        let mut state = begin.clone();
        if !main {
            walk.rules.elsewhere(&mut state);
        }
        let after = walk.unit(unit, state);
        if main && let Some(state) = after {
            walk.rules.end(&state);
        }
    }
    // Programs that call each other in a circle have no beginning.
    for unit in 0..walk.programs.units.len() {
        if !walk.seen.contains_key(&unit) {
            let mut state = begin.clone();
            walk.rules.elsewhere(&mut state);
            walk.unit(unit, state);
        }
    }
}

/// Programs that no other one of the text calls; the first one is taken for the main program where each is called.
fn roots(program: &Program, programs: &Programs) -> Vec<usize> {
    let mut called_here = vec![false; programs.units.len()];
    for (from, called) in callers(program, programs).iter().enumerate() {
        for to in called.iter().filter(|to| **to != from) {
            if let Some(known) = called_here.get_mut(*to) {
                *known = true;
            }
        }
    }
    let free = called_here.iter().enumerate();
    let mut roots: Vec<usize> = free
        .filter_map(|(unit, known)| (!known).then_some(unit))
        .collect();
    if roots.is_empty() {
        roots.push(0);
    }
    roots
}

struct Walk<'a, F: Follow> {
    program: &'a Program,
    programs: Programs,
    rules: &'a mut F,
    /// Programs in which the present one was called.
    open: Vec<usize>,
    /// How each program was followed.
    seen: HashMap<usize, Vec<Passed<F::State>>>,
}

/// State before and after a program; none: it does not come back.
type Passed<S> = (S, Option<S>);

impl<F: Follow> Walk<'_, F> {
    /// Whether it begins from a reset: it is no subprogram by its first block and by how it ends.
    fn is_main(&self, unit: usize) -> bool {
        let Some(unit) = self.programs.units.get(unit) else {
            return false;
        };
        let blocks = self.program.blocks.get(unit.blocks.clone());
        let returns =
            |block: &Block| structure::returns(self.program, self.program.words_of(block));
        unit.signature.is_none() && !blocks.unwrap_or_default().iter().any(returns)
    }

    /// Follows one program; none: it does not come back.
    fn unit(&mut self, unit: usize, before: F::State) -> Option<F::State> {
        if self.open.contains(&unit) || self.open.len() >= LEVELS {
            return Some(before);
        }
        let known = self.seen.entry(unit).or_default();
        if let Some((_, after)) = known.iter().find(|(entry, _)| *entry == before) {
            return after.clone();
        }
        if known.len() >= ENTRIES {
            return known.last().and_then(|(_, after)| after.clone());
        }
        self.open.push(unit);
        let mut after = self.blocks(unit, before.clone());
        self.open.pop();
        if let Some(after) = after.as_mut().filter(|_| self.saves(unit)) {
            self.rules.restore(&before, after);
        }
        let known = self.seen.entry(unit).or_default();
        known.push((before, after.clone()));
        after
    }

    fn blocks(&mut self, unit: usize, state: F::State) -> Option<F::State> {
        let range = self.programs.units.get(unit)?.blocks.clone();
        let program = self.program;
        let mut branches = Branches::new(state);
        for block in program.blocks.get(range).unwrap_or_default() {
            let words = program.words_of(block);
            if !branches.concerned(program, block, words) {
                self.block(&mut branches, words);
                continue;
            }
            let rules = &*self.rules;
            branches.arrive(program, block, words, |one, other| rules.meet(one, other));
            let before = block.skip.map(|_| branches.state.clone());
            self.block(&mut branches, words);
            if let Some(before) = before {
                branches.state = self.rules.meet(&before, &branches.state);
            }
            let rules = &mut *self.rules;
            if structure::ends(program, words) && branches.alive(block) {
                rules.end(&branches.state);
            }
            branches.leave(program, block, words, |one, other| rules.meet(one, other));
        }
        let rules = &*self.rules;
        branches.after(|one, other| rules.meet(one, other))
    }

    fn block(&mut self, branches: &mut Branches<F::State>, words: &[Word]) {
        self.rules.block(&mut branches.state, words);
        for at in 0..words.len() {
            self.call(branches, words, at);
        }
    }

    fn call(&mut self, branches: &mut Branches<F::State>, words: &[Word], at: usize) {
        match called(self.program, &self.programs, words, at) {
            Some(Called::Here(unit)) => match self.unit(unit, branches.state.clone()) {
                Some(after) => branches.state = after,
                None => branches.dead = true,
            },
            Some(Called::Elsewhere) => self.rules.elsewhere(&mut branches.state),
            None => {}
        }
        if let Some(word) = words.get(at) {
            self.rules.call(&mut branches.state, word);
        }
    }

    fn saves(&self, unit: usize) -> bool {
        let signature = self
            .programs
            .units
            .get(unit)
            .and_then(|unit| unit.signature);
        let block = signature.and_then(|block| self.program.blocks.get(block));
        block.is_some_and(|block| {
            structure::calls(self.program, self.program.words_of(block), "SAVE")
        })
    }
}
