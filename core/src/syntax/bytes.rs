//! What a byte of a part program can begin.

/// Letter or `_`.
pub(super) fn is_letter(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte == b'_'
}

/// First byte of a name: letter, `_`, `$`.
pub(super) fn starts_name(byte: u8) -> bool {
    is_letter(byte) || byte == b'$'
}

/// Any byte of a name.
pub(super) fn in_name(byte: u8) -> bool {
    starts_name(byte) || byte.is_ascii_digit()
}

/// Blank, tab, a carriage return inside a line.
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r')
}
