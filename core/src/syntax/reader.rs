//! The place in the source, and the arenas being filled. Asks the grammar where languages differ.

use super::bytes::{in_name, is_blank};
use super::grammar::Grammar;
use super::grown::Replaced;
use super::macros::Known;
use super::tree::{Expr, ExprId, Program, SyntaxError, Word, WordKind};
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::own;
use crate::own::Own;
use std::sync::Arc;

/// Deepest nesting of brackets, and tallest expression; bounds every recursion over a tree.
pub const DEPTH: u16 = 100;

/// A value, or what is wrong at the present place.
pub(super) type Parsed<T> = Result<T, &'static Own>;

/// An expression with the height of its tree.
#[derive(Clone, Copy)]
pub(super) struct Node {
    pub id: ExprId,
    pub height: u16,
}

/// What the next word of a line may be, beside the ordinary.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Expect {
    Words,
    /// After `DEF`: types, names, commas.
    Definition,
    /// After `PROC`, `EXTERN`: the name.
    Procedure,
    /// Inside the brackets after it.
    Parameters,
    /// After `FOR`: the assignment.
    Counter,
    /// After `OF`: constants and jumps.
    Constants,
}

/// The reader's state. `at <= end <= source.len()`.
pub(super) struct Reader<'a> {
    pub grammar: &'static Grammar,
    pub source: &'a [u8],
    pub at: usize,
    /// End of the present line, line end excluded.
    pub end: usize,
    pub depth: u16,
    pub expect: Expect,
    /// First word of the present line in the tree.
    pub first: usize,
    /// What is read so far.
    pub tree: Program,
    /// Elements of the lists being read; each list takes its own off the top.
    pub list: Vec<ExprId>,
    /// Macros that count here.
    pub macros: Known,
    /// Whether plain motions are left as text.
    pub lean: bool,
}

impl<'a> Reader<'a> {
    /// Reads `source`, the beginning of the whole text; `lean`: plain motions are left as text, so that few words come.
    pub fn new(dialect: Dialect, source: &'a [u8], whole: &Arc<Vec<u8>>, lean: bool) -> Self {
        let lines = source.iter().filter(|byte| **byte == b'\n').count() + 1;
        let words = if lean { 0 } else { source.len() / 8 };
        Self {
            grammar: Grammar::of(dialect),
            source,
            at: 0,
            end: 0,
            depth: 0,
            expect: Expect::Words,
            first: 0,
            tree: Program {
                dialect,
                source: Arc::clone(whole),
                end: source.len() as u32,
                blocks: Vec::with_capacity(lines),
                words: Vec::with_capacity(words),
                exprs: Vec::with_capacity(words),
                places: Vec::new(),
                errors: Vec::new(),
                replaced: Replaced::default(),
                macros: Arc::default(),
            },
            list: Vec::new(),
            macros: Known::default(),
            lean,
        }
    }

    /// Byte `ahead` of the present place; 0 past the end of the line.
    pub fn byte(&self, ahead: usize) -> u8 {
        let at = self.at + ahead;
        if at < self.end { self.source.get(at).copied().unwrap_or(0) } else { 0 }
    }

    /// What is left of the line.
    pub fn rest(&self) -> &'a [u8] {
        self.source.get(self.at..self.end).unwrap_or_default()
    }

    pub fn done(&self) -> bool {
        self.at >= self.end
    }

    pub fn blanks(&mut self) {
        while is_blank(self.byte(0)) {
            self.at += 1;
        }
    }

    /// Steps over this byte, blanks before it included; else stays.
    pub fn take(&mut self, wanted: u8) -> bool {
        let start = self.at;
        self.blanks();
        let found = self.byte(0) == wanted;
        self.at = if found { self.at + 1 } else { start };
        found
    }

    pub fn name(&mut self) -> Span {
        let start = self.at;
        while in_name(self.byte(0)) {
            self.at += 1;
        }
        self.from(start)
    }

    /// From a place to the present one.
    pub fn from(&self, start: usize) -> Span {
        Span { start: start as u32, end: self.at as u32 }
    }

    pub fn text(&self, span: Span) -> &'a [u8] {
        self.source.get(span.start as usize..span.end as usize).unwrap_or_default()
    }

    /// An expression from a place to the present one.
    pub fn push(&mut self, start: usize, expr: Expr, height: u16) -> Parsed<Node> {
        if height > DEPTH {
            return Err(&own::SYNTAX_DEPTH);
        }
        let id = self.tree.exprs.len() as ExprId;
        if !matches!(expr, Expr::Number(..)) {
            self.tree.places.push((id, self.from(start)));
        }
        self.tree.exprs.push(expr);
        Ok(Node { id, height })
    }

    /// A number from a place to the present one, where a sign may stand before the digits.
    pub fn number(&mut self, start: usize, value: f64) -> Parsed<Node> {
        let minus = self.source.get(start) == Some(&b'-');
        self.push(start, Expr::Number(if minus { -value } else { value }, self.from(start)), 1)
    }

    /// Whether this word stands at the present place, whatever follows it.
    pub fn begins(&self, word: &[u8]) -> bool {
        self.rest().get(..word.len()).is_some_and(|text| text.eq_ignore_ascii_case(word))
    }

    /// Whether an exponent as other languages write it stands here: `e-3` behind a number.
    pub fn exponent(&self) -> bool {
        let signed = usize::from(matches!(self.byte(1), b'+' | b'-'));
        self.byte(0).eq_ignore_ascii_case(&b'e') && self.byte(1 + signed).is_ascii_digit()
    }

    /// An address and its value, without extension and kind of dimension.
    pub fn address(&mut self, start: usize, name: Span, value: ExprId) -> Parsed<()> {
        self.word(start, WordKind::Address { name, extension: None, mode: None, value })
    }

    /// A word from a place to the present one.
    pub fn word(&mut self, start: usize, kind: WordKind) -> Parsed<()> {
        self.tree.words.push(Word { span: self.from(start), kind });
        Ok(())
    }

    /// An expression in brackets, which belong to its place and are closed here.
    pub fn bracketed(&mut self, start: usize, inner: Node) -> Node {
        self.tree.places.pop_if(|(of, _)| *of == inner.id);
        self.tree.places.push((inner.id, self.from(start)));
        inner
    }

    /// Where a block ends inside of a bracket, blanks left out; 0 where it does not.
    fn left_open(&self, place: usize, sentence: &Own, stop: u8) -> usize {
        let first = self.source.get(place..self.end).unwrap_or_default().trim_ascii_start().first();
        if *sentence != own::SYNTAX_BRACKET || first.is_some_and(|byte| *byte != stop) {
            return 0;
        }
        self.source.get(..place).unwrap_or_default().trim_ascii_end().len()
    }

    /// Takes back a word of the present line that ends at this place; where it begins.
    fn touched(&mut self, start: usize) -> usize {
        let value = |kind: &WordKind| matches!(kind, WordKind::Address { .. } | WordKind::Assign { .. });
        let touches = |word: &mut Word| word.span.end as usize == start && value(&word.kind);
        let own = self.tree.words.len() > self.first;
        self.tree.words.pop_if(|word| own && touches(word)).map_or(start, |word| word.span.start as usize)
    }

    /// Marks what was not understood, from `start` to the next blank behind `place`, where the reading failed; touching
    /// ones become one, and a word that it touches is not understood either: of `X10+5` and `_FA=2%` nobody knows what
    /// they mean. What is in a bracket that the block leaves open belongs to it, up to the end.
    pub fn unknown(&mut self, start: usize, place: usize, sentence: &'static Own, stop: u8) {
        let end = self.left_open(place, sentence, stop);
        self.at = if end == 0 { place } else { end }.max(start + 1);
        while !self.done() && !is_blank(self.byte(0)) && self.byte(0) != stop {
            let close = self.rest().strip_prefix(b"\"").and_then(|rest| rest.iter().position(|byte| *byte == b'"'));
            self.at += close.map_or(1, |length| length + 2);
        }
        let start = self.touched(start);
        let span = self.from(start);
        match (self.tree.words.get_mut(self.first..).and_then(<[Word]>::last_mut), self.tree.errors.last_mut()) {
            (Some(word), Some(error)) if word.kind == WordKind::Unknown && word.span.end == span.start => {
                (word.span.end, error.span.end) = (span.end, span.end);
            }
            _ => {
                self.tree.words.push(Word { span, kind: WordKind::Unknown });
                let start = (place as u32).clamp(span.start, span.end.saturating_sub(1).max(span.start));
                self.tree.errors.push(SyntaxError { span: Span { start, ..span }, sentence });
            }
        }
    }
}
