//! Blocks that are a motion and nothing else: `N10 G1 X10 Y-5.5 F1200`, `G2 X10 Y5 I5 J0`. Most blocks of a large
//! program are such. One whose calls are looked for, or that is run, keeps them as text: the run reads them when it
//! comes to them, so that they take neither room nor a second look.

use super::bytes::is_blank;
use super::number;
use super::tree::{Block, Program};
use crate::diagnostic::Span;

/// Letters of such a block, each once at most.
const LETTERS: &[u8; 8] = b"GXYZFIJK";
/// The last G function of a motion: G0 and G1 straight, G2 and G3 an arc.
const LAST: f64 = 3.0;

/// An address with a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// In upper case.
    pub letter: u8,
    /// Number behind it.
    pub value: f64,
    /// Place.
    pub span: Span,
}

/// A motion: G0 to G3, axes, centre of an arc, feed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plain {
    parts: [Option<Part>; LETTERS.len()],
}

impl Plain {
    /// What a text says that begins here, where it is such a motion and nothing else.
    pub fn of(text: &[u8], start: u32) -> Option<Plain> {
        let mut found = Plain::default();
        let mut at = 0;
        for place in 0.. {
            at += text.get(at..)?.iter().take_while(|byte| is_blank(**byte)).count();
            if at == text.len() {
                return (place > 0).then_some(found);
            }
            let (part, length) = part(text.get(at..)?, start + at as u32)?;
            if found.parts.iter().flatten().any(|other| other.letter == part.letter) {
                return None;
            }
            *found.parts.get_mut(place)? = Some(part);
            at += length;
        }
        None
    }

    /// Its addresses, in their order.
    pub fn parts(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().flatten()
    }
}

/// The address with which a text begins, and its length.
fn part(text: &[u8], start: u32) -> Option<(Part, usize)> {
    let letter = text.first()?.to_ascii_uppercase();
    let sign = usize::from(matches!(text.get(1)?, b'+' | b'-'));
    let (value, digits) = number::decimal(text.get(1 + sign..)?)?;
    let length = 1 + sign + digits;
    let ends = text.get(length).is_none_or(|byte| is_blank(*byte) || LETTERS.contains(&byte.to_ascii_uppercase()));
    let known = LETTERS.contains(&letter) && (letter != b'G' || sign == 0 && value <= LAST && value.fract() == 0.0);
    let value = if text.get(1) == Some(&b'-') { -value } else { value };
    let span = Span { start, end: start + length as u32 };
    (known && ends).then_some((Part { letter, value, span }, length))
}

impl Program {
    /// The motion of a block that was left as text.
    pub fn plain(&self, block: &Block) -> Option<Plain> {
        let start = block.number.map_or(block.span.start, |number| number.end);
        let text = self.text(Span { start, ..block.span });
        if block.plain { Plain::of(text, start) } else { None }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::dialect::Dialect;
    use crate::syntax::{read, read_lean};

    // oracle: hand
    #[test]
    fn only_a_motion_is_left_as_text() {
        let whole = |text: &str| Plain::of(text.as_bytes(), 0).is_some();
        for text in ["G1 X1 Y-2.5 F100", "X1", "g00x.5z+3.", "F1200", "\tG01 Z1 ", "G1", "G2X1Y2I3J-4", "G03 K.5 Z1"] {
            assert!(whole(text), "{text}");
        }
        for text in [
            "",
            " ",
            "G4 X1",
            "G2 X1 CR=5",
            "G1 I1=5",
            "G-0 X1",
            "X1 X2",
            "X=1",
            "X 1",
            "X1;",
            "X1.5EX2",
            "X1E5",
            "X1 M3",
            "X[1]",
            "G1.5",
            "X1 =2",
            "X1:",
            "X",
            "X-",
            "X1,5",
            "G1 A5",
            "X1_",
            "X1(",
            "X99999999999999999999999999999999999999999999999999999999e",
        ] {
            assert!(!whole(text), "{text}");
        }
    }

    // oracle: self: the words that reading gives
    #[test]
    fn a_block_left_as_text_says_what_its_words_say() {
        let text = "X0\nN10 G1 X1 Y-2.50 Z+.5 F1200\nG3 x-0 I5\n /X1\nX2 ; no\nN5\nG0X1Y2\r\n:7 X1\nX1\rY2\n";
        for dialect in [Dialect::Sinumerik, Dialect::Nct] {
            let (all, run) = (read(dialect, text.as_bytes()), read_lean(dialect, text.as_bytes(), &Default::default()));
            assert_eq!((all.blocks.len(), &all.errors), (run.blocks.len(), &run.errors));
            let left = run.blocks.iter().filter(|block| block.plain).count();
            assert_eq!(left, if dialect == Dialect::Nct { 4 } else { 5 }, "{dialect:?}");
            for (block, whole) in run.blocks.iter().zip(&all.blocks) {
                assert_eq!((block.span, block.number, block.comment), (whole.span, whole.number, whole.comment));
                let Some(plain) = run.plain(block) else { continue };
                let words = all.words_of(whole);
                assert_eq!(plain.parts().count(), words.len());
                for (part, word) in plain.parts().zip(words) {
                    let letter = char::from(part.letter).to_string();
                    let value = all.literal(word, &letter).unwrap();
                    assert_eq!((value.to_bits(), word.span), (part.value.to_bits(), part.span));
                }
            }
        }
    }
}
