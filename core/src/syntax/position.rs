//! Byte offsets as line and column, and as UTF-16 offsets for the page.

use super::block::BYTE_ORDER_MARK;

/// Bytes between two remembered UTF-16 offsets.
const STEP: usize = 1024;

/// Map of a text; built once, asked often. A byte that is no UTF-8 counts as one character.
pub struct Positions<'a> {
    text: &'a [u8],
    /// UTF-16 offset of every byte at a multiple of [`STEP`].
    marks: Vec<u32>,
    /// First byte of every line; the first one begins behind a byte order mark.
    lines: Vec<u32>,
}

/// UTF-16 units that begin with this byte: none inside a character.
fn units(byte: u8) -> u32 {
    match byte {
        0x80..0xC0 => 0,
        0xF0.. => 2,
        _ => 1,
    }
}

/// Lines end with LF, CR LF or a lone CR, as an editor counts them.
fn line_starts(text: &[u8]) -> impl Iterator<Item = u32> {
    let ends = move |at: usize, byte: u8| byte == b'\n' || (byte == b'\r' && text.get(at + 1) != Some(&b'\n'));
    text.iter().enumerate().filter(move |(at, byte)| ends(*at, **byte)).map(|(at, _)| at as u32 + 1)
}

fn count(text: &[u8]) -> u32 {
    text.iter().map(|byte| units(*byte)).sum()
}

impl<'a> Positions<'a> {
    /// Reads the text once.
    pub fn new(text: &'a [u8]) -> Self {
        let mut marks = vec![0];
        for chunk in text.chunks(STEP) {
            marks.push(marks.last().copied().unwrap_or(0) + count(chunk));
        }
        let first = if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len() as u32 } else { 0 };
        let lines = std::iter::once(first).chain(line_starts(text)).collect();
        Self { text, marks, lines }
    }

    /// Line and column in characters, both from 1; past the end: the end.
    pub fn line_column(&self, offset: u32) -> (u32, u32) {
        let offset = (offset as usize).min(self.text.len()) as u32;
        let line = self.lines.partition_point(|start| *start <= offset).max(1);
        let start = self.lines.get(line - 1).copied().unwrap_or(0);
        let before = self.text.get(start as usize..offset as usize).unwrap_or_default();
        (line as u32, before.iter().filter(|byte| units(**byte) > 0).count() as u32 + 1)
    }

    /// UTF-16 offset of a byte offset; past the end: the end.
    pub fn utf16(&self, offset: u32) -> u32 {
        let offset = (offset as usize).min(self.text.len());
        let mark = offset / STEP;
        let before = self.marks.get(mark).copied().unwrap_or(0);
        before + count(self.text.get(mark * STEP..offset).unwrap_or_default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand (Rust's own encode_utf16 and chars)
    #[test]
    fn every_character_start_maps_to_utf16() {
        let text = "N10 ;测量 é 🔧\r\nX1\n".repeat(200);
        let positions = Positions::new(text.as_bytes());
        for (offset, _) in text.char_indices() {
            let expected = text[..offset].encode_utf16().count() as u32;
            assert_eq!(positions.utf16(offset as u32), expected);
        }
        assert_eq!(positions.line_column(0), (1, 1));
        let second = "N10 ;测量 é 🔧\r\n".len() as u32;
        assert_eq!(positions.line_column(second), (2, 1));
        assert_eq!(positions.line_column(second - 2), (1, 12));
    }

    // oracle: hand
    #[test]
    fn lines_columns_and_utf16_units() {
        let source = "N1 ;ü𝛂\r\nN2 X1\rN3\n".as_bytes();
        let positions = Positions::new(source);
        assert_eq!(positions.line_column(0), (1, 1));
        assert_eq!(positions.line_column(6), (1, 6)); // after ü, 2 bytes
        assert_eq!(positions.utf16(10), 7); // after 𝛂: 4 bytes, 2 units
        assert_eq!(positions.line_column(12), (2, 1));
        assert_eq!(positions.line_column(18), (3, 1));
        assert_eq!(positions.line_column(9999), (4, 1));
        assert_eq!(positions.utf16(9999), Positions::new(source).utf16(source.len() as u32));
    }
}
