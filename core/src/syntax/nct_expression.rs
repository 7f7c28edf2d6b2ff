//! Operators and operands of the NCT macro language: brackets are `[ ]`, variables `#100`, `#[…]`.

use super::expression::{Strength, expression, unary};
use super::keyword::is_one_of;
use super::number;
use super::reader::{Node, Parsed, Reader};
use super::tree::{Expr, Operator};
use crate::own;

const UNARY: Strength = 12;

/// The operator at the present place with its strength and length: `* / AND MOD`; `+ - OR XOR`; comparisons.
pub(super) fn operator(reader: &Reader) -> Option<(Operator, Strength, usize)> {
    const WORDS: &[(&[u8], Operator, Strength)] = &[
        (b"AND", Operator::And, 10),
        (b"MOD", Operator::Mod, 10),
        (b"XOR", Operator::Xor, 9),
        (b"OR", Operator::Or, 9),
        (b"EQ", Operator::Equal, 1),
        (b"NE", Operator::NotEqual, 1),
        (b"GT", Operator::Greater, 1),
        (b"LT", Operator::Less, 1),
        (b"GE", Operator::GreaterEqual, 1),
        (b"LE", Operator::LessEqual, 1),
        (b"+", Operator::Plus, 9),
        (b"-", Operator::Minus, 9),
        (b"*", Operator::Times, 10),
        (b"/", Operator::Over, 10),
    ];
    let (word, operator, strength) = WORDS.iter().find(|(word, ..)| reader.begins(word))?;
    Some((*operator, *strength, word.len()))
}

pub(super) fn operand(reader: &mut Reader) -> Parsed<Node> {
    let start = reader.at;
    match reader.byte(0) {
        b'+' => unary(reader, Operator::Plus, 1, UNARY),
        b'-' => unary(reader, Operator::Minus, 1, UNARY),
        b'[' => bracket(reader),
        b'#' => variable(reader),
        byte if byte.is_ascii_digit() || byte == b'.' => {
            let (value, length) = number::decimal(reader.rest()).ok_or(&own::SYNTAX_NUMBER)?;
            reader.at += length;
            decimal_comma(reader)?;
            if reader.exponent() {
                return Err(&own::SYNTAX_NO_EXPONENT); // in an expression no address E can stand
            }
            reader.number(start, value)
        }
        byte if byte.is_ascii_alphabetic() => function(reader),
        _ => Err(&own::SYNTAX_OPERAND),
    }
}

/// A decimal comma, as other languages write it; `,C1` behind a number is an address.
pub(super) fn decimal_comma(reader: &Reader) -> Parsed<()> {
    match (reader.byte(0), reader.byte(1).is_ascii_digit()) {
        (b',', true) => Err(&own::SYNTAX_COMMA),
        _ => Ok(()),
    }
}

/// `[…]`.
pub(super) fn bracket(reader: &mut Reader) -> Parsed<Node> {
    let start = reader.at;
    reader.at += 1;
    let inner = expression(reader, 0)?;
    if reader.take(b']') { Ok(reader.bracketed(start, inner)) } else { Err(&own::SYNTAX_BRACKET) }
}

/// `#100` as a name, `#[…]` and `##1` as the name `#` with an index.
pub(super) fn variable(reader: &mut Reader) -> Parsed<Node> {
    let start = reader.at;
    reader.at += 1;
    let number = reader.rest().iter().take_while(|byte| byte.is_ascii_digit()).count();
    if number > 0 {
        reader.at += number;
        let name = reader.from(start);
        return reader.push(start, Expr::Name { name, index: Box::default() }, 1);
    }
    let name = reader.from(start);
    let index = match reader.byte(0) {
        b'[' => bracket(reader)?,
        b'#' => expression(reader, UNARY)?,
        _ => return Err(&own::SYNTAX_OPERAND),
    };
    reader.push(start, Expr::Name { name, index: Box::new([index.id]) }, index.height + 1)
}

/// `SIN[…]`, `SQRT #1`, `ATAN[…]/[…]` (two arguments).
fn function(reader: &mut Reader) -> Parsed<Node> {
    const NAMES: &[&[u8]] = &[
        b"SIN", b"COS", b"TAN", b"ASIN", b"ACOS", b"ATAN", b"SQRT", b"ABS", b"ROUND", b"FIX", b"FUP", b"LN", b"EXP",
        b"BIN", b"BCD", b"ADP", b"NOT",
    ];
    let start = reader.at;
    reader.at += reader.rest().iter().take(6).take_while(|byte| byte.is_ascii_alphabetic()).count();
    let name = reader.from(start);
    if !is_one_of(reader.text(name), NAMES) {
        return Err(&own::SYNTAX_OPERAND);
    }
    let inner = expression(reader, UNARY)?;
    if reader.text(name).eq_ignore_ascii_case(b"ATAN") && reader.take(b'/') {
        let second = expression(reader, UNARY)?;
        let height = inner.height.max(second.height) + 1;
        return reader.push(start, Expr::Call(name, Box::new([inner.id, second.id])), height);
    }
    reader.push(start, Expr::Call(name, Box::new([inner.id])), inner.height + 1)
}
