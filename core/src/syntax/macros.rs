//! `DEFINE NAME AS …` gives a piece of text a name. A line that has such a name is read as if the text stood there; the
//! program keeps the name, and every place of what is read lies in the line as it is written.

use super::block;
use super::bytes::{in_name, is_blank, starts_name};
use super::grown;
use super::programs::{bare, is_definition};
use super::reader::{Parsed, Reader};
use super::tree::{Expr, SyntaxError, WordKind};
use crate::control::definitions::Macros;
use crate::diagnostic::Span;
use crate::own;
use crate::own::Own;
use std::ops::Range;
use std::sync::Arc;

const DEFINE: &[u8] = b"DEFINE";

/// Longest block in which macros are replaced, characters (the control takes 512).
pub const LONGEST: usize = 2000;

/// Deepest that macros name one another.
const LEVELS: usize = 50;

/// What replacing takes at most for each byte of a program, and for a short one.
const EFFORT: [usize; 2] = [8, 1_000_000];

/// The macros that count at a place of a program.
#[derive(Default)]
pub(super) struct Known {
    /// Of the machine, and of the definition files in the text.
    pub everywhere: Arc<Macros>,
    /// Of the program.
    own: Macros,
    /// Whether the lines are those of a definition file.
    defining: bool,
    /// What replacing has taken so far.
    spent: usize,
    /// Whether a definition file in the text has added one behind the first line.
    pub late: bool,
}

impl Known {
    fn find(&self, name: &[u8]) -> Option<&[u8]> {
        let name = String::from_utf8_lossy(name).to_ascii_uppercase();
        self.own.get(&name).or_else(|| self.everywhere.get(&name)).map(Vec::as_slice)
    }

    fn none(&self) -> bool {
        self.own.is_empty() && self.everywhere.is_empty()
    }

    /// Whether the lines are those of a program, and none of their words can stand for something else.
    pub fn concerns_nothing(&self) -> bool {
        self.none() && !self.defining
    }
}

/// A part of a line in which macros are replaced, with the place where it is written.
pub(super) struct Piece {
    /// Where it ends in the replaced line.
    pub end: usize,
    pub at: Span,
    /// Whether it is the text of a macro; else it stands there letter by letter.
    pub replaced: bool,
}

/// A line in which macros are replaced.
#[derive(Default)]
pub(super) struct Line {
    pub text: Vec<u8>,
    pub pieces: Vec<Piece>,
}

/// A header or a `PROC` begins a program: the macros of the one before do not count in it.
pub(super) fn begins(reader: &mut Reader) {
    let known = &mut reader.macros;
    match reader.source.get(reader.at..reader.end) {
        Some([b'%', name @ ..]) => {
            let end = name.iter().position(|byte| matches!(byte, b';' | b' ' | b'\t')).unwrap_or(name.len());
            let name = String::from_utf8_lossy(name.get(..end).unwrap_or_default()).to_ascii_uppercase();
            known.defining = is_definition(bare(&name));
            known.own.clear();
        }
        Some(line) if !known.own.is_empty() && first_word(line).eq_ignore_ascii_case(b"PROC") => known.own.clear(),
        _ => {}
    }
}

/// The name with which a text begins.
fn first_word(text: &[u8]) -> &[u8] {
    let end = text.iter().position(|byte| !in_name(*byte)).unwrap_or(text.len());
    text.get(..end).unwrap_or_default()
}

/// Takes a definition; false: the line is none.
pub(super) fn define(reader: &mut Reader) -> bool {
    if !first_word(reader.rest()).eq_ignore_ascii_case(DEFINE) || !is_blank(reader.byte(DEFINE.len())) {
        return false;
    }
    let start = reader.at;
    if let Err(sentence) = definition(reader) {
        let place = reader.at;
        reader.tree.words.truncate(reader.first);
        reader.unknown(start, place, sentence, reader.grammar.comment);
    }
    true
}

/// `DEFINE NAME AS …` as words: the first three as calls, the text as one constant.
fn definition(reader: &mut Reader) -> Parsed<()> {
    spoken(reader)?;
    reader.blanks();
    let name = spoken(reader)?;
    reader.blanks();
    let between = spoken(reader)?;
    if !reader.text(between).eq_ignore_ascii_case(b"AS") {
        return Err(&own::SYNTAX_DEFINE);
    }
    reader.blanks();
    let start = reader.at;
    let rest = reader.rest();
    let mut end = rest.len();
    let mut quoted = false;
    for (at, byte) in rest.iter().enumerate() {
        quoted ^= *byte == b'"';
        if *byte == b';' && !quoted {
            end = at;
            break;
        }
    }
    let text = rest.get(..end).unwrap_or_default().trim_ascii_end();
    reader.at = start + text.len();
    if text.is_empty() {
        return Err(&own::SYNTAX_DEFINE);
    }
    let name = String::from_utf8_lossy(reader.text(name)).to_ascii_uppercase();
    let known = &mut reader.macros;
    if known.defining {
        if known.everywhere.get(&name).is_none_or(|before| before != text) {
            Arc::make_mut(&mut known.everywhere).insert(name, text.to_owned());
            known.late = true;
        }
    } else {
        known.own.insert(name, text.to_owned());
    }
    let value = reader.push(start, Expr::Text(reader.from(start)), 1)?;
    reader.word(start, WordKind::Constant(value.id))
}

/// A name as a word of its own.
fn spoken(reader: &mut Reader) -> Parsed<Span> {
    let start = reader.at;
    let name = reader.name();
    if reader.text(name).first().is_none_or(u8::is_ascii_digit) {
        return Err(&own::SYNTAX_DEFINE);
    }
    reader.word(start, WordKind::Call { name, args: Box::default() })?;
    Ok(name)
}

/// Reads what is left of a line with its macros replaced; none: it has none, or they cannot be, which is told.
pub(super) fn read(reader: &mut Reader) -> Option<Option<Span>> {
    if reader.macros.none() {
        return None;
    }
    let rest = reader.rest();
    let first = names(rest).find(|name| text_at(rest, name).is_some_and(|name| reader.macros.find(name).is_some()))?;
    let start = reader.at;
    let room = u32::try_from(reader.tree.source.len() + reader.tree.replaced.text.len() + rest.len() + LONGEST);
    let found = if room.is_ok() { replaced(reader) } else { Err(&own::SYNTAX_MACRO_LONG) };
    let line = match found {
        Ok(line) => line,
        Err(sentence) if first.start == 0 => {
            reader.unknown(start, start, sentence, reader.grammar.comment);
            return Some(block::words(reader));
        }
        Err(sentence) => {
            let span = Span { start: (start + first.start) as u32, end: (start + first.end) as u32 };
            reader.tree.errors.push(SyntaxError { span, sentence });
            return None;
        }
    };
    let mut inner = Reader::new(reader.tree.dialect, &line.text, &Arc::default(), false);
    inner.end = line.text.len();
    let comment = block::words(&mut inner);
    let tree = inner.tree;
    Some(grown::take(&mut reader.tree, tree, &line, comment))
}

/// What is left of the line, macros replaced; what that takes counts, whether it can be done or not.
fn replaced(reader: &mut Reader) -> Parsed<Line> {
    let most = EFFORT[0].saturating_mul(reader.source.len()).saturating_add(EFFORT[1]);
    let mut work = Work { known: &reader.macros, left: most.saturating_sub(reader.macros.spent), open: Vec::new() };
    let line = written_out(reader.at, reader.rest(), &mut work);
    let left = work.left;
    reader.macros.spent = most - left;
    line
}

/// A text that begins here, macros replaced.
fn written_out(from: usize, rest: &[u8], work: &mut Work) -> Parsed<Line> {
    let place = |range: Range<usize>| Span { start: (from + range.start) as u32, end: (from + range.end) as u32 };
    let mut line = Line::default();
    let mut behind = 0;
    for name in names(rest) {
        let Some(text) = text_at(rest, &name) else { continue };
        if work.known.find(text).is_none() {
            continue;
        }
        line.text.extend_from_slice(rest.get(behind..name.start).unwrap_or_default());
        line.pieces.push(Piece { end: line.text.len(), at: place(behind..name.start), replaced: false });
        behind = name.end;
        work.replace(text, &mut line.text)?;
        line.pieces.push(Piece { end: line.text.len(), at: place(name), replaced: true });
        if line.text.len() > LONGEST {
            return Err(&own::SYNTAX_MACRO_LONG);
        }
    }
    // a comment may be long, and is no part of what is replaced
    line.text.extend_from_slice(rest.get(behind..).unwrap_or_default());
    line.pieces.push(Piece { end: line.text.len(), at: place(behind..rest.len()), replaced: false });
    Ok(line)
}

/// Replacing a name, and the names in its text.
struct Work<'a> {
    known: &'a Known,
    left: usize,
    /// Names that are being replaced.
    open: Vec<&'a [u8]>,
}

impl<'a> Work<'a> {
    fn replace(&mut self, name: &[u8], line: &mut Vec<u8>) -> Result<(), &'static Own> {
        let Some(text) = self.known.find(name) else { return Ok(()) };
        // a text is the same piece of memory wherever it is found
        if self.open.len() >= LEVELS || self.open.iter().any(|open| std::ptr::eq(*open, text)) {
            return Err(&own::SYNTAX_MACRO_CIRCLE);
        }
        self.left = self.left.checked_sub(text.len()).ok_or(&own::SYNTAX_MACRO_LONG)?;
        self.open.push(text);
        let mut behind = 0;
        for inner in names(text) {
            let Some(name) = text_at(text, &inner).filter(|name| self.known.find(name).is_some()) else { continue };
            line.extend_from_slice(text.get(behind..inner.start).unwrap_or_default());
            behind = inner.end;
            self.replace(name, line)?;
        }
        line.extend_from_slice(text.get(behind..).unwrap_or_default());
        self.open.pop();
        if line.len() > LONGEST { Err(&own::SYNTAX_MACRO_LONG) } else { Ok(()) }
    }
}

fn text_at<'a>(text: &'a [u8], range: &Range<usize>) -> Option<&'a [u8]> {
    text.get(range.clone())
}

/// The names of a line up to its comment, those in texts left out: `X10Y20` are `X10` and `Y20`.
fn names(text: &[u8]) -> impl Iterator<Item = Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let first = *text.get(at)?;
            match first {
                b';' => return None,
                b'"' | b'\'' => {
                    let close = text.iter().skip(at + 1).position(|byte| *byte == first);
                    at = close.map_or(text.len(), |length| at + length + 2);
                }
                _ if starts_name(first) => {
                    let run = first_word(text.get(at..)?);
                    let start = at;
                    at += if addresses(run) { address(run) } else { run.len() };
                    return Some(start..at);
                }
                _ => at += 1,
            }
        }
    })
}

/// Whether a run of letters and digits is several addresses without blanks between them.
fn addresses(run: &[u8]) -> bool {
    let mut rest = run;
    while !rest.is_empty() {
        let length = address(rest);
        if length < 2 || !rest.first().is_some_and(u8::is_ascii_alphabetic) {
            return false;
        }
        rest = rest.get(length..).unwrap_or_default();
    }
    true
}

/// Length of the letter with which a text begins, with the digits behind it.
fn address(text: &[u8]) -> usize {
    1 + text.iter().skip(1).take_while(|byte| byte.is_ascii_digit()).count()
}

#[cfg(test)]
mod tests {
    use crate::dialect::Dialect::Sinumerik;
    use crate::syntax::{Program, Word, WordKind, read};

    /// What reading finds wrong, by line.
    fn wrong(text: &str) -> Vec<(u32, &'static str)> {
        let program = read(Sinumerik, text.as_bytes());
        program.errors.iter().map(|error| (program.line_of(error.span.start) + 1, error.sentence.cause)).collect()
    }

    /// The words of a line, as they are written and as they are called.
    fn words(program: &Program, line: usize) -> Vec<(String, String)> {
        let name = |word: &Word| match &word.kind {
            WordKind::Address { name, .. } | WordKind::Assign { name, .. } | WordKind::Call { name, .. } => {
                program.name(*name)
            }
            _ => String::new(),
        };
        program.words_at(line).iter().map(|word| (program.written(word.span), name(word))).collect()
    }

    fn pairs(all: &[(&str, &str)]) -> Vec<(String, String)> {
        all.iter().map(|(one, other)| ((*one).to_owned(), (*other).to_owned())).collect()
    }

    // oracle: hand (a macro stands for its text; each word lies where the program writes it)
    #[test]
    fn words_of_a_macro_lie_where_it_is_named() {
        let text =
            "DEFINE GO AS G1 F\nDEFINE FAR AS 10\nDEFINE M6 AS TOOL_IN\nGO 500 X=FAR Y10M6 ; GO\nMSG(\"GO\") GO_ON";
        let program = read(Sinumerik, text.as_bytes());
        assert!(program.errors.is_empty());
        let wanted = [("GO", "G"), ("GO 500", "F"), ("X=FAR", "X"), ("Y10", "Y"), ("M6", "TOOL_IN")];
        assert_eq!(words(&program, 3), pairs(&wanted));
        assert_eq!(words(&program, 4), pairs(&[("MSG(\"GO\")", "MSG"), ("GO_ON", "GO_ON")]));
        assert_eq!(
            program.blocks.get(3).and_then(|block| block.comment).map(|span| program.written(span)).as_deref(),
            Some("; GO")
        );
        assert_eq!(*program.source, text.as_bytes());
    }

    // oracle: hand (a definition file of the text counts in all of it, another one only in its program)
    #[test]
    fn a_macro_counts_where_it_is_defined() {
        let text = "%_N_A_MPF\nDEFINE OWN AS G0\nOWN ALL\n%_N_B_SPF\nOWN ALL\n%_N_UMAC_DEF\nDEFINE ALL AS G1\nM17\n";
        let program = read(Sinumerik, text.as_bytes());
        assert_eq!(words(&program, 2), pairs(&[("OWN", "G"), ("ALL", "G")]));
        assert_eq!(words(&program, 4), pairs(&[("OWN", "OWN"), ("ALL", "G")]));
    }

    // oracle: hand
    #[test]
    fn what_cannot_be_replaced_is_told_once_where_it_stands() {
        assert_eq!(wrong("DEFINE A1A AS B1B\nDEFINE B1B AS A1A X1\nA1A\nG0"), [(3, "syntax-macro-circle")]);
        assert_eq!(wrong("DEFINE M6 AS M6\nG0 M6\n"), [(2, "syntax-macro-circle")]);
        for line in ["DEFINE AA", "DEFINE AA AS", "DEFINE AA G0", "DEFINE AA AS ; G0", "DEFINE 1 AS G0"] {
            assert_eq!(wrong(line), [(1, "syntax-define")], "{line}");
        }
        assert_eq!(wrong("DEFINE AA AS *\nDEFINE BB AS R1=(\nBB 1 AA 2)"), []);
        assert_eq!(wrong("DEFINE AA AS *\nR1=2 AA\n"), [(2, "syntax-operand")]);
        let doubling = (1..40).map(|at| format!("DEFINE M{at} AS M{} M{}\n", at - 1, at - 1));
        let text: String =
            std::iter::once("DEFINE M0 AS G0\n".to_owned()).chain(doubling).chain(["M39\n".to_owned()]).collect();
        assert_eq!(wrong(&text), [(41, "syntax-macro-long")]);
    }

    // oracle: hand (DEFINE is no word of NCT)
    #[test]
    fn the_other_control_has_none() {
        let program = read(crate::dialect::Dialect::Nct, b"DEFINE AA AS X1\nAA");
        assert!(program.replaced.text.is_empty());
    }
}
