//! What differs between the controls in how a program is run, chosen once by its language.

use super::{Datum, Interpreter, Motion, Words, expression, gcode, gcode::Instead, tool};
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::problem::Problem;
use crate::syntax::tree::Operator;

/// What is peculiar to the runs of a language.
pub struct Rules {
    /// The motion active before the first block.
    pub motion: Motion,
    /// Carries out a G function that the other language does not have; false: there is none.
    pub function: fn(&mut Interpreter, u16, &mut Words) -> bool,
    /// Passes over a G function that only the other language does not have either, and tells that; false: there is
    /// none.
    pub unsimulated: fn(&mut Interpreter, f64, Span) -> bool,
    /// What is done instead of a G function that is not simulated.
    pub instead: fn(f64) -> Option<Instead>,
    /// Takes T, D, H and M6 of a block.
    pub tool: fn(&mut Interpreter, &Words) -> Result<(), Problem>,
    /// What an operator gives where it is not that of both languages; the last is what it gives where one is vacant.
    pub operate: fn(Operator, f64, f64, Option<Datum>) -> Option<Datum>,
    /// `NOT` of a number.
    pub not: fn(f64) -> f64,
    /// Parts of words that ask for the position or write tool data: STOPRE, `$AA_IW[X]`, `$TC_DP6[1,1]`, NCT `#5041`.
    pub asks_for_position: &'static [&'static [u8]],
    /// The address of the radius of an arc.
    pub radius: &'static str,
    /// Addresses with which the path of a block has nothing to do.
    pub beside: &'static [&'static str],
    /// M functions that neither stop nor turn anything here.
    pub silent: &'static [i64],
}

static SINUMERIK: Rules = Rules {
    motion: Motion::Line,
    function: gcode::sinumerik,
    unsimulated: |_, _, _| false,
    instead: gcode::instead,
    tool: tool::sinumerik,
    operate: |operator, a, b, _| expression::nearly(operator, a, b),
    not: |a| f64::from(u8::from(a == 0.0)),
    asks_for_position: &[b"STOPRE", b"$A", b"$VA_", b"$TC_"],
    radius: "CR",
    beside: &[],
    silent: &[],
};

static NCT: Rules = Rules {
    motion: Motion::Rapid, // its programs move without F at first, C:1164
    function: gcode::nct,
    unsimulated: gcode::nct_unsimulated,
    instead: |_| None,
    tool: tool::nct,
    operate: |operator, a, b, vacant| vacant.or_else(|| expression::numbers(expression::bits(operator)?, a, b)),
    not: |a| !(a as i64) as f64,
    asks_for_position: &[b"#5", b"#["],
    radius: "R",
    beside: &["H", "P", "O", "N"],
    silent: &[55, 59],
};

impl Rules {
    /// Rules for programs of a language.
    pub fn of(dialect: Dialect) -> &'static Rules {
        match dialect {
            Dialect::Sinumerik => &SINUMERIK,
            Dialect::Nct => &NCT,
        }
    }
}

impl Interpreter {
    /// What is peculiar to runs of its language.
    pub fn rules(&self) -> &'static Rules {
        Rules::of(self.program.dialect)
    }
}
