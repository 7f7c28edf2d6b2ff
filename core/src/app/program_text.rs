//! Text of a program that several questions are about.

use serde::{Deserialize, Deserializer};
use std::sync::Arc;

/// Text of a program in UTF-8. Who asks several questions about a long one holds it, so that none brings it anew.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "String"))]
pub struct ProgramText(pub(super) Arc<Vec<u8>>);

/// UTF-16 units that begin with a byte.
fn units(byte: u8) -> usize {
    match byte {
        0x80..0xC0 => 0,
        0xF0.. => 2,
        _ => 1,
    }
}

impl ProgramText {
    /// An empty one with room for so many bytes.
    pub fn with_room(bytes: usize) -> ProgramText {
        ProgramText(Arc::new(Vec::with_capacity(bytes)))
    }

    /// Puts a piece behind it, in UTF-8.
    pub fn push(&mut self, piece: &[u8]) {
        Arc::make_mut(&mut self.0).extend_from_slice(piece);
    }

    /// Puts a text in the place of these UTF-16 units.
    pub fn replace(&mut self, from: usize, to: usize, text: &str) {
        let range = self.byte(from)..self.byte(to.max(from));
        drop(Arc::make_mut(&mut self.0).splice(range, text.bytes()));
    }

    /// First byte of a UTF-16 unit; past the end: the end.
    fn byte(&self, unit: usize) -> usize {
        let mut before = 0;
        let passed = |byte: &u8| {
            before += units(*byte);
            before > unit
        };
        self.0.iter().position(passed).unwrap_or(self.0.len())
    }
}

impl From<String> for ProgramText {
    fn from(text: String) -> ProgramText {
        ProgramText(Arc::new(text.into_bytes()))
    }
}

impl From<&str> for ProgramText {
    fn from(text: &str) -> ProgramText {
        text.to_owned().into()
    }
}

impl<'de> Deserialize<'de> for ProgramText {
    fn deserialize<D: Deserializer<'de>>(text: D) -> Result<ProgramText, D::Error> {
        String::deserialize(text).map(ProgramText::from)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand (é has 2 bytes and a unit, 🔧 4 bytes and two units)
    #[test]
    fn pieces_and_edits_make_the_text() {
        let mut text = ProgramText::with_room(0);
        text.push("N1 ;é🔧".as_bytes());
        text.push(b"\r\nX1");
        assert_eq!(text, "N1 ;é🔧\r\nX1".into());
        let held = text.clone();
        text.replace(7, 7, "N2 ");
        assert_eq!(text, "N1 ;é🔧N2 \r\nX1".into());
        text.replace(4, 7, "");
        assert_eq!(text, "N1 ;N2 \r\nX1".into());
        text.replace(0, 2, "");
        assert_eq!(text, " ;N2 \r\nX1".into());
        text.replace(8, 99, "0");
        assert_eq!(text, " ;N2 \r\nX0".into());
        assert_eq!(held, "N1 ;é🔧\r\nX1".into(), "who holds it has it as it was");
    }
}
