//! What the words of a block activate.

use super::state::{Mode, State, Tool};
use crate::control::Transverse;
use crate::program::words::{Setting, of_axis, setting};
use crate::syntax::fold::Known;
use crate::syntax::{Expr, ExprId, Program, Word, WordKind, fold};

/// How the words of one program count.
pub struct Forces<'a> {
    program: &'a Program,
    /// The program changes tools with M6: T only prepares.
    prepares: bool,
    /// It has G41 or G42.
    pub compensates: bool,
}

impl<'a> Forces<'a> {
    /// Forces of the words of one program.
    pub fn of(program: &'a Program) -> Self {
        let on = |word: &Word| matches!(program.constant(word, "G"), Some(41.0 | 42.0));
        Self { program, prepares: changes_tools(program), compensates: program.words.iter().any(on) }
    }

    /// Takes in the words of a block; `known`: what its variables hold.
    pub fn block(&self, state: &mut State, words: &[Word], known: Known) {
        // The tool of a block is chosen before its D and its M functions count.
        for word in words {
            self.tool(state, word, known);
        }
        let of_next = words.iter().any(|word| self.is_tool(word) || self.program.machine_function(word) == Some(6.0));
        for word in words {
            self.word(state, word, known, of_next);
        }
    }

    fn is_tool(&self, word: &Word) -> bool {
        let (WordKind::Address { name, .. } | WordKind::Assign { name, .. }) = &word.kind else { return false };
        self.program.is(*name, "T")
    }

    fn tool(&self, state: &mut State, word: &Word, known: Known) {
        let (name, value) = match &word.kind {
            WordKind::Address { name, value, .. } => (name, *value),
            WordKind::Assign { name, value, index, .. } if index.is_empty() => (name, *value),
            _ => return,
        };
        if self.program.is(*name, "T") {
            state.choose(self.chosen(value, known), self.prepares);
        }
    }

    fn chosen(&self, value: ExprId, known: Known) -> Mode<Tool> {
        if let Some(Expr::Text(name)) = self.program.expr(value) {
            return Mode::Is(Tool::Name(self.program.name(*name)));
        }
        self.whole(value, known).map_or(Mode::Open, |number| Mode::Is(Tool::Number(number)))
    }

    fn word(&self, state: &mut State, word: &Word, known: Known, of_next: bool) {
        match &word.kind {
            WordKind::Address { name, value, extension, .. } => {
                let number = |value| self.whole(value, known);
                match self.program.text(*name) {
                    b"D" | b"d" => state.correct(number(*value).map_or(Mode::Open, Mode::Is), of_next),
                    b"G" | b"g" => number(*value).into_iter().for_each(|code| state.function(code, word.span)),
                    b"M" | b"m" if extension.is_none() => {
                        number(*value).into_iter().for_each(|code| state.machine(code));
                    }
                    name if name.eq_ignore_ascii_case(b"SPOS") => state.turning = Mode::Is(false),
                    _ => {}
                }
            }
            WordKind::Assign { name, .. } if self.program.is(*name, "SPOS") => state.turning = Mode::Is(false),
            WordKind::Call { name, args } => self.diameters(state, &self.program.name(*name), args),
            _ => {}
        }
    }

    /// What a word says of the transverse axis: for the channel, or for X alone.
    fn diameters(&self, state: &mut State, name: &str, args: &[ExprId]) {
        if let Some(own) = of_axis(name) {
            let of_x = matches!(args, [axis] if self.program.is(self.program.place(*axis), "X"));
            match own {
                _ if !of_x => {}
                Some(own) => state.of_x(own),
                None => state.as_channel(),
            }
            return;
        }
        match setting(name) {
            Some(Setting::Transverse(transverse)) => state.of_channel(transverse),
            Some(Setting::RadiiInCycles) => state.of_channel(Transverse::Radius),
            Some(Setting::AsChannel) => state.as_channel(),
            _ => {}
        }
    }

    fn whole(&self, value: ExprId, known: Known) -> Option<i64> {
        let number = fold::number(self.program, value, known)?;
        (number.fract() == 0.0).then_some(number as i64)
    }
}

/// Whether a program changes tools with M6.
pub fn changes_tools(program: &Program) -> bool {
    program.words.iter().any(|word| program.machine_function(word) == Some(6.0))
}
