//! What a byte of a part program can begin: a table, which reads whole programs faster than comparisons do.

/// Bits of the table: letters and `_`, digits, `$`, blanks.
const LETTER: u8 = 1;
const DIGIT: u8 = 2;
const SYSTEM: u8 = 4;
const BLANK: u8 = 8;

static CLASS: [u8; 256] = table();

const fn table() -> [u8; 256] {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = match byte as u8 {
            b'A'..=b'Z' | b'a'..=b'z' | b'_' => LETTER,
            b'0'..=b'9' => DIGIT,
            b'$' => SYSTEM,
            b' ' | b'\t' | b'\r' => BLANK,
            _ => 0,
        };
        byte += 1;
    }
    table
}

/// Letter or `_`.
pub(super) fn is_letter(byte: u8) -> bool {
    CLASS[byte as usize] & LETTER != 0
}

/// First byte of a name: letter, `_`, `$`.
pub(super) fn starts_name(byte: u8) -> bool {
    CLASS[byte as usize] & (LETTER | SYSTEM) != 0
}

/// Any byte of a name.
pub(super) fn in_name(byte: u8) -> bool {
    CLASS[byte as usize] & (LETTER | DIGIT | SYSTEM) != 0
}

/// Blank, tab, a carriage return inside a line.
pub(super) fn is_blank(byte: u8) -> bool {
    CLASS[byte as usize] & BLANK != 0
}
