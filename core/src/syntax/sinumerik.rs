//! Words of the SINUMERIK language.

use super::bytes::{in_name, is_letter, starts_name};
use super::expression::{Strength, expression};
use super::keyword::{ADDRESSES, Keyword, MEASURED, MODES, OF_AXIS, TYPES, is_one_of};
use super::language::{BY_PATH, CALL};
use super::reader::{Expect, Parsed, Reader};
use super::sinumerik_expression::{constant, foreign_exponent, index, list, text};
use super::tree::{Expr, ExprId, WordKind};
use super::{keyword, number};
use crate::diagnostic::Span;
use crate::own;

/// Reads one word, or steps over a separator of a declaration.
pub(super) fn word(reader: &mut Reader) -> Parsed<()> {
    let first = reader.byte(0);
    let declared = !matches!(reader.expect, Expect::Words | Expect::Constants);
    if first.is_ascii_alphabetic() && !declared && matches!(reader.byte(1), b'0'..=b'9' | b'.' | b'+' | b'-') {
        return short(reader);
    }
    if starts_name(first) {
        return named(reader);
    }
    other(reader)
}

/// What begins with no letter: header, constant, separator.
fn other(reader: &mut Reader) -> Parsed<()> {
    let start = reader.at;
    let first = reader.byte(0);
    let declaring = matches!(reader.expect, Expect::Definition | Expect::Parameters);
    let constant = match first {
        b'%' if reader.tree.words.len() == reader.first => {
            let rest = reader.rest();
            reader.at += rest.iter().position(|byte| matches!(byte, b';' | b' ' | b'\t')).unwrap_or(rest.len());
            return reader.word(start, WordKind::Header);
        }
        b'"' => text(reader)?,
        b',' if declaring => {
            reader.at += 1;
            return Ok(());
        }
        b')' if reader.expect == Expect::Parameters => {
            reader.at += 1;
            reader.expect = Expect::Words;
            return Ok(());
        }
        _ if reader.expect == Expect::Constants || (declaring && first.is_ascii_digit()) => expression(reader, 0)?,
        b',' => return Err(&own::SYNTAX_COMMA),
        _ => return Err(&own::SYNTAX_UNKNOWN),
    };
    reader.word(start, WordKind::Constant(constant.id))
}

/// One letter and a number: `X10`, `G54`, `S1=500`, `R10=…`, `L10`, `N100:`.
fn short(reader: &mut Reader) -> Parsed<()> {
    let start = reader.at;
    let letter = reader.byte(0);
    let signed = matches!(reader.byte(1), b'+' | b'-');
    reader.at += 1 + usize::from(signed);
    let number_start = start + 1;
    let (value, length) = number::with_exponent(reader.rest()).ok_or(&own::SYNTAX_NUMBER)?;
    reader.at += length;
    let name = Span { start: start as u32, end: number_start as u32 };
    let whole = !signed && reader.text(reader.from(number_start)).iter().all(|byte| byte.is_ascii_digit());
    if whole
        && matches!(reader.byte(0), b'=' | b' ' | b'\t' | b':' | b'(' | b'[' | b'_')
        && let Some(done) = extended(reader, start, name, value)
    {
        return done;
    }
    foreign_number(reader)?;
    if whole && letter.eq_ignore_ascii_case(&b'L') {
        let name = reader.from(start);
        return reader.word(start, WordKind::Call { name, args: Box::default() });
    }
    let value = reader.number(number_start, value)?.id;
    reader.address(start, name, value)
}

/// A letter with a whole number that is a name or an extension: `S1=500`, `R10=`, `L10(…)`, `A1:`, `A1[2]=`; else none.
fn extended(reader: &mut Reader, start: usize, letter: Span, number: f64) -> Option<Parsed<()>> {
    let behind = reader.at;
    let name = reader.from(start);
    if reader.byte(0) == b':' && reader.tree.words.len() == reader.first && !reader.byte(1).is_ascii_digit() {
        return Some(finish_label(reader, start, name));
    }
    if in_name(reader.byte(0)) || reader.take(b'[') {
        reader.at = start;
        return Some(named(reader));
    }
    if reader.byte(0) == b'(' {
        return Some(call(reader, start, name));
    }
    if assigns(reader) {
        if reader.text(letter).eq_ignore_ascii_case(b"R") {
            return Some(assign(reader, start, name, Box::default()));
        }
        let extension = (number <= f64::from(u32::MAX)).then_some(number as u32);
        return Some(address(reader, start, letter, extension));
    }
    reader.at = behind;
    None
}

/// A name: keyword, label, assignment, address, call.
fn named(reader: &mut Reader) -> Parsed<()> {
    let start = reader.at;
    let name = reader.name();
    let text = reader.text(name);
    let labels = text.eq_ignore_ascii_case(b"ENDLABEL") && reader.byte(0) == b':';
    if let Some(kind) = keyword::find(text).filter(|_| !labels) {
        return keyword_word(reader, start, name, kind);
    }
    match reader.expect {
        Expect::Definition | Expect::Parameters => return declaration(reader, start, name),
        Expect::Procedure => return procedure(reader, start, name),
        _ => {}
    }
    if reader.byte(0) == b':' && reader.tree.words.len() == reader.first && text.first() != Some(&b'$') {
        return finish_label(reader, start, name);
    }
    let (index, _) = index(reader)?;
    if assigns(reader) {
        let counts = reader.expect == Expect::Counter;
        reader.expect = if counts { Expect::Words } else { reader.expect };
        let letters = !text.starts_with(b"_") && (text.len() == 1 || is_one_of(text, ADDRESSES));
        if index.is_empty() && !counts && letters {
            return address(reader, start, name, None);
        }
        return assign(reader, start, name, index);
    }
    if !index.is_empty() {
        let of_axis = is_one_of(text, OF_AXIS);
        let called = WordKind::Call { name, args: index };
        return if of_axis { reader.word(start, called) } else { Err(&own::SYNTAX_EQUALS) };
    }
    if text.len() == 1 && text != b"_" {
        return spaced(reader, start, name);
    }
    if reader.expect == Expect::Constants {
        let value = reader.push(start, Expr::Name { name, index }, 1)?.id;
        return reader.word(start, WordKind::Constant(value));
    }
    call(reader, start, name)
}

fn finish_label(reader: &mut Reader, start: usize, name: Span) -> Parsed<()> {
    reader.at += 1;
    reader.word(start, WordKind::Label(name))
}

/// Steps over `=` (not `==`) and blanks around it; else stays.
fn assigns(reader: &mut Reader) -> bool {
    let behind = reader.at;
    reader.blanks();
    if reader.byte(0) == b'=' && reader.byte(1) != b'=' {
        reader.at += 1;
        reader.blanks();
        return true;
    }
    reader.at = behind;
    false
}

fn assign(reader: &mut Reader, start: usize, name: Span, index: Box<[ExprId]>) -> Parsed<()> {
    let value = value(reader)?;
    reader.word(start, WordKind::Assign { name, index, value })
}

fn value(reader: &mut Reader) -> Parsed<ExprId> {
    if reader.done() {
        return Err(&own::SYNTAX_VALUE);
    }
    let value = expression(reader, 0)?;
    foreign_number(reader)?;
    Ok(value.id)
}

/// Numbers as other languages write them: `12,5` and `1e-3`.
fn foreign_number(reader: &Reader) -> Parsed<()> {
    if reader.byte(0) == b',' && reader.expect == Expect::Words && reader.byte(1).is_ascii_digit() {
        return Err(&own::SYNTAX_COMMA);
    }
    match reader.at.checked_sub(1).and_then(|at| reader.source.get(at)).is_some_and(u8::is_ascii_digit) {
        true => foreign_exponent(reader),
        false => Ok(()),
    }
}

/// The right side of an address: a value, perhaps in `IC(…)`.
fn address(reader: &mut Reader, start: usize, name: Span, extension: Option<u32>) -> Parsed<()> {
    let right = reader.at;
    let mut mode = None;
    if is_letter(reader.byte(0)) {
        let word = reader.name();
        if is_one_of(reader.text(word), MODES) && reader.take(b'(') {
            mode = Some(word);
        } else {
            reader.at = right;
        }
    }
    let value = value(reader)?;
    if mode.is_some() && !reader.take(b')') {
        return Err(&own::SYNTAX_BRACKET);
    }
    reader.word(start, WordKind::Address { name, extension, mode, value })
}

/// A letter, blanks, a number: `X 10`.
fn spaced(reader: &mut Reader, start: usize, name: Span) -> Parsed<()> {
    reader.blanks();
    let value_start = reader.at;
    reader.at += usize::from(matches!(reader.byte(0), b'+' | b'-'));
    let value = constant(reader, value_start, number::with_exponent).map_err(|_| &own::SYNTAX_VALUE)?;
    reader.address(start, name, value.id)
}

/// `NAME`, `NAME(…)`; behind `PCALL` a path may stand before the next name.
fn call(reader: &mut Reader, start: usize, name: Span) -> Parsed<()> {
    let brackets = reader.take(b'(');
    let args = if brackets { list(reader, b')')?.0 } else { Box::default() };
    reader.word(start, WordKind::Call { name, args })?;
    if !brackets && reader.text(name).eq_ignore_ascii_case(BY_PATH.as_bytes()) {
        folders(reader);
    }
    if !brackets && reader.text(name).eq_ignore_ascii_case(CALL.as_bytes()) && joins(reader.rest()) {
        reader.blanks();
        let start = reader.at;
        let path = expression(reader, 0)?.id;
        reader.word(start, WordKind::Constant(path))?;
    }
    Ok(())
}

/// Whether texts are joined before the comment of a block: `CALL FOLDER<<"_N_PART_SPF"`.
fn joins(rest: &[u8]) -> bool {
    let mut quoted = false;
    for pair in rest.windows(2) {
        match pair {
            [b'"', _] => quoted = !quoted,
            [b';', _] if !quoted => return false,
            b"<<" if !quoted => return true,
            _ => {}
        }
    }
    false
}

/// Steps over the folders of a path, up to the name of the program: `PCALL /_N_WKS_DIR/_N_PART_WPD/HOLE(1)`.
fn folders(reader: &mut Reader) {
    reader.blanks();
    if reader.byte(0) != b'/' {
        return;
    }
    let rest = reader.rest();
    let path = rest.iter().take_while(|byte| in_name(**byte) || **byte == b'/').count();
    reader.at += rest.iter().take(path).rposition(|byte| *byte == b'/').map_or(0, |slash| slash + 1);
}

fn keyword_word(reader: &mut Reader, start: usize, name: Span, kind: Keyword) -> Parsed<()> {
    let behind = reader.at;
    reader.blanks();
    let more = !reader.done() && reader.byte(0) != b';';
    let opens = reader.byte(0) == b'(';
    reader.at = behind;
    let value = match kind {
        Keyword::Value => Some(expression(reader, 0)?.id),
        Keyword::Target => Some(target(reader)?),
        Keyword::Repeat if more => Some(target(reader)?),
        Keyword::Return if opens => Some(arguments(reader)?),
        Keyword::Operator => return Err(&own::SYNTAX_OPERATOR),
        _ => None,
    };
    reader.expect = match kind {
        Keyword::For => Expect::Counter,
        Keyword::Of => Expect::Constants,
        Keyword::Definition => Expect::Definition,
        Keyword::Procedure => Expect::Procedure,
        _ => reader.expect,
    };
    reader.word(start, WordKind::Keyword { name, value })
}

/// The list in brackets behind `RET`.
fn arguments(reader: &mut Reader) -> Parsed<ExprId> {
    reader.blanks();
    let start = reader.at;
    reader.at += 1;
    let (items, height) = list(reader, b')')?;
    Ok(reader.push(start, Expr::List(items), height + 1)?.id)
}

/// Where a jump or a repetition leads: what gives a label or a number, or the number of a main block as that is
/// written,
/// `:20`.
fn target(reader: &mut Reader) -> Parsed<ExprId> {
    reader.blanks();
    if reader.byte(0) != b':' || !reader.byte(1).is_ascii_digit() {
        return Ok(expression(reader, 0)?.id);
    }
    let start = reader.at;
    reader.at += 1;
    while reader.byte(0).is_ascii_digit() {
        reader.at += 1;
    }
    let name = reader.from(start);
    Ok(reader.push(start, Expr::Name { name, index: Box::default() }, 1)?.id)
}

/// A type, or a declared name with its sizes and first value.
fn declaration(reader: &mut Reader, start: usize, name: Span) -> Parsed<()> {
    if is_one_of(reader.text(name), MEASURED) && stands_before_a_number(reader) {
        let value = expression(reader, STRONGEST)?.id;
        return reader.word(start, WordKind::Keyword { name, value: Some(value) });
    }
    let is_type = is_one_of(reader.text(name), TYPES);
    let (index, _) = index(reader)?;
    if is_type {
        return reader.word(start, WordKind::Keyword { name, value: index.first().copied() });
    }
    let value = if assigns(reader) { Some(value(reader)?) } else { None };
    reader.word(start, WordKind::Declare { name, index, value })
}

/// No operator binds so tightly: what is read with it is one operand.
const STRONGEST: Strength = Strength::MAX;

/// Whether a number comes next, with or without a sign: `APR 7`, `LLI -10`. Else the word is a name.
fn stands_before_a_number(reader: &mut Reader) -> bool {
    let behind = reader.at;
    reader.blanks();
    let signed = usize::from(matches!(reader.byte(0), b'+' | b'-'));
    let first = reader.byte(signed);
    let number = reader.at > behind && (first.is_ascii_digit() || first == b'.' || first == b'\'');
    if !number {
        reader.at = behind;
    }
    number
}

/// The name after `PROC` or `EXTERN`; the opening bracket belongs to it.
fn procedure(reader: &mut Reader, start: usize, name: Span) -> Parsed<()> {
    reader.word(start, WordKind::Declare { name, index: Box::default(), value: None })?;
    reader.expect = if reader.take(b'(') { Expect::Parameters } else { Expect::Words };
    Ok(())
}
