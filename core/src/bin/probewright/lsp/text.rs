//! The text of a document, and its places as the protocol counts them: line and character from 0, a character in UTF-16
//! units, or bytes where client and server agreed on UTF-8.

use lsp_types::{Position, Range, TextDocumentContentChangeEvent};
use probewright_core::diagnostic::Span;

/// How characters of a line are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// UTF-16, which every client knows.
    Utf16,
    /// UTF-8.
    Utf8,
}

/// First byte and first UTF-16 unit of a line.
#[derive(Clone, Copy, Default)]
struct Start {
    byte: usize,
    unit: usize,
}

/// A text with its lines, which end with LF, CR LF or a lone CR.
pub struct Text {
    text: String,
    lines: Vec<Start>,
    units: Units,
}

impl Text {
    /// Looks through the text once.
    pub fn new(text: String, units: Units) -> Text {
        let mut lines = vec![Start::default()];
        let (mut unit, bytes) = (0, text.as_bytes());
        for (at, one) in text.char_indices() {
            unit += one.len_utf16();
            if one == '\n' || (one == '\r' && bytes.get(at + 1) != Some(&b'\n')) {
                lines.push(Start { byte: at + 1, unit });
            }
        }
        Text { text, lines, units }
    }

    /// All of it.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// A line without its end, and its first byte; behind the last: an empty one at the end.
    fn line(&self, line: usize) -> (&str, usize) {
        let Some(start) = self.lines.get(line) else { return ("", self.text.len()) };
        let end = self.lines.get(line + 1).map_or(self.text.len(), |next| next.byte);
        let text = self.text.get(start.byte..end).unwrap_or_default();
        (text.trim_end_matches(['\r', '\n']), start.byte)
    }

    /// The byte of a position; behind the end of a line: its end.
    pub fn byte(&self, at: Position) -> usize {
        let (line, start) = self.line(at.line as usize);
        let wanted = at.character as usize;
        start
            + match self.units {
                Units::Utf8 => (0..=wanted.min(line.len())).rev().find(|at| line.is_char_boundary(*at)).unwrap_or(0),
                Units::Utf16 => unit_at(line, wanted),
            }
    }

    /// The byte of a UTF-16 unit of the whole text; behind the end: the end.
    fn byte_of_unit(&self, unit: u32) -> usize {
        let unit = unit as usize;
        let line = self.lines.partition_point(|start| start.unit <= unit).saturating_sub(1);
        let Some(start) = self.lines.get(line) else { return self.text.len() };
        start.byte + unit_at(self.text.get(start.byte..).unwrap_or_default(), unit - start.unit)
    }

    /// The position of a byte; behind the end: the end.
    pub fn position(&self, byte: usize) -> Position {
        let byte = (0..=byte.min(self.text.len())).rev().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0);
        let line = self.lines.partition_point(|start| start.byte <= byte).saturating_sub(1);
        let start = self.lines.get(line).map_or(0, |start| start.byte);
        let before = self.text.get(start..byte).unwrap_or_default();
        let character = match self.units {
            Units::Utf8 => before.len(),
            Units::Utf16 => before.chars().map(char::len_utf16).sum(),
        };
        Position::new(line as u32, character as u32)
    }

    /// The range of a place.
    pub fn range(&self, place: Span) -> Range {
        Range::new(self.position(place.start as usize), self.position(place.end as usize))
    }

    /// The range of a place in UTF-16 units of the whole text.
    pub fn range_of_units(&self, from: u32, to: u32) -> Range {
        Range::new(self.position(self.byte_of_unit(from)), self.position(self.byte_of_unit(to)))
    }

    /// The lines of these numbers, from 0, both included, without the end of the last.
    pub fn range_of_lines(&self, first: u32, last: u32) -> Range {
        let (line, start) = self.line(last as usize);
        Range::new(Position::new(first, 0), self.position(start + line.len()))
    }

    /// What stands in the line of a position before it, and the place of the position.
    pub fn before(&self, at: Position) -> (&str, usize) {
        let byte = self.byte(at);
        let (_, start) = self.line(at.line as usize);
        (self.text.get(start..byte).unwrap_or_default(), byte)
    }

    /// The text after changes, each of what the one before it left.
    pub fn changed(self, changes: Vec<TextDocumentContentChangeEvent>) -> Text {
        changes.into_iter().fold(self, |mut text, change| {
            let Some(range) = change.range else { return Text::new(change.text, text.units) };
            let (start, end) = (text.byte(range.start), text.byte(range.end));
            text.text.replace_range(start..end.max(start), &change.text);
            Text::new(text.text, text.units)
        })
    }
}

/// The byte of a text at which this UTF-16 unit begins; inside of a character: its begin.
fn unit_at(text: &str, wanted: usize) -> usize {
    let mut units = 0;
    for (at, one) in text.char_indices() {
        units += one.len_utf16();
        if units > wanted {
            return at;
        }
    }
    text.len()
}
