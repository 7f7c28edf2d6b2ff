//! Ways through one program: `IF` to `ENDIF`, loops that may not run, jumps forward, ends.

use super::Meet;
use crate::syntax::links::structural;
use crate::syntax::targets::canonical;
use crate::syntax::{Block, Expr, Program, Word, WordKind};
use std::collections::HashMap;

/// The state on the present way, and on the ways that meet it later.
pub struct Branches<S> {
    /// On the present way.
    pub state: S,
    /// Nothing comes here in the order of the text.
    pub dead: bool,
    /// Structures whose end has not come yet.
    pub open: Vec<Open<S>>,
    /// States with which a label or block number is jumped to.
    jumps: HashMap<String, S>,
    /// A block number was among them.
    numbered: bool,
    /// State of those who went back before the end.
    left: Option<S>,
    /// M2 and M30 go back to the caller.
    called: bool,
}

/// A structure whose end has not come yet.
pub enum Open<S> {
    If(Choice<S>),
    /// A loop that begins in this block.
    Loop(usize),
}

/// The ways past an `IF`. No state: nothing comes there.
pub struct Choice<S> {
    before: Option<S>,
    /// Behind the part before `ELSE`, where there was one.
    first: Option<Option<S>>,
}

impl<S: Meet> Branches<S> {
    /// The one way at the beginning; `called`: of a subprogram, which M2 and M30 end like M17.
    pub fn new(state: S, called: bool) -> Self {
        Self { called, state, dead: false, open: Vec::new(), jumps: HashMap::new(), numbered: false, left: None }
    }

    /// Whether ways may meet or part at a block; most blocks only move.
    pub fn concerned(&self, program: &Program, block: &Block, words: &[Word]) -> bool {
        let parts = |word: &Word| match word.kind {
            WordKind::Keyword { .. } | WordKind::Label(_) => true,
            WordKind::Address { name, .. } => program.is(name, "M"),
            _ => false,
        };
        let met = self.numbered && block.number.is_some() && !self.jumps.is_empty();
        block.skip.is_some() || met || words.iter().any(parts)
    }

    /// Before a block: jumps arrive, branches end or begin.
    pub fn arrive(&mut self, program: &Program, block: &Block, words: &[Word]) {
        self.labels(program, block, words);
        match structural(program, words) {
            Some("ELSE") => {
                if let Some(Open::If(choice)) = self.open.last_mut() {
                    choice.first = Some((!self.dead).then(|| self.state.clone()));
                    self.dead = choice.before.is_none();
                    self.state = choice.before.clone().unwrap_or_else(|| self.state.clone());
                }
            }
            Some("ENDIF") => {
                if let Some(Open::If(choice)) = self.open.pop_if(|open| matches!(open, Open::If(_))) {
                    self.join(choice.first.unwrap_or(choice.before));
                }
            }
            _ => {}
        }
    }

    /// The block in which the innermost structure begins, where that is a loop.
    pub fn loop_begin(&self) -> Option<usize> {
        let Some(Open::Loop(head)) = self.open.last() else { return None };
        Some(*head)
    }

    /// What was open on other ways to the same place.
    pub fn also(&mut self, ways: Vec<Vec<Open<S>>>) {
        for way in ways {
            let Some(from) = self.open.len().checked_sub(way.len()) else { continue };
            for (open, other) in self.open.iter_mut().skip(from).zip(way) {
                if let (Open::If(choice), Open::If(other)) = (open, other) {
                    choice.before = both(choice.before.take(), other.before);
                    choice.first = match (choice.first.take(), other.first) {
                        (Some(one), Some(other)) => Some(both(one, other)),
                        (one, _) => one,
                    };
                }
            }
        }
    }

    /// Behind a block: a branch begins, or a jump or the end goes away. `back`: what goes back was followed already.
    pub fn leave(&mut self, program: &Program, at: usize, back: bool) {
        let Some(block) = program.blocks.get(at) else { return };
        let words = program.words_of(block);
        match structural(program, words) {
            Some("IF") => {
                let before = (!self.dead).then(|| self.state.clone());
                self.open.push(Open::If(Choice { before, first: None }));
            }
            Some("WHILE" | "FOR" | "LOOP" | "REPEAT") => self.open.push(Open::Loop(at)),
            Some("ENDWHILE" | "ENDFOR" | "ENDLOOP" | "UNTIL") => {
                self.open.pop_if(|open| matches!(open, Open::Loop(_)));
            }
            _ => {}
        }
        let mut goes = ends(program, words);
        if (returns(program, words) || (goes && self.called)) && !self.dead {
            self.left = both(self.left.take(), Some(self.state.clone()));
            goes = true;
        }
        for target in words.iter().filter_map(|word| target(program, word)) {
            goes = true;
            if let Some(name) = target.filter(|_| !self.dead && !back) {
                self.numbered |= name.starts_with('N');
                let known = self.jumps.remove(&name);
                self.jumps.extend(both(known, Some(self.state.clone())).map(|state| (name, state)));
            }
        }
        let conditional = words.iter().any(|word| program.is_keyword(word, &["IF", "CASE"]));
        if goes && block.skip.is_none() && !conditional {
            self.dead = true;
        }
    }

    /// What holds behind the program; none: it does not come back.
    pub fn after(self) -> Option<S> {
        both((!self.dead).then_some(self.state), self.left)
    }

    fn labels(&mut self, program: &Program, block: &Block, words: &[Word]) {
        let label = words.iter().find_map(Word::label);
        if self.jumps.is_empty() && (label.is_none() || !self.dead) {
            return;
        }
        for name in label.into_iter().chain(block.number).map(|name| canonical(&program.name(name))) {
            let state = self.jumps.remove(&name);
            self.join(state);
        }
        // A label that is jumped to from behind: nothing better is known than the order of the text.
        self.dead &= label.is_none();
    }

    /// Another way meets the present one.
    fn join(&mut self, other: Option<S>) {
        let Some(other) = other else { return };
        self.state = if self.dead { other } else { self.state.meet(&other) };
        self.dead = false;
    }
}

/// What holds where two ways meet, of which one may not come there.
fn both<S: Meet>(one: Option<S>, other: Option<S>) -> Option<S> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.meet(&other)),
        (one, other) => one.or(other),
    }
}

/// Where a word jumps to; none inside: the text does not tell.
pub fn target(program: &Program, word: &Word) -> Option<Option<String>> {
    let WordKind::Keyword { name, value } = &word.kind else { return None };
    if !program.text(*name).get(..4).is_some_and(|start| start.eq_ignore_ascii_case(b"GOTO")) {
        return None;
    }
    Some(match value.and_then(|value| program.expr(value)) {
        Some(Expr::Name { name, index }) if index.is_empty() => Some(canonical(&program.name(*name))),
        Some(Expr::Text(name)) => Some(canonical(&program.name(*name))),
        Some(Expr::Number(number, _)) => Some(format!("N{number}")),
        _ => None,
    })
}

/// Whether the block ends its program: M2, M30; the main program of NCT from everywhere.
pub fn ends(program: &Program, words: &[Word]) -> bool {
    words.iter().any(|word| matches!(program.machine_function(word), Some(2.0 | 30.0)))
}

/// Whether the block goes back to the caller: M17, RET.
pub fn returns(program: &Program, words: &[Word]) -> bool {
    words.iter().any(|word| program.is_keyword(word, &["RET"]) || program.machine_function(word) == Some(17.0))
}
