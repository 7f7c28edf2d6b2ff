//! Numbers: decimal with point, `EX` exponent, `'H7F'` and `'B101'`.

/// Reads an unsigned decimal number at the start of `text`; its value and length. The value is the nearest f64.
pub(super) fn decimal(text: &[u8]) -> Option<(f64, usize)> {
    let digits = |from: usize| text.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let whole = digits(0);
    let point = text.get(whole) == Some(&b'.');
    let length = if point { whole + 1 + digits(whole + 1) } else { whole };
    let value = std::str::from_utf8(text.get(..length)?).ok()?.parse::<f64>().ok()?;
    value.is_finite().then_some((value, length))
}

/// Reads a decimal number with an optional exponent: `1.5EX-3`.
pub(super) fn with_exponent(text: &[u8]) -> Option<(f64, usize)> {
    let (value, length) = decimal(text)?;
    let rest = text.get(length..).unwrap_or_default();
    let sign = usize::from(matches!(rest.get(2), Some(b'+' | b'-')));
    let digits = rest.iter().skip(2 + sign).take_while(|byte| byte.is_ascii_digit()).count();
    if digits == 0 || !rest.get(..2).is_some_and(|word| word.eq_ignore_ascii_case(b"EX")) {
        return Some((value, length));
    }
    let end = length + 2 + sign + digits;
    let written = std::str::from_utf8(text.get(..length)?).ok()?;
    let power = std::str::from_utf8(rest.get(2..2 + sign + digits)?).ok()?;
    let value = format!("{written}e{power}").parse::<f64>().ok()?;
    value.is_finite().then_some((value, end))
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
