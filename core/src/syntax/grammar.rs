//! What differs between the languages of part programs, chosen once by the dialect.

use super::expression::Strength;
use super::reader::{Node, Parsed, Reader};
use super::tree::{Operator, Program};
use super::{nct, nct_expression, sinumerik, sinumerik_expression};
use crate::dialect::Dialect;

/// What is peculiar to a language.
pub(crate) struct Grammar {
    pub(super) word: fn(&mut Reader) -> Parsed<()>,
    /// The operator at the present place with its strength and length.
    pub(super) operator: fn(&Reader) -> Option<(Operator, Strength, usize)>,
    pub(super) operand: fn(&mut Reader) -> Parsed<Node>,
    /// What begins a comment: `;` one up to the end of the line, which counts in each language; `(` one up to `)`.
    pub(super) comment: u8,
    /// Whether `:10` is the number of a main block, not the name of a program.
    pub(super) main_blocks: bool,
    /// Whether `DEFINE` names pieces of text.
    pub(super) macros: bool,
    /// Words that begin, part and end control structures; `END` does everywhere.
    pub structures: &'static [&'static str],
    /// Whether programs have numbers (`O0110`), with which `M98` and `G65` call them and from which `M99` goes back.
    pub numbered: bool,
    /// Whether `M2` and `M30` end the whole run, in a subprogram too; else they end that as `M17` does.
    pub ends_run: bool,
    /// Whether a call has its values as addresses in its own block; else they are in variables, written before it.
    pub by_address: bool,
    /// A line as a comment.
    pub commented: fn(&str) -> String,
}

static SINUMERIK: Grammar = Grammar {
    word: sinumerik::word,
    operator: sinumerik_expression::operator,
    operand: sinumerik_expression::operand,
    comment: b';',
    main_blocks: true,
    macros: true,
    structures: &["IF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "FOR", "ENDFOR", "LOOP", "ENDLOOP", "REPEAT", "UNTIL"],
    numbered: false,
    ends_run: false,
    by_address: false,
    commented: |line| format!("; {line}\n"),
};

static NCT: Grammar = Grammar {
    word: nct::word,
    operator: nct_expression::operator,
    operand: nct_expression::operand,
    comment: b'(',
    main_blocks: false,
    macros: false,
    structures: &["IF", "WHILE", "DO"],
    numbered: true,
    ends_run: true,
    by_address: true,
    commented: |line| format!("({})\n", line.replace(['(', ')'], " ")),
};

impl Grammar {
    /// Grammar of a language.
    pub fn of(dialect: Dialect) -> &'static Grammar {
        match dialect {
            Dialect::Nct => &NCT,
            Dialect::Sinumerik => &SINUMERIK,
        }
    }
}

impl Program {
    /// What is peculiar to its language.
    pub(crate) fn grammar(&self) -> &'static Grammar {
        Grammar::of(self.dialect)
    }
}
