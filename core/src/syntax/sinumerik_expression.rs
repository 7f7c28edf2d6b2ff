//! Operators, operands and lists of the SINUMERIK language.
//!
//! Order of the operators as in the control's own table: `NOT`; `* / DIV MOD`; `+ -`; `B_AND`; `B_XOR`; `B_OR`; `AND`;
//! `XOR`; `OR`; `<<`; comparisons last. So `A == 1 AND B == 1` needs brackets.

use super::bytes::{in_name, starts_name};
use super::expression::{Strength, expression, unary};
use super::reader::{Expect, Node, Parsed, Reader};
use super::tree::{Expr, ExprId, Operator};
use super::{keyword, number};
use crate::own;

const COMPARISON: Strength = 1;
const JOIN: Strength = 2;
const UNARY: Strength = 12;

/// The operator at the present place with its strength and length.
pub(super) fn operator(reader: &Reader) -> Option<(Operator, Strength, usize)> {
    Some(match (reader.byte(0), reader.byte(1)) {
        (b'+', _) => (Operator::Plus, 9, 1),
        (b'-', _) => (Operator::Minus, 9, 1),
        (b'*', _) => (Operator::Times, 10, 1),
        (b'/', _) => (Operator::Over, 10, 1),
        (b':', next) if starts_name(next) => (Operator::Chain, 11, 1),
        (b'<', b'<') => (Operator::Join, JOIN, 2),
        (b'<', b'=') => (Operator::LessEqual, COMPARISON, 2),
        (b'<', b'>') => (Operator::NotEqual, COMPARISON, 2),
        (b'<', _) => (Operator::Less, COMPARISON, 1),
        (b'>', b'=') => (Operator::GreaterEqual, COMPARISON, 2),
        (b'>', _) => (Operator::Greater, COMPARISON, 1),
        (b'=', b'=') => (Operator::Equal, COMPARISON, 2),
        (b'A' | b'a' | b'O' | b'o' | b'X' | b'x' | b'D' | b'd' | b'M' | b'm' | b'B' | b'b', _) => return word(reader),
        _ => return None,
    })
}

fn word(reader: &Reader) -> Option<(Operator, Strength, usize)> {
    const WORDS: &[(&[u8], Operator, Strength)] = &[
        (b"AND", Operator::And, 5),
        (b"OR", Operator::Or, 3),
        (b"XOR", Operator::Xor, 4),
        (b"DIV", Operator::Div, 10),
        (b"MOD", Operator::Mod, 10),
        (b"B_AND", Operator::BitAnd, 8),
        (b"B_OR", Operator::BitOr, 6),
        (b"B_XOR", Operator::BitXor, 7),
    ];
    let length = reader.rest().iter().take(6).take_while(|byte| in_name(**byte)).count();
    let name = reader.rest().get(..length)?;
    let (word, operator, strength) = WORDS.iter().find(|(word, ..)| name.eq_ignore_ascii_case(word))?;
    Some((*operator, *strength, word.len()))
}

pub(super) fn operand(reader: &mut Reader) -> Parsed<Node> {
    let first = reader.byte(0);
    if first.is_ascii_digit() || first == b'.' {
        let number = constant(reader, reader.at, number::with_exponent)?;
        return foreign_exponent(reader).map(|()| number);
    }
    if starts_name(first) {
        return named(reader);
    }
    match first {
        b'+' => unary(reader, Operator::Plus, 1, UNARY),
        b'-' => unary(reader, Operator::Minus, 1, UNARY),
        b'<' if reader.byte(1) == b'<' => unary(reader, Operator::Join, 2, JOIN + 1),
        b'(' => brackets(reader),
        b'"' => text(reader),
        b'\'' if reader.byte(2) == b'\'' => quoted(reader, 1),
        b'\'' => constant(reader, reader.at, number::quoted),
        _ => Err(&own::SYNTAX_OPERAND),
    }
}

/// A number; its sign may stand from `start` on.
pub(super) fn constant(reader: &mut Reader, start: usize, read: fn(&[u8]) -> Option<(f64, usize)>) -> Parsed<Node> {
    let (value, length) = read(reader.rest()).ok_or(&own::SYNTAX_NUMBER)?;
    reader.at += length;
    reader.number(start, value)
}

/// An exponent as other languages write it, `1e-3`, behind a number: it would be read as 1 and an address E.
pub(super) fn foreign_exponent(reader: &Reader) -> Parsed<()> {
    if reader.exponent() { Err(&own::SYNTAX_EXPONENT) } else { Ok(()) }
}

/// `"…"`.
pub(super) fn text(reader: &mut Reader) -> Parsed<Node> {
    let length = reader.rest().iter().skip(1).position(|byte| *byte == b'"').ok_or(&own::SYNTAX_TEXT)?;
    quoted(reader, length)
}

/// So many characters between quotes.
fn quoted(reader: &mut Reader, length: usize) -> Parsed<Node> {
    let start = reader.at + 1;
    reader.at = start + length;
    let span = reader.from(start);
    reader.at += 1;
    reader.push(start - 1, Expr::Text(span), 1)
}

/// A variable, a function call, `NOT`.
fn named(reader: &mut Reader) -> Parsed<Node> {
    let start = reader.at;
    let name = reader.name();
    let text = reader.text(name);
    if keyword::find(text).is_some() {
        let operator = match text.len() {
            3 if text.eq_ignore_ascii_case(b"NOT") => Operator::Not,
            5 if text.eq_ignore_ascii_case(b"B_NOT") => Operator::BitNot,
            _ => return Err(&own::SYNTAX_OPERAND),
        };
        reader.at = start;
        return unary(reader, operator, text.len(), UNARY);
    }
    if reader.take(b'(') {
        let (arguments, height) = list(reader, b')')?;
        return reader.push(start, Expr::Call(name, arguments), height + 1);
    }
    let (index, height) = index(reader)?;
    reader.push(start, Expr::Name { name, index }, height + 1)
}

/// `[1,X,TR]`, if there is one, with the height of its tallest element; a parameter may leave a size open: `F[]`.
pub(super) fn index(reader: &mut Reader) -> Parsed<(Box<[ExprId]>, u16)> {
    if !reader.take(b'[') {
        return Ok((Box::default(), 0));
    }
    if reader.expect == Expect::Parameters && reader.take(b']') {
        let one = reader.push(reader.at, Expr::Omitted, 1)?;
        return Ok(([one.id].into(), one.height));
    }
    let (index, height) = list(reader, b']')?;
    if index.is_empty() || index.len() > 3 { Err(&own::SYNTAX_INDEX) } else { Ok((index, height)) }
}

/// `(…)`: a bracketed expression, or a list if there is a comma.
fn brackets(reader: &mut Reader) -> Parsed<Node> {
    let start = reader.at;
    reader.at += 1;
    reader.blanks();
    if reader.done() || matches!(reader.byte(0), b')' | b';') {
        return Err(&own::SYNTAX_OPERAND);
    }
    let (elements, height) = list(reader, b')')?;
    match elements[..] {
        [id] => Ok(reader.bracketed(start, Node { id, height })),
        _ => reader.push(start, Expr::List(elements), height + 1),
    }
}

/// Elements up to the closing bracket with the height of the tallest one; the opening bracket is already taken.
pub(super) fn list(reader: &mut Reader, close: u8) -> Parsed<(Box<[ExprId]>, u16)> {
    if reader.take(close) {
        return Ok((Box::default(), 0));
    }
    let (base, mut height) = (reader.list.len(), 0);
    loop {
        reader.blanks();
        if reader.done() || reader.byte(0) == b';' {
            return Err(&own::SYNTAX_BRACKET); // the block ends behind a comma or the opening bracket
        }
        let omitted = reader.byte(0) == b',' || reader.byte(0) == close;
        let element = if omitted { reader.push(reader.at, Expr::Omitted, 0)? } else { expression(reader, 0)? };
        height = height.max(element.height);
        reader.list.push(element.id);
        if reader.take(close) {
            return Ok((reader.list.drain(base..).collect(), height));
        }
        if !reader.take(b',') {
            return Err(&own::SYNTAX_BRACKET);
        }
    }
}
