//! The tree: blocks of words with places in the source. Printing a tree is its source; a change is a splice.

use crate::catalogue::Dialect;
use crate::diagnostic::Span;
use std::ops::Range;

/// Index into [`Program::exprs`].
pub type ExprId = u32;

/// A read program. Never fails: what is not understood is a [`WordKind::Unknown`] and an entry in `errors`.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Language.
    pub dialect: Dialect,
    /// The bytes as given.
    pub source: Vec<u8>,
    /// One a line, in order, empty lines included; their spans (line end excluded) never overlap.
    pub blocks: Vec<Block>,
    /// Words of all blocks.
    pub words: Vec<Word>,
    /// Expressions of all words.
    pub exprs: Vec<Expr>,
    /// What was not understood.
    pub errors: Vec<SyntaxError>,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Without CR LF.
    pub span: Span,
    /// Block number, `N10` or `:10`.
    pub number: Option<Span>,
    /// Skip level 0..9 of a leading `/`.
    pub skip: Option<u8>,
    /// Its words in [`Program::words`].
    pub words: Range<u32>,
    /// `; …` (NCT: `( … )`), delimiters included.
    pub comment: Option<Span>,
}

/// One word.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Place.
    pub span: Span,
    /// What it is.
    pub kind: WordKind,
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
        index: Vec<ExprId>,
        /// Place of the whole right side.
        value_span: Span,
        /// Right side.
        value: ExprId,
    },
    /// `CYCLE977`, `MSG("…")`, `L10(1,,3)`, `STOPRE`, NCT `G65 P…` stays addresses.
    Call {
        /// Name.
        name: Span,
        /// Arguments; `None` an omitted one. Empty also without brackets.
        args: Vec<Option<ExprId>>,
        /// Whether there were brackets.
        brackets: bool,
    },
    /// `LABEL:`.
    Label(Span),
    /// `IF`, `ELSE`, `ENDIF`, `WHILE`, `ENDWHILE`, `FOR`, `GOTOF`, `DEF`, …: the word; what follows it are words of their own.
    Keyword {
        /// Word.
        name: Span,
        /// Condition or target expression, where the keyword takes one.
        value: Option<ExprId>,
    },
    /// `%_N_NAME_MPF`, `%O0110`, `%`.
    Header(Span),
    /// Not understood; the same place is in [`Program::errors`].
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
        index: Vec<ExprId>,
    },
    /// `-`, `NOT`, `+`.
    Unary(Operator, ExprId),
    /// Left, operator, right.
    Binary(ExprId, Operator, ExprId),
    /// Function call, `SET(…)`, `REP(…)`.
    Call(Span, Vec<ExprId>),
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
}

/// Something not understood.
#[derive(Clone, Debug, PartialEq)]
pub struct SyntaxError {
    /// Place.
    pub span: Span,
    /// Key of the message: `syntax-…`.
    pub key: &'static str,
}
