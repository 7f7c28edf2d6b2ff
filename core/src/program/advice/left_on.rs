//! Whether a program may end with tool radius compensation on.

use crate::program::flow::{Entry, Follow, Forces, Mode, State, follow};
use crate::syntax::fold::Nothing;
use crate::syntax::programs::Programs;
use crate::syntax::{Program, Word};

/// Whether a main program of the text ends without G40 behind its last G41 or G42.
pub fn left_on(program: &Program, programs: &Programs) -> bool {
    if !program.words.iter().any(|word| matches!(program.constant(word, "G"), Some(41.0 | 42.0))) {
        return false;
    }
    let mut rules = Rules { forces: Forces::of(program), left_on: false };
    follow(program, programs, &mut rules, &State::default());
    rules.left_on
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
