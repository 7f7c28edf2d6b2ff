//! Whether a program may end with tool radius compensation on.

use crate::program::flow::{Entry, Follow, Forces, Mode, State, follow};
use crate::syntax::fold::Nothing;
use crate::syntax::programs::Programs;
use crate::syntax::tree::{Word, WordKind};
use crate::syntax::{Program, fold};

/// Whether a main program of the text ends without G40 behind its last G41 or G42.
pub fn left_on(program: &Program, programs: &Programs) -> bool {
    if !program.words.iter().any(|word| switches_on(program, word)) {
        return false;
    }
    let mut rules = Rules { forces: Forces::of(program), left_on: false };
    follow(program, programs, &mut rules, &State::default());
    rules.left_on
}

fn switches_on(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Address { name, value, .. } if program.is(*name, "G") => {
            let code = fold::number(program, *value, &Nothing);
            code.is_some_and(|code| code == 41.0 || code == 42.0)
        }
        _ => false,
    }
}

struct Rules<'a> {
    forces: Forces<'a>,
    left_on: bool,
}

impl Follow for Rules<'_> {
    type State = State;

    fn block(&mut self, state: &mut State, words: &[Word]) {
        self.forces.block(state, words, &Nothing);
    }

    fn call(&mut self, _: &mut State, _: &Word) {}

    fn elsewhere(&self, _: &mut State) {}

    fn meet(&self, one: &State, other: &State) -> State {
        one.meet(other)
    }

    fn leave(&mut self, caller: &State, (_, after): (&State, &State), _: &Entry, saves: bool) -> State {
        let mut state = after.clone();
        if saves {
            state.restore(caller);
        }
        state
    }

    fn end(&mut self, state: &State) {
        self.left_on |= match &state.compensation {
            Mode::Is(compensation) => compensation.code != 40,
            Mode::Open => true,
            Mode::Unset => false,
        };
    }
}
