//! Numbers: decimal with point, `EX` exponent, `'H7F'` and `'B101'`.

/// Powers of ten that are exact in f64.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Largest mantissa whose value in f64 is exact.
const EXACT: u64 = 1 << 53;

/// Reads an unsigned decimal number at the start of `text`; its value and length. The value is the nearest f64. Numbers
/// of a program are short: with one division a whole program is read faster than with the parser of `std`.
pub(super) fn decimal(text: &[u8]) -> Option<(f64, usize)> {
    let mut mantissa: u64 = 0;
    let mut at = 0;
    while let Some(&byte) = text.get(at).filter(|byte| byte.is_ascii_digit()) {
        mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
        at += 1;
    }
    let mut digits = at;
    let mut places = 0;
    if text.get(at) == Some(&b'.') {
        at += 1;
        while let Some(&byte) = text.get(at).filter(|byte| byte.is_ascii_digit()) {
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            at += 1;
            places += 1;
        }
        digits += places;
    }
    if digits == 0 {
        return None;
    }
    // At most 19 digits cannot have wrapped; mantissa and power exact: one division rounds correctly.
    if digits <= 19 && mantissa <= EXACT && places < TENS.len() {
        let value = if places == 0 { mantissa as f64 } else { mantissa as f64 / TENS[places] };
        return Some((value, at));
    }
    let value = std::str::from_utf8(text.get(..at)?).ok()?.parse::<f64>().ok()?;
    value.is_finite().then_some((value, at))
}

/// Reads a decimal number with an optional exponent: `1.5EX-3`.
pub(super) fn with_exponent(text: &[u8]) -> Option<(f64, usize)> {
    let (value, length) = decimal(text)?;
    let rest = text.get(length..).unwrap_or_default();
    if !rest.get(..2).is_some_and(|word| word.eq_ignore_ascii_case(b"EX")) {
        return Some((value, length));
    }
    let sign = usize::from(matches!(rest.get(2), Some(b'+' | b'-')));
    let digits = rest.iter().skip(2 + sign).take_while(|byte| byte.is_ascii_digit()).count();
    if digits == 0 {
        return Some((value, length));
    }
    let end = length + 2 + sign + digits;
    let written = std::str::from_utf8(text.get(..length)?).ok()?;
    let power = std::str::from_utf8(rest.get(2..2 + sign + digits)?).ok()?;
    let value = format!("{written}e{power}").parse::<f64>().ok()?;
    value.is_finite().then_some((value, end))
}

/// The number that a whole text says as a program writes it, with sign and exponent: `-1.5EX2`; blanks around it count
/// for nothing. None: it is another text.
pub(crate) fn of_text(text: &str) -> Option<f64> {
    let text = text.trim();
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (value, length) = with_exponent(digits.as_bytes())?;
    let value = if text.starts_with('-') { -value } else { value };
    (length == digits.len()).then_some(value)
}

/// Reads `'H7F'`, `'B101'` or `'D12'`; value and length, quotes included.
pub(super) fn quoted(text: &[u8]) -> Option<(f64, usize)> {
    let length = text.iter().skip(1).position(|byte| *byte == b'\'')?;
    let base = match text.get(1)?.to_ascii_uppercase() {
        b'H' => 16,
        b'B' => 2,
        b'D' => 10,
        _ => return None,
    };
    let digits = std::str::from_utf8(text.get(2..1 + length)?).ok()?;
    Some((u64::from_str_radix(digits, base).ok()? as f64, length + 2))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: hand (Rust's own correctly rounding parser as second opinion)
    #[test]
    fn numbers_are_the_nearest_f64_and_end_where_the_digits_end() {
        for text in
            ["0", "1.", ".5", "110.246", "0.1", "123456789012345678", "9007199254740993", "0.000000000000000000000001"]
        {
            assert_eq!(decimal(text.as_bytes()).unwrap(), (text.parse::<f64>().unwrap(), text.len()), "{text}");
        }
        assert_eq!(decimal(b"10Y20"), Some((10.0, 2)));
        assert_eq!(decimal(b"."), None);
        assert_eq!(decimal("9".repeat(400).as_bytes()), None);
    }

    // oracle: hand (EX as in a program; 1e5 is no number of the language)
    #[test]
    fn texts_say_numbers_as_programs_do() {
        for (text, number) in [
            ("1234.9876Ex-7", Some(1234.9876e-7)),
            ("1.5EX2", Some(150.0)),
            ("1.5ex+2", Some(150.0)),
            (" -2EX1 ", Some(-20.0)),
            ("+.5", Some(0.5)),
            ("-7", Some(-7.0)),
            ("", None),
            ("-", None),
            ("--1", None),
            ("1EX", None),
            ("1.5EX2A", None),
            ("1e5", None),
            ("inf", None),
            ("NAN", None),
            ("1 2", None),
        ] {
            assert_eq!(of_text(text), number, "{text}");
        }
    }

    // oracle: hand
    #[test]
    fn exponents_and_bases_are_read() {
        assert_eq!(with_exponent(b"1.5EX-3+1"), Some((0.0015, 7)));
        assert_eq!(with_exponent(b"2ex2"), Some((200.0, 4)));
        assert_eq!(with_exponent(b"2EXTERN"), Some((2.0, 1)));
        assert_eq!(with_exponent(b"1EX999"), None);
        assert_eq!(quoted(b"'H7f'"), Some((127.0, 5)));
        assert_eq!(quoted(b"'B101'*2"), Some((5.0, 6)));
        assert_eq!(quoted(b"'HFFFFFFFFFFFFFFFFF'"), None);
        assert_eq!(quoted(b"'H"), None);
    }
}
