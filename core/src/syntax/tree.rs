//! The tree: blocks of words with places in the source. Printing a tree is its source; a change is a splice.

use super::fold::{self, NOTHING};
use super::grown::Replaced;
use super::programs::Unit;
use crate::control::definitions::Macros;
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::name::numbered;
use crate::own::Own;
use std::ops::Range;
use std::sync::Arc;

/// Index into [`Program::exprs`].
pub type ExprId = u32;

/// A read program. Never fails: what is not understood is a [`WordKind::Unknown`] and an entry in `errors`.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Language.
    pub dialect: Dialect,
    /// The bytes as given.
    pub source: Arc<Vec<u8>>,
    /// End of what is read of them: all, but for what stands behind an end of file (Ctrl-Z).
    pub end: u32,
    /// One a line, in order, empty lines included; their spans (line end excluded) never overlap.
    pub blocks: Vec<Block>,
    /// Words of all blocks.
    pub words: Vec<Word>,
    /// Expressions of all words.
    pub exprs: Vec<Expr>,
    /// Places of what is no plain number, by their order: most of a large program are numbers, which have theirs.
    pub places: Vec<(ExprId, Span)>,
    /// What was not understood.
    pub errors: Vec<SyntaxError>,
    /// Lines in which macros are replaced.
    pub replaced: Replaced,
    /// Macros of the machine, with which it was read.
    pub macros: Arc<Macros>,
}

impl Program {
    /// Bytes of a place; empty if it lies outside of the source.
    pub fn text(&self, span: Span) -> &[u8] {
        match self.source.get(span.start as usize..span.end as usize) {
            Some(text) => text,
            None => self.replaced_text(span),
        }
    }

    /// Whether this name stands at a place, without regard to case.
    pub fn is(&self, span: Span, name: &str) -> bool {
        self.text(span).eq_ignore_ascii_case(name.as_bytes())
    }

    /// Name at a place as it is compared: in upper case, of a variable without leading zeroes (`R01` is `R1`).
    pub fn name(&self, span: Span) -> String {
        let name = self.text(span).to_ascii_uppercase();
        numbered(String::from_utf8(name).unwrap_or_else(|other| String::from_utf8_lossy(other.as_bytes()).into_owned()))
    }

    /// Text at a place as it is written.
    pub fn written(&self, span: Span) -> String {
        String::from_utf8_lossy(self.text(span)).into_owned()
    }

    /// Words of a block.
    pub fn words_of(&self, block: &Block) -> &[Word] {
        self.words.get(block.words.start as usize..block.words.end as usize).unwrap_or_default()
    }

    /// Words of the block at this place; none behind the end.
    pub fn words_at(&self, block: usize) -> &[Word] {
        self.blocks.get(block).map_or(&[], |block| self.words_of(block))
    }

    /// Words of the block with the `PROC` of one program of the text.
    pub fn signature(&self, unit: &Unit) -> &[Word] {
        unit.signature.map_or(&[], |block| self.words_at(block))
    }

    /// Blocks of one program of the text.
    pub fn blocks_of(&self, unit: &Unit) -> &[Block] {
        self.blocks.get(unit.blocks.clone()).unwrap_or_default()
    }

    /// Whether a word is one of these keywords.
    pub fn is_keyword(&self, word: &Word, names: &[&str]) -> bool {
        word.keyword().is_some_and(|name| names.iter().any(|one| self.is(name, one)))
    }

    /// Whether a word calls one of these.
    pub fn is_call(&self, word: &Word, names: &[&str]) -> bool {
        word.called().is_some_and(|name| names.iter().any(|one| self.is(name, one)))
    }

    /// Value of an address with these letters, whatever its extension.
    pub fn address(&self, word: &Word, letters: &str) -> Option<ExprId> {
        match word.kind {
            WordKind::Address { name, value, .. } if self.is(name, letters) => Some(value),
            _ => None,
        }
    }

    /// Number of an address with these letters, where no variable is in it.
    pub fn constant(&self, word: &Word, letters: &str) -> Option<f64> {
        fold::number(self, self.address(word, letters)?, NOTHING)
    }

    /// Number of an address with these letters, where a number stands there and nothing else.
    pub fn literal(&self, word: &Word, letters: &str) -> Option<f64> {
        self.number(self.address(word, letters)?)
    }

    /// Number of an M function of the main spindle, where no variable is in it.
    pub fn machine_function(&self, word: &Word) -> Option<f64> {
        let extended = matches!(word.kind, WordKind::Address { extension: Some(_), .. });
        if extended { None } else { self.constant(word, "M") }
    }

    /// An expression by its index.
    pub fn expr(&self, id: ExprId) -> Option<&Expr> {
        self.exprs.get(id as usize)
    }

    /// Place of an expression, with the brackets around it.
    pub fn place(&self, id: ExprId) -> Span {
        match (self.places.binary_search_by_key(&id, |(of, _)| *of), self.expr(id)) {
            (Ok(at), _) => self.places[at].1,
            (_, Some(Expr::Number(_, place))) => *place,
            _ => Span::default(),
        }
    }

    /// An argument; none: it is omitted.
    pub fn given(&self, id: ExprId) -> Option<ExprId> {
        self.expr(id).filter(|expr| **expr != Expr::Omitted).map(|_| id)
    }

    /// The number that an expression is, where it is one and nothing else.
    pub fn number(&self, id: ExprId) -> Option<f64> {
        if let Expr::Number(number, _) = self.expr(id)? { Some(*number) } else { None }
    }

    /// The word around a place.
    pub fn word_at(&self, place: Span) -> Option<&Word> {
        let behind = self.words.partition_point(|word| word.span.start <= place.start);
        let word = self.words.get(behind.checked_sub(1)?)?;
        (word.span.end >= place.end).then_some(word)
    }

    /// Line (from 0) that holds a byte; the line end belongs to the line before it.
    pub fn line_of(&self, offset: u32) -> u32 {
        let offset = self.placed(Span { start: offset, end: offset }).start;
        self.blocks.partition_point(|block| block.span.start <= offset).saturating_sub(1) as u32
    }
}

/// One line. An empty source has one empty line; a line end at the end of the source starts no further line.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Without CR LF.
    pub span: Span,
    /// Block number, `N10` or `:10`.
    pub number: Option<Span>,
    /// Skip level 0..9 of a leading `/`.
    pub skip: Option<u8>,
    /// Words of the line in [`Program::words`].
    pub words: Range<u32>,
    /// `; …` (NCT: `( … )`), delimiters included.
    pub comment: Option<Span>,
    /// Whether it is a motion that was left as text, without words; see [`Program::plain`].
    pub plain: bool,
}

/// One word.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Place.
    pub span: Span,
    /// What it is.
    pub kind: WordKind,
}

impl Word {
    /// Name of a keyword.
    pub fn keyword(&self) -> Option<Span> {
        if let WordKind::Keyword { name, .. } = self.kind { Some(name) } else { None }
    }

    /// Name of what it calls.
    pub fn called(&self) -> Option<Span> {
        if let WordKind::Call { name, .. } = self.kind { Some(name) } else { None }
    }

    /// Name that it declares.
    pub fn declared(&self) -> Option<Span> {
        if let WordKind::Declare { name, .. } = self.kind { Some(name) } else { None }
    }

    /// Name of a label.
    pub fn label(&self) -> Option<Span> {
        if let WordKind::Label(name) = self.kind { Some(name) } else { None }
    }
}

/// What a word is. Names are spans; compare without regard to case.
#[derive(Clone, Debug, PartialEq)]
pub enum WordKind {
    /// `X10`, `X=R1+2`, `G54`, `M6`, `T9`, `S1=500`, `X=IC(5)`.
    Address {
        /// Letters, for example `X`.
        name: Span,
        /// Numeric extension in `M2=3`.
        extension: Option<u32>,
        /// `AC`, `IC` or `DC` around the value.
        mode: Option<Span>,
        /// Value.
        value: ExprId,
    },
    /// `_MVAR=1`, `R10=…`, `_SETV[0]=5`, `$TC_DP12[1,1]=…`, NCT `#500=…`.
    Assign {
        /// Name without index.
        name: Span,
        /// Indices, 0 to 3.
        index: Box<[ExprId]>,
        /// Right side.
        value: ExprId,
    },
    /// One name of a declaration, after the keywords `DEF` (`PROC`, `EXTERN`) and the type, which may have a length:
    /// `DEF REAL A, B[3]=SET(1,2)` is `DEF`, `REAL`, `A`, `B[3]=…`; `STRING[28]` has the value 28.
    Declare {
        /// Name.
        name: Span,
        /// Sizes of an array, 0 to 3.
        index: Box<[ExprId]>,
        /// First value.
        value: Option<ExprId>,
    },
    /// A constant that stands alone: `7` and `9` in `CASE R1 OF 7 GOTOF A 9 GOTOF B`.
    Constant(ExprId),
    /// `CYCLE977`, `MSG("…")`, `L10(1,,3)`, `STOPRE`, NCT `G65 P…` stays addresses.
    Call {
        /// Name.
        name: Span,
        /// Arguments; none also without brackets.
        args: Box<[ExprId]>,
    },
    /// `LABEL:`.
    Label(Span),
    /// `IF`, `ELSE`, `ENDIF`, `WHILE`, `FOR`, `GOTOF`, `DEF`, …: the word; what follows it are words of their own.
    Keyword {
        /// Word.
        name: Span,
        /// Condition or target, where the keyword takes one; a target is a name (`LABEL`, `N100`), a text or a number.
        value: Option<ExprId>,
    },
    /// `%_N_NAME_MPF`, `%O0110`, `%`.
    Header,
    /// Not understood; where inside of it the reading failed is in [`Program::errors`].
    Unknown,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// Number.
    Number(f64, Span),
    /// `"text"`, place inside the quotes.
    Text(Span),
    /// Variable or constant with indices.
    Name {
        /// Name.
        name: Span,
        /// Indices.
        index: Box<[ExprId]>,
    },
    /// `-`, `NOT`, `+`, `B_NOT`; a leading `<<` (the operand as text).
    Unary(Operator, ExprId),
    /// Left, operator, right.
    Binary(ExprId, Operator, ExprId),
    /// Function call, `SET(…)`, `REP(…)`.
    Call(Span, Box<[ExprId]>),
    /// `(1,2,3)` as first value of an array.
    List(Box<[ExprId]>),
    /// Nothing between two commas of a call or list: `SET(0,,9)`.
    Omitted,
}

/// Operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// Binary or sign.
    Plus,
    /// Binary or sign.
    Minus,
    /// `*`.
    Times,
    /// `/`.
    Over,
    /// `DIV`.
    Div,
    /// `MOD`.
    Mod,
    /// `==`, NCT `EQ`.
    Equal,
    /// `<>`, NCT `NE`.
    NotEqual,
    /// `<`.
    Less,
    /// `<=`.
    LessEqual,
    /// `>`.
    Greater,
    /// `>=`.
    GreaterEqual,
    /// `AND`.
    And,
    /// `OR`.
    Or,
    /// `XOR`.
    Xor,
    /// `NOT`.
    Not,
    /// `B_AND`.
    BitAnd,
    /// `B_OR`.
    BitOr,
    /// `B_XOR`.
    BitXor,
    /// `B_NOT`.
    BitNot,
    /// `<<` joins texts.
    Join,
    /// `:` chains frames.
    Chain,
}

/// Something not understood.
#[derive(Clone, Debug, PartialEq)]
pub struct SyntaxError {
    /// Place.
    pub span: Span,
    /// What is wrong, one of the sentences of PW100.
    pub sentence: &'static Own,
}
