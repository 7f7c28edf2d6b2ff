//! Lines: block number, skip level, words, comment.

use super::macros;
use super::plain::Plain;
use super::reader::{Expect, Reader};
use super::tree::{Block, Program, SyntaxError, WordKind};
use crate::control::definitions::Macros;
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::own;
use std::sync::Arc;

/// What some editors write before the text of a file.
pub(super) const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Ends a text in files of old editors and of transfers (Ctrl-Z).
const END_OF_FILE: u8 = 0x1A;

/// Lines between two tellings of how far the work is.
pub(crate) const BETWEEN: usize = 8192;

/// Bytes of a program that are read, as places are u32: 4 GB; the rest is kept.
pub const LARGEST: u32 = u32::MAX;

/// Reads a program. Never fails: what is not understood is marked in the tree.
pub fn read(dialect: Dialect, source: &[u8]) -> Program {
    read_on(dialect, source, &Arc::default())
}

/// Reads a program on a machine that has these macros.
pub fn read_on(dialect: Dialect, source: &[u8], macros: &Arc<Macros>) -> Program {
    read_all(dialect, &Arc::new(source.to_vec()), macros, false, &mut |_| {})
}

impl Program {
    /// Another text on the same machine, plain motions left as text.
    pub fn again(&self, text: &[u8]) -> Program {
        read_lean(self.dialect, text, &self.macros)
    }
}

/// Reads a program whose calls are looked for, or that is run: plain motions stay text, see [`Program::plain`].
pub fn read_lean(dialect: Dialect, source: &[u8], macros: &Arc<Macros>) -> Program {
    read_held(dialect, &Arc::new(source.to_vec()), macros, &mut |_| {})
}

/// The same of a text that somebody else holds too, telling from time to time which share of it is read.
pub fn read_held(dialect: Dialect, source: &Arc<Vec<u8>>, macros: &Arc<Macros>, told: &mut dyn FnMut(f64)) -> Program {
    read_all(dialect, source, macros, true, told)
}

fn read_all(
    dialect: Dialect,
    source: &Arc<Vec<u8>>,
    macros: &Arc<Macros>,
    lean: bool,
    told: &mut dyn FnMut(f64),
) -> Program {
    let (first, own) = read_with(dialect, source, macros, lean, told);
    // definition files of the text count in the whole of it
    let tree = own.map_or(first, |all| read_with(dialect, source, &all, lean, told).0);
    Program { macros: Arc::clone(macros), ..tree }
}

/// Reads a program, with all macros that count everywhere where some were found behind lines that may use them.
fn read_with(
    dialect: Dialect,
    source: &Arc<Vec<u8>>,
    macros: &Arc<Macros>,
    lean: bool,
    told: &mut dyn FnMut(f64),
) -> (Program, Option<Arc<Macros>>) {
    let whole = source.get(..LARGEST as usize).unwrap_or(source);
    let readable = before_end(whole);
    let mut reader = Reader::new(dialect, readable, source, lean);
    reader.macros.everywhere = Arc::clone(macros);
    while reader.at < readable.len() || reader.tree.blocks.is_empty() {
        let start = reader.at;
        let length = reader.source.get(start..).unwrap_or_default().iter().position(|byte| *byte == b'\n');
        let stop = length.map_or(readable.len(), |length| start + length);
        reader.end = stop - usize::from(stop > start && readable.get(stop - 1) == Some(&b'\r'));
        let rest = reader.rest();
        let alone = rest.iter().position(|byte| *byte == b'\r');
        let ends = |at: &usize| rest.iter().skip(*at).all(u8::is_ascii_whitespace);
        if let Some(at) = alone.filter(|at| !ends(at)).map(|at| (start + at) as u32) {
            // the control ends a block with a line feed only
            reader.tree.errors.push(SyntaxError { span: Span { start: at, end: at + 1 }, sentence: &own::LONE_RETURN });
        }
        line(&mut reader);
        reader.at = stop + 1;
        if reader.tree.blocks.len().is_multiple_of(BETWEEN) {
            told(reader.at as f64 / readable.len() as f64);
        }
    }
    if whole.len() < source.len() && readable.len() == whole.len() {
        let span = Span { start: LARGEST - 1, end: LARGEST };
        reader.tree.errors.push(SyntaxError { span, sentence: &own::SYNTAX_TOO_LARGE });
    }
    reader.tree.errors.extend(behind_end(whole, readable.len()));
    let found = reader.macros.late.then_some(reader.macros.everywhere);
    (reader.tree, found)
}

/// What counts of a file.
pub(super) fn before_end(whole: &[u8]) -> &[u8] {
    let end = whole.iter().position(|byte| *byte == END_OF_FILE).or_else(|| filled(whole));
    end.and_then(|end| whole.get(..end)).unwrap_or(whole)
}

/// Where zeros begin with which a file is filled up to its end.
fn filled(whole: &[u8]) -> Option<usize> {
    let last = whole.iter().rposition(|byte| *byte != 0)?;
    (last + 1 < whole.len()).then_some(last + 1)
}

/// What stands behind the end of file, where it is more than blanks and further ends.
fn behind_end(whole: &[u8], end: usize) -> Option<SyntaxError> {
    let filler = |byte: &u8| byte.is_ascii_whitespace() || matches!(*byte, END_OF_FILE | 0);
    let first = whole.get(end..).unwrap_or_default().iter().position(|byte| !filler(byte))?;
    let span = Span { start: (end + first) as u32, end: whole.len() as u32 };
    Some(SyntaxError { span, sentence: &own::TEXT_BEHIND_END })
}

fn line(reader: &mut Reader) {
    let span = Span { start: reader.at as u32, end: reader.end as u32 };
    reader.first = reader.tree.words.len();
    reader.expect = Expect::Words;
    if reader.at == 0 && reader.rest().starts_with(BYTE_ORDER_MARK) {
        reader.at = BYTE_ORDER_MARK.len();
    }
    reader.blanks();
    let before = skip(reader);
    let number = number(reader);
    let skip = before.or_else(|| skip(reader));
    if skip.is_none() && is_plain(reader) {
        let words = reader.first as u32..reader.first as u32;
        reader.tree.blocks.push(Block { span, number, skip, words, comment: None, plain: true });
        return;
    }
    reader.blanks();
    if reader.grammar.macros {
        macros::begins(reader);
    }
    let comment = match reader.grammar.macros && !macros::define(reader) {
        true => macros::read(reader).unwrap_or_else(|| words(reader)),
        false => words(reader),
    };
    let words = reader.first as u32..reader.tree.words.len() as u32;
    reader.tree.blocks.push(Block { span, number, skip, words, comment, plain: false });
}

/// Whether the rest of a line is left as text. A macro could stand for a part of it, and the first line have a mark.
fn is_plain(reader: &Reader) -> bool {
    let alone = reader.lean && reader.macros.concerns_nothing() && !reader.tree.blocks.is_empty();
    alone && Plain::of(reader.rest(), 0).is_some()
}

/// Reads what is left of a line; its first comment comes back.
pub(super) fn words(reader: &mut Reader) -> Option<Span> {
    let mut comment = None;
    reader.blanks();
    while !reader.done() {
        match take_comment(reader) {
            Some(found) => comment = comment.or(Some(found)),
            None => word(reader),
        }
        reader.blanks();
    }
    comment
}

fn word(reader: &mut Reader) {
    let start = reader.at;
    let Program { words, exprs, places, .. } = &reader.tree;
    let (words, exprs, places, expect) = (words.len(), exprs.len(), places.len(), reader.expect);
    if let Err(key) = (reader.grammar.word)(reader) {
        let place = reader.at;
        reader.tree.words.truncate(words);
        reader.tree.exprs.truncate(exprs);
        reader.tree.places.truncate(places);
        reader.list.clear();
        reader.depth = 0;
        reader.expect = expect;
        reader.unknown(start, place, key, reader.grammar.comment);
    }
}

/// `/`, `/2` before or after the block number.
fn skip(reader: &mut Reader) -> Option<u8> {
    if reader.byte(0) != b'/' {
        return None;
    }
    reader.at += 1;
    let level = Some(reader.byte(0)).filter(|digit| digit.is_ascii_digit()).map(|digit| digit - b'0');
    reader.at += usize::from(level.is_some());
    reader.blanks();
    level.or(Some(0))
}

/// `N10`; SINUMERIK also `:10`.
fn number(reader: &mut Reader) -> Option<Span> {
    let first = reader.byte(0);
    let main = first == b':' && reader.grammar.main_blocks;
    if !(main || first.eq_ignore_ascii_case(&b'N')) || !reader.byte(1).is_ascii_digit() {
        return None;
    }
    let start = reader.at;
    reader.at += 1;
    while reader.byte(0).is_ascii_digit() {
        reader.at += 1;
    }
    let span = reader.from(start);
    reader.blanks();
    Some(span)
}

fn take_comment(reader: &mut Reader) -> Option<Span> {
    let start = reader.at;
    match reader.byte(0) {
        b';' => reader.at = reader.end,
        b'(' if reader.grammar.comment == b'(' => {
            let close = reader.rest().iter().position(|byte| *byte == b')');
            reader.at = close.map_or(reader.end, |length| start + length + 1);
            if close.is_none() {
                let span = reader.from(start);
                reader.tree.errors.push(SyntaxError { span, sentence: &own::SYNTAX_COMMENT });
            }
        }
        _ => return None,
    }
    Some(reader.from(start))
}

/// Whether a text is one value behind a name (SINUMERIK `_FA=…`) or address (NCT `D…`); `R1+` and `R1 M30` are not.
pub fn is_value(text: &str) -> bool {
    is_value_of(Dialect::Sinumerik, text) || is_value_of(Dialect::Nct, text)
}

/// Whether a text is one such value in this language.
pub fn is_value_of(dialect: Dialect, text: &str) -> bool {
    stands(dialect, if dialect == Dialect::Nct { "D" } else { "_X=" }, text)
}

fn stands(dialect: Dialect, before: &str, text: &str) -> bool {
    let source = format!("{before}{text}");
    let program = read(dialect, source.as_bytes());
    let ([word], [block]) = (&program.words[..], &program.blocks[..]) else { return false };
    let whole = word.span.start == 0 && word.span.end as usize == source.len();
    let value = matches!(word.kind, WordKind::Assign { .. } | WordKind::Address { .. });
    whole && value && block.comment.is_none() && program.errors.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn one_value_and_nothing_more() {
        for text in
            ["R1", "-R1", "(R1+2)*3", "_OVR[4]-0.5", "$AA_IW[X]", "SQRT(R1)", "#500", "[[#1+2]/2]", "R1 + 2", "1.5EX-3"]
        {
            assert!(is_value(text), "{text}");
        }
        for text in [
            "R1+", "(((", "R1 M30", "a b", "R1;2", "R1 ;2", "R1\nM30", "R1=2", "(R1", "R1)", "5 mm", "R[1", "1e5",
            "\"", "", "R1,R2", "#1+#2", "[#1+2]/2",
        ] {
            assert!(!is_value(text), "{text}");
        }
    }
}
