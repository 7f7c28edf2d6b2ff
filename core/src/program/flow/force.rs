//! What is in force at each measuring call.

use super::state::{Mode, State, Tool};
use super::{Follow, follow};
use crate::control::Transverse;
use crate::program::fold::{self, Known};
use crate::program::tools::ToolInUse;
use crate::program::tree::{Expr, ExprId, Program, Word, WordKind};
use std::collections::HashMap;

/// A way to a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Its place among all ways of the program, in the order of the run.
    pub order: usize,
    /// What is in force at the call.
    pub state: State,
    /// Tool in use, where program and machine tell its type.
    pub tool: Option<ToolInUse>,
}

/// The ways to the calls of cycles that differ in their state, by the first byte of the call.
#[derive(Debug, Default)]
pub struct Force {
    at: HashMap<u32, Vec<Way>>,
    ways: usize,
}

impl Force {
    /// The ways to a call.
    pub fn take(&mut self, call: u32) -> Vec<Way> {
        self.at.remove(&call).unwrap_or_default()
    }
}

/// Finds what is in force at the calls of cycles.
pub fn in_force(program: &Program) -> Force {
    let mut rules = Rules {
        program,
        prepares: program.words.iter().any(|word| changes(program, word)),
        found: Force::default(),
    };
    follow(program, &mut rules, &State::default());
    rules.found
}

struct Rules<'a> {
    program: &'a Program,
    /// The program changes tools with M6: T only prepares.
    prepares: bool,
    found: Force,
}

impl Follow for Rules<'_> {
    type State = State;

    fn block(&mut self, state: &mut State, words: &[Word]) {
        // The tool of a block is chosen before its D and its M functions count.
        for word in words {
            self.tool(state, word);
        }
        for word in words {
            self.word(state, word);
        }
    }

    fn call(&mut self, state: &mut State, word: &Word) {
        let WordKind::Call { name, .. } = &word.kind else {
            return;
        };
        let start = self.program.text(*name).get(..5);
        if !start.is_some_and(|start| start.eq_ignore_ascii_case(b"CYCLE")) {
            return;
        }
        let ways = self.found.at.entry(word.span.start).or_default();
        if !ways.iter().any(|way| way.state == *state) {
            ways.push(Way {
                order: self.found.ways,
                state: state.clone(),
                tool: None,
            });
            self.found.ways += 1;
        }
    }

    fn elsewhere(&self, state: &mut State) {
        *state = State::elsewhere();
    }

    fn meet(&self, one: &State, other: &State) -> State {
        one.meet(other)
    }

    fn restore(&self, before: &State, after: &mut State) {
        after.plane.clone_from(&before.plane);
        after.compensation.clone_from(&before.compensation);
        after.frame.clone_from(&before.frame);
        after.transverse.clone_from(&before.transverse);
    }

    fn end(&mut self, _: &State) {}
}

impl Rules<'_> {
    fn tool(&self, state: &mut State, word: &Word) {
        let (name, value) = match &word.kind {
            WordKind::Address { name, value, .. } => (name, *value),
            WordKind::Assign {
                name, value, index, ..
            } if index.is_empty() => (name, *value),
            _ => return,
        };
        if self.program.is(*name, "T") {
            state.choose(self.chosen(value), self.prepares);
        }
    }

    fn chosen(&self, value: ExprId) -> Mode<Tool> {
        if let Some(Expr::Text(name)) = self.program.expr(value) {
            return Mode::Is(Tool::Name(self.program.name(*name)));
        }
        match self.whole(value) {
            Some(number) => Mode::Is(Tool::Number(number)),
            None => Mode::Open,
        }
    }

    fn word(&self, state: &mut State, word: &Word) {
        match &word.kind {
            WordKind::Address {
                name,
                value,
                extension,
                ..
            } => {
                self.address(state, self.program.text(*name), extension.is_some(), *value);
            }
            WordKind::Assign { name, .. } if self.program.is(*name, "SPOS") => {
                state.turning = Mode::Is(false);
            }
            WordKind::Call { name, .. } => {
                if let Some(transverse) = transverse(self.program.text(*name)) {
                    state.transverse = Mode::Is(transverse);
                }
            }
            _ => {}
        }
    }

    fn address(&self, state: &mut State, name: &[u8], extension: bool, value: ExprId) {
        match name {
            b"G" | b"g" => {
                let code = self.whole(value).and_then(|code| u16::try_from(code).ok());
                code.into_iter().for_each(|code| state.function(code));
            }
            b"D" | b"d" => state.correct(self.whole(value).map_or(Mode::Open, Mode::Is)),
            b"M" | b"m" if !extension => {
                self.whole(value)
                    .into_iter()
                    .for_each(|code| state.machine(code));
            }
            _ if name.eq_ignore_ascii_case(b"SPOS") => state.turning = Mode::Is(false),
            _ => {}
        }
    }

    fn whole(&self, value: ExprId) -> Option<i64> {
        let number = fold::number(self.program, value, &Known::new())?;
        (number.fract() == 0.0).then_some(number as i64)
    }
}

/// What a word without value sets of the transverse axis.
fn transverse(name: &[u8]) -> Option<Transverse> {
    [
        ("DIAMON", Transverse::Diameter),
        ("DIAMOF", Transverse::Radius),
        ("DIAM90", Transverse::AbsoluteDiameter),
    ]
    .into_iter()
    .find_map(|(known, mode)| name.eq_ignore_ascii_case(known.as_bytes()).then_some(mode))
}

/// Whether a word is M6.
fn changes(program: &Program, word: &Word) -> bool {
    match &word.kind {
        WordKind::Address {
            name,
            value,
            extension: None,
            ..
        } if program.is(*name, "M") => fold::number(program, *value, &Known::new()) == Some(6.0),
        _ => false,
    }
}
