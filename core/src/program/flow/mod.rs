//! A program followed as it runs, without running it: its blocks in order, into the programs of the same text that it
//! calls, past its branches and through its loops until nothing new comes back to their beginning. What only a run can
//! know (which branch is taken) is left open.

mod called;
mod force;
mod passes;
mod state;
pub(super) mod structure;

pub use called::{Called, before, called, called_here, callers, named_outside};
pub use force::{Forces, changes_tools};
pub use state::{Mode, State, Tool};

use crate::diagnostic::Span;
use crate::syntax::programs::{Programs, Unit};
use crate::syntax::{Block, Program, Word};
use passes::Passes;
use std::collections::HashMap;
use std::ops::Range;
use structure::Branches;

/// Levels that a control has; what is deeper is not followed.
pub const LEVELS: usize = 12;

/// States with which a program is followed anew; calls in others are followed with all that they have in common.
const ENTRIES: usize = 8;

/// Programs of a text from which on each is followed in fewer states.
const MANY: usize = 20_000;

/// Most times that a program is followed.
const TIMES: usize = 64;

/// Blocks that are followed again in loops, as a multiple of those that the program has.
const AGAIN: usize = 8;

/// A call of a program of the text.
pub struct Entry<'a> {
    /// Place of the called program in [`Programs::units`].
    pub unit: usize,
    /// Words of the block that calls it.
    pub words: &'a [Word],
    /// Which of them does.
    pub at: usize,
}

impl Entry<'_> {
    /// The word that calls it.
    pub fn word(&self) -> Option<&Word> {
        self.words.get(self.at)
    }

    /// Place of the word that calls it.
    pub fn place(&self) -> Span {
        self.word().map_or_else(Span::default, |word| word.span)
    }
}

/// What holds at a place of a program.
pub trait Meet: Clone + Default + PartialEq {
    /// What holds where two ways meet.
    fn meet(&self, other: &Self) -> Self;
}

/// What is kept while a program is followed.
pub trait Follow {
    /// What holds at a place of the program.
    type State: Meet;
    /// Takes in the words of a block, calls excepted: functions count before calls.
    fn block(&mut self, state: &mut Self::State, words: &[Word]);
    /// Takes in a motion that was left as text.
    fn motion(&mut self, _: &mut Self::State, _: &Block) {}
    /// Meets a word of the block that calls something.
    fn call(&mut self, _: &mut Self::State, _: &Word) {}
    /// A program that is not in this text was called, or calls this one.
    fn elsewhere(&self, _: &mut Self::State) {}
    /// What a called program begins with, of what holds at its call.
    fn enter(&mut self, state: &Self::State, _: &Entry) -> Self::State {
        state.clone()
    }
    /// What holds behind a call whose program began and ended with this; `SAVE` puts back the functions of its caller.
    fn leave(&mut self, _: &Self::State, way: (&Self::State, &Self::State), _: &Entry, _: bool) -> Self::State {
        way.1.clone()
    }
    /// The whole program ends.
    fn end(&mut self, _: &Self::State) {}
    /// What begins or ends here is not followed to its end: a circle of programs, more levels or passes than are
    /// followed.
    fn lost(&mut self, _: Span) {}
}

/// Follows every program of the text from where it is called, those that nothing here calls from a state of their own.
pub fn follow<F: Follow>(program: &Program, programs: &Programs, rules: &mut F) {
    let mut walk = Walk {
        program,
        programs,
        passes: Passes::of(program),
        budget: program.blocks.len().saturating_mul(AGAIN),
        rules,
        open: Vec::new(),
        seen: HashMap::new(),
        entries: (ENTRIES * MANY / programs.units.len().max(1)).clamp(1, ENTRIES),
    };
    for unit in roots(program, programs) {
        if !walk.is_main(unit) {
            walk.foreign(unit);
        } else if let Some((_, state)) = walk.unit(unit, F::State::default()) {
            walk.rules.end(&state);
        }
    }
    // Programs that call each other in a circle have no beginning.
    for unit in 0..walk.programs.units.len() {
        if !walk.seen.contains_key(&unit) {
            walk.foreign(unit);
        }
    }
}

/// Programs that no other one of the text calls; the first one is taken for the main program where each is called.
fn roots(program: &Program, programs: &Programs) -> Vec<usize> {
    let mut called_here = vec![false; programs.units.len()];
    for (from, called) in callers(program, programs).iter().enumerate() {
        called.iter().filter(|to| **to != from).for_each(|to| called_here[*to] = true);
    }
    let roots: Vec<usize> = (0..called_here.len()).filter(|unit| !called_here[*unit]).collect();
    if roots.is_empty() { vec![0] } else { roots }
}

struct Walk<'a, F: Follow> {
    program: &'a Program,
    programs: &'a Programs,
    rules: &'a mut F,
    /// Programs in which the present one was called.
    open: Vec<usize>,
    /// How each program was followed.
    seen: HashMap<usize, Seen<F::State>>,
    /// States with which each is followed by itself.
    entries: usize,
    /// How the bodies of its loops were followed.
    passes: Passes<F::State>,
    /// Blocks that may still be followed again.
    budget: usize,
}

/// Whether no program calls this one: it is no subprogram by its first block and by how it ends.
pub fn is_main(program: &Program, unit: &Unit) -> bool {
    let returns = |block: &Block| structure::returns(program, program.words_of(block));
    unit.signature.is_none() && !program.blocks_of(unit).iter().any(returns)
}

/// State before and after a program; none: it does not come back.
type Passed<S> = (S, Option<S>);

/// How a program was followed.
#[derive(Default)]
struct Seen<S> {
    /// In states of its own; behind as many as there may be, with what the further ones have in common.
    passed: Vec<Passed<S>>,
    times: usize,
}

impl<F: Follow> Walk<'_, F> {
    /// Whether it begins from a reset: it is no subprogram by its first block and by how it ends.
    fn is_main(&self, unit: usize) -> bool {
        self.programs.units.get(unit).is_some_and(|unit| is_main(self.program, unit))
    }

    /// Follows one program that something outside of the text calls.
    fn foreign(&mut self, unit: usize) {
        let mut state = F::State::default();
        self.rules.elsewhere(&mut state);
        self.unit(unit, state);
    }

    /// Follows one program: the state with which it began, and the one behind it; none: it does not come back.
    fn unit(&mut self, unit: usize, before: F::State) -> Option<(F::State, F::State)> {
        if self.open.contains(&unit) || self.open.len() >= LEVELS {
            return Some((before.clone(), before));
        }
        let before = match self.known(unit, before) {
            Ok((before, after)) => return after.map(|after| (before, after)),
            Err(before) => before,
        };
        self.open.push(unit);
        let after = self.blocks(unit, before.clone());
        self.open.pop();
        let seen = self.seen.entry(unit).or_default();
        seen.times += 1;
        seen.passed.truncate(self.entries);
        seen.passed.push((before.clone(), after.clone()));
        after.map(|after| (before, after))
    }

    /// How a program that begins like this was followed already; else with what it is to be followed.
    fn known(&mut self, unit: usize, before: F::State) -> Result<Passed<F::State>, F::State> {
        let seen = self.seen.entry(unit).or_default();
        if let Some(found) = seen.passed.iter().find(|(entry, _)| *entry == before) {
            return Ok(found.clone());
        }
        let last = seen.passed.last().filter(|_| seen.passed.len() >= self.entries);
        let Some((last, after)) = last else { return Err(before) };
        let common = last.meet(&before);
        if common == *last {
            return Ok((common, after.clone()));
        }
        if seen.times >= TIMES {
            let after = after.clone();
            self.lost_in(unit);
            return Ok((common, after));
        }
        Err(common)
    }

    fn lost_in(&mut self, unit: usize) {
        let block = self.programs.units.get(unit).and_then(|unit| self.program.blocks.get(unit.blocks.start));
        self.rules.lost(block.map_or_else(Span::default, |block| block.span));
    }

    fn blocks(&mut self, unit: usize, state: F::State) -> Option<F::State> {
        let range = self.programs.units.get(unit)?.blocks.clone();
        let program = self.program;
        let called = self.open.len() > 1 && !program.grammar().ends_run;
        let mut branches = Branches::new(state, called);
        let mut at = range.start;
        while let Some(block) = program.blocks.get(at).filter(|_| at < range.end) {
            let words = program.words_of(block);
            if !self.passes.begins(at) && !branches.concerned(program, block, words) {
                self.block(&mut branches, block, words);
                at += 1;
                continue;
            }
            branches.arrive(program, block, words);
            self.passes.begin(&branches, at);
            let before = block.skip.map(|_| branches.state.clone());
            self.block(&mut branches, block, words);
            if let Some(before) = before {
                branches.state = before.meet(&branches.state);
            }
            if structure::ends(program, words) && !called && !branches.dead && block.skip.is_none() {
                self.rules.end(&branches.state);
            }
            at = self.onward(&mut branches, at, &range);
        }
        branches.after()
    }

    /// The block that is followed next: the one behind, or the beginning of a loop with what comes back to it.
    fn onward(&mut self, branches: &mut Branches<F::State>, at: usize, range: &Range<usize>) -> usize {
        let back = self.passes.back(self.program, branches, at, range);
        if let Some(back) = back {
            let length = at + 1 - back.head();
            let new = self.passes.returns(branches, back);
            if new == Some(true) && self.budget >= length {
                self.budget -= length;
                self.passes.again(branches, back);
                return back.head();
            }
            if new.is_some() {
                self.rules.lost(self.program.blocks.get(at).map_or_else(Span::default, |block| block.span));
            }
            self.passes.done(branches, back);
        }
        branches.leave(self.program, at, back.is_some());
        at + 1
    }

    fn block(&mut self, branches: &mut Branches<F::State>, block: &Block, words: &[Word]) {
        self.rules.block(&mut branches.state, words);
        if block.plain {
            self.rules.motion(&mut branches.state, block);
        }
        for at in 0..words.len() {
            self.call(branches, words, at);
        }
    }

    fn call(&mut self, branches: &mut Branches<F::State>, words: &[Word], at: usize) {
        match called(self.program, self.programs, words, at) {
            Some(Called::Here(unit)) => {
                let entry = Entry { unit, words, at };
                if self.open.contains(&unit) || self.open.len() >= LEVELS {
                    self.rules.lost(entry.place());
                }
                let begin = self.rules.enter(&branches.state, &entry);
                match self.unit(unit, begin) {
                    Some((begin, after)) => {
                        let saves = self.saves(unit);
                        branches.state = self.rules.leave(&branches.state, (&begin, &after), &entry, saves);
                    }
                    None => branches.dead = true,
                }
            }
            Some(Called::Elsewhere) => self.rules.elsewhere(&mut branches.state),
            None => {}
        }
        if let Some(word) = words.get(at) {
            self.rules.call(&mut branches.state, word);
        }
    }

    fn saves(&self, unit: usize) -> bool {
        let unit = self.programs.units.get(unit);
        unit.is_some_and(|unit| self.program.signature(unit).iter().any(|word| self.program.is_call(word, &["SAVE"])))
    }
}
