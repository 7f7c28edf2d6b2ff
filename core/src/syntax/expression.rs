//! Expressions by precedence climbing; each dialect gives its operators and operands.

use super::reader::{DEPTH, Node, Parsed, Reader};
use super::tree::{Expr, Operator};
use crate::own;

/// How tightly an operator binds; higher binds tighter.
pub(super) type Strength = u8;

/// Reads an expression whose operators bind at least so tightly; 0: a whole one. Ends directly behind its last byte.
pub(super) fn expression(reader: &mut Reader, least: Strength) -> Parsed<Node> {
    if reader.depth >= DEPTH {
        return Err(&own::SYNTAX_DEPTH);
    }
    reader.depth += 1;
    let outcome = chain(reader, least);
    reader.depth -= 1;
    outcome
}

fn chain(reader: &mut Reader, least: Strength) -> Parsed<Node> {
    reader.blanks();
    let start = reader.at;
    let mut left = (reader.grammar.operand)(reader)?;
    loop {
        let behind = reader.at;
        reader.blanks();
        let found = (reader.grammar.operator)(reader);
        let Some((operator, strength, length)) = found.filter(|(_, strength, _)| *strength >= least) else {
            reader.at = behind;
            return Ok(left);
        };
        reader.at += length;
        let right = expression(reader, strength + 1)?;
        left = reader.push(start, Expr::Binary(left.id, operator, right.id), left.height.max(right.height) + 1)?;
    }
}

/// A sign or `NOT` before an operand that binds this tightly.
pub(super) fn unary(reader: &mut Reader, operator: Operator, length: usize, strength: Strength) -> Parsed<Node> {
    let start = reader.at;
    reader.at += length;
    let inner = expression(reader, strength)?;
    reader.push(start, Expr::Unary(operator, inner.id), inner.height + 1)
}
