//! Words of the NCT language.

use super::expression::expression;
use super::nct_expression::{bracket, decimal_comma, operator, variable};
use super::number;
use super::reader::{Parsed, Reader};
use super::tree::{Expr, ExprId, WordKind};
use crate::own;

pub(super) fn word(reader: &mut Reader) -> Parsed<()> {
    let first = reader.byte(0);
    if reader.tree.words.len() == reader.first && begins_program(reader, first) {
        return header(reader);
    }
    match first {
        b'#' => assignment(reader),
        b',' if reader.byte(1).is_ascii_alphabetic() => address(reader, 2),
        _ if !first.is_ascii_alphabetic() => Err(&own::SYNTAX_UNKNOWN),
        _ if reader.byte(1).is_ascii_alphabetic() => keyword(reader),
        _ => address(reader, 1),
    }
}

/// Whether a program begins here: `%`, `%O0110`, `O0110`, `:0110`.
fn begins_program(reader: &Reader, first: u8) -> bool {
    first == b'%' || matches!(first, b'O' | b'o' | b':') && reader.byte(1).is_ascii_digit()
}

fn header(reader: &mut Reader) -> Parsed<()> {
    let start = reader.at;
    reader.at += 1 + reader.rest().iter().skip(1).take_while(|byte| byte.is_ascii_alphanumeric()).count();
    reader.word(start, WordKind::Header)
}

/// `#100=…`, `#[…]=…`.
fn assignment(reader: &mut Reader) -> Parsed<()> {
    let start = reader.at;
    let target = variable(reader)?;
    let Some(Expr::Name { name, index }) = reader.tree.exprs.get(target.id as usize).cloned() else {
        return Err(&own::SYNTAX_OPERAND);
    };
    if !reader.take(b'=') {
        return Err(&own::SYNTAX_EQUALS);
    }
    reader.blanks();
    if reader.done() {
        return Err(&own::SYNTAX_VALUE);
    }
    let value = expression(reader, 0)?.id;
    reader.word(start, WordKind::Assign { name, index, value })
}

/// `X10`, `X-10.`, `X#100`, `X-#1`, `X[…]`.
fn address(reader: &mut Reader, letters: usize) -> Parsed<()> {
    let start = reader.at;
    reader.at += letters;
    let name = reader.from(start);
    reader.blanks();
    let value = plain(reader)?;
    reader.address(start, name, value)
}

/// A number with its sign, a variable or a bracket; never a whole expression: `X10-5` is no word.
fn plain(reader: &mut Reader) -> Parsed<ExprId> {
    let start = reader.at;
    let sign = usize::from(matches!(reader.byte(0), b'+' | b'-'));
    let first = reader.byte(sign);
    if first.is_ascii_digit() || first == b'.' {
        reader.at += sign;
        let (value, length) = number::decimal(reader.rest()).ok_or(&own::SYNTAX_NUMBER)?;
        reader.at += length;
        decimal_comma(reader)?;
        return Ok(reader.number(start, value)?.id);
    }
    if sign == 1 || matches!(first, b'#' | b'[') {
        return Ok(expression(reader, 12)?.id);
    }
    Err(&own::SYNTAX_VALUE)
}

/// `IF[…]`, `WHILE[…]`, `DO1`, `END1`, `GOTO 100`, `GOTO #1+1`, `THEN`.
fn keyword(reader: &mut Reader) -> Parsed<()> {
    const WORDS: &[(&[u8], Takes)] = &[
        (b"WHILE", Takes::Operand),
        (b"GOTO", Takes::Expression),
        (b"THEN", Takes::Nothing),
        (b"END", Takes::Operand),
        (b"IF", Takes::Operand),
        (b"DO", Takes::Operand),
    ];
    let start = reader.at;
    let (word, takes) = WORDS.iter().find(|(word, _)| reader.begins(word)).ok_or(&own::SYNTAX_UNKNOWN)?;
    reader.at += word.len();
    let name = reader.from(start);
    reader.blanks();
    let value = match takes {
        Takes::Nothing => None,
        Takes::Expression if reader.done() => return Err(&own::SYNTAX_VALUE),
        Takes::Expression => Some(expression(reader, 0)?.id),
        Takes::Operand => Some(operand_alone(reader)?),
    };
    reader.word(start, WordKind::Keyword { name, value })
}

/// What stands behind a keyword.
enum Takes {
    Nothing,
    /// A number, a variable or a bracket.
    Operand,
    /// A formula: where it leads only the whole of it tells (N 188).
    Expression,
}

/// A number, a variable or a bracket that no operator follows: a part of a formula decides nothing.
fn operand_alone(reader: &mut Reader) -> Parsed<ExprId> {
    let value = if reader.byte(0) == b'[' { bracket(reader)?.id } else { plain(reader)? };
    let behind = reader.at;
    reader.blanks();
    match operator(reader) {
        Some(_) => Err(&own::SYNTAX_UNKNOWN),
        None => {
            reader.at = behind;
            Ok(value)
        }
    }
}
