//! In which encoding a part program is written, told by its bytes alone, and what is no program at all. Nothing is
//! decoded here: who shows the text, a browser or the terminal, has the tables.

mod double;
#[cfg(test)]
mod tests;
mod units;

use double::{Gb18030, ShiftJis, Utf8};
use serde::Serialize;
use std::fmt;
use units::Units;

/// What is recognised. Whoever shows the text may know more, to be chosen by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Encoding {
    /// Also what is ASCII alone.
    #[serde(rename = "utf-8")]
    Utf8,
    /// With a byte order mark before the text.
    #[serde(rename = "utf-8-marked")]
    Utf8Marked,
    /// The low byte of each unit first.
    #[serde(rename = "utf-16le")]
    Utf16Le,
    /// The low byte of each unit first, with a byte order mark.
    #[serde(rename = "utf-16le-marked")]
    Utf16LeMarked,
    /// The high byte of each unit first.
    #[serde(rename = "utf-16be")]
    Utf16Be,
    /// The high byte of each unit first, with a byte order mark.
    #[serde(rename = "utf-16be-marked")]
    Utf16BeMarked,
    /// Simplified Chinese, in pairs of bytes; GB 2312 is part of it.
    #[serde(rename = "gbk")]
    Gbk,
    /// Simplified Chinese, with sequences of four bytes for everything else.
    #[serde(rename = "gb18030")]
    Gb18030,
    /// Japanese.
    #[serde(rename = "shift_jis")]
    ShiftJis,
    /// Western European: what is nothing else.
    #[serde(rename = "windows-1252")]
    Windows1252,
}

/// As the page calls it: the label of the WHATWG encoding standard, `-marked` with a byte order mark.
impl fmt::Display for Encoding {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        self.serialize(to)
    }
}

/// What is no text at all.
const BINARY: &str = "file-binary";

/// What files of other sorts begin with: pictures (PNG, JPEG, GIF, TIFF); ZIP and its like, which office documents of
/// today are too; portable documents; those of a word processor or a table calculation; programs of a computer.
const BEGINNINGS: [(&str, &[&[u8]]); 5] = [
    ("file-picture", &[b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"GIF87a", b"GIF89a", b"II*\0", b"MM\0*"]),
    (
        "file-archive",
        &[
            b"PK\x03\x04", b"PK\x05\x06", b"\x1f\x8b\x08", b"7z\xbc\xaf\x27\x1c", b"Rar!\x1a\x07", b"\xfd7zXZ\0",
            b"\x28\xb5\x2f\xfd",
        ],
    ),
    ("file-pdf", &[b"%PDF-"]),
    ("file-document", &[b"{\\rtf", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"]),
    (BINARY, &[b"\x7fELF"]),
];

/// Bytes at the begin that are kept to be compared.
const HEAD: usize = 8;

/// Bytes that are looked at together: where all of them are printable ASCII, no encoding has to be asked.
const PIECE: usize = 256;

fn is_printable(byte: u8) -> bool {
    matches!(byte, b'\t'..=b'\r' | b' '..=b'~')
}

/// Tells the encoding of a whole file, whose bytes may come in pieces.
#[derive(Default)]
pub struct Recogniser {
    head: Vec<u8>,
    /// NULs since the last other byte: a tape begins and ends with them.
    waiting: usize,
    nulls: usize,
    controls: usize,
    printable: usize,
    beyond: usize,
    units: Units,
    utf8: Utf8,
    gb18030: Gb18030,
    shift_jis: ShiftJis,
}

impl Recogniser {
    /// The next bytes.
    pub fn take(&mut self, bytes: &[u8]) {
        let missing = HEAD.saturating_sub(self.head.len());
        self.head.extend(bytes.iter().take(missing));
        for piece in bytes.chunks(PIECE) {
            if self.waiting == 0
                && !self.in_character()
                && piece.iter().fold(true, |all, byte| all & is_printable(*byte))
            {
                self.printable += piece.len();
                self.units.take_text(piece);
            } else {
                piece.iter().for_each(|byte| self.take_byte(*byte));
            }
        }
    }

    fn take_byte(&mut self, byte: u8) {
        self.count(byte);
        self.units.take(byte);
        self.utf8.take(byte);
        self.gb18030.take(byte);
        self.shift_jis.take(byte);
    }

    /// Whether the next byte may belong to a character that has begun, or to a row of them.
    fn in_character(&self) -> bool {
        self.utf8.0.is_open() || self.gb18030.pairs.is_open() || self.shift_jis.is_open()
    }

    fn count(&mut self, byte: u8) {
        if byte == 0 {
            self.waiting += 1;
            self.nulls += 1;
            return;
        }
        if self.printable + self.beyond + self.controls > 0 {
            self.controls += self.waiting;
        }
        self.waiting = 0;
        match byte {
            _ if is_printable(byte) => self.printable += 1,
            0x80.. => self.beyond += 1,
            _ => self.controls += 1,
        }
    }

    /// # Errors
    /// It is no part program: key of what it is instead.
    pub fn finish(mut self) -> Result<Encoding, &'static str> {
        let begins = |beginning: &&[u8]| self.head.starts_with(beginning);
        if let Some((what, _)) = BEGINNINGS.iter().find(|(_, sort)| sort.iter().any(begins)) {
            return Err(what);
        }
        match self.head[..] {
            [0xFF, 0xFE, ..] if self.units.marked(0) => return Ok(Encoding::Utf16LeMarked),
            [0xFE, 0xFF, ..] if self.units.marked(1) => return Ok(Encoding::Utf16BeMarked),
            _ => {}
        }
        if self.nulls > 0
            && let Some(order) = self.units.unmarked()
        {
            return Ok([Encoding::Utf16Le, Encoding::Utf16Be][order]);
        }
        if self.holds_no_text() {
            return Err(BINARY);
        }
        Ok(self.bytewise())
    }

    /// Transfer lines leave a few control characters; what is packed has more than one for five printable ones.
    fn holds_no_text(&self) -> bool {
        self.controls * 5 > self.printable || self.nulls > 0 && self.printable + self.beyond == 0
    }

    /// The one with the characters of a text, and next to no byte that it cannot have; western text has no such pairs.
    fn bytewise(&mut self) -> Encoding {
        let marked = self.head.starts_with(b"\xef\xbb\xbf");
        let utf8 = self.utf8.0.done();
        if utf8.wrong == 0 || utf8.usual >= 4 * utf8.wrong {
            if marked { Encoding::Utf8Marked } else { Encoding::Utf8 }
        } else if self.gb18030.pairs.done().likely() {
            if self.gb18030.four > 0 { Encoding::Gb18030 } else { Encoding::Gbk }
        } else if self.shift_jis.pairs.done().likely() {
            Encoding::ShiftJis
        } else {
            Encoding::Windows1252
        }
    }
}

/// The encoding of a whole file.
///
/// # Errors
/// It is no part program: key of what it is instead.
pub fn recognise(bytes: &[u8]) -> Result<Encoding, &'static str> {
    let mut recogniser = Recogniser::default();
    recogniser.take(bytes);
    recogniser.finish()
}
