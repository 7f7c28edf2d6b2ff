//! Numbers as people and programs write them.

use super::expression::written;
use crate::dialect::Dialect;

/// What a text is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parsed {
    /// Nothing but blanks.
    Empty,
    /// A finite number.
    Number(f64),
    /// An expression or variable of the program; its value is known at run time only.
    Expression,
    /// Neither.
    Wrong,
}

/// Reads a number: blanks around it, decimal comma or point, sign, exponent `1.5e-3` or that of SINUMERIK, `1.5EX-3`.
pub fn parse(text: &str) -> Parsed {
    let text = text.trim();
    if text.is_empty() {
        return Parsed::Empty;
    }
    if text.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'.' | b'+' | b'-')) {
        return finite(text).unwrap_or_else(|| calculated(text));
    }
    let plain = text.to_ascii_lowercase().replace("ex", "e").replace(',', ".");
    let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e');
    let number = if plain.chars().all(digits) { finite(&plain) } else { None };
    number.unwrap_or_else(|| calculated(text))
}

/// A number in digits, sign, point and exponent.
fn finite(digits: &str) -> Option<Parsed> {
    digits.parse().ok().filter(|number: &f64| number.is_finite()).map(Parsed::Number)
}

/// What is no number by itself.
fn calculated(text: &str) -> Parsed {
    let value = |dialect| written(dialect, text).is_some();
    let known = is_expression(text) && (value(Dialect::Sinumerik) || value(Dialect::Nct));
    if known { Parsed::Expression } else { Parsed::Wrong }
}

/// Begins like a variable, a function, a bracket or a sign before one of them; `NaN` and `inf` are no variables.
fn is_expression(text: &str) -> bool {
    let body = text.trim_start_matches(['-', '+', ' ']);
    let words = ["nan", "inf", "infinity"];
    let starts = body.starts_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '_' | '$' | '(' | '#' | '['));
    let joins = body.contains(['*', '/', '+', '-']) && body.contains(|c: char| c.is_ascii_alphanumeric());
    let known = |c: char| c.is_ascii_graphic() || c == ' ';
    (starts || joins) && body.chars().all(known) && !words.contains(&body.to_ascii_lowercase().as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_typed() {
        // oracle: hand
        for (text, number) in [
            ("132", 132.0),
            (" 132,05 ", 132.05),
            ("-0.5", -0.5),
            ("+.5", 0.5),
            ("1.", 1.0),
            ("1e-3", 0.001),
            ("1,5EX2", 150.0),
            ("0100002", 100_002.0),
            ("1e308", 1e308),
        ] {
            assert_eq!(parse(text), Parsed::Number(number), "{text}");
        }
    }

    #[test]
    fn what_is_no_number() {
        // oracle: hand
        assert_eq!(parse("  "), Parsed::Empty);
        for text in [
            "NaN", "inf", "-inf", "1e999", "12x", "1.2.3", "1,000.5", "--5", "5 mm", "٣", "ü", "R1+", "(((", "a b",
            "R1 M30", "R1;", "1.5e",
        ] {
            assert_eq!(parse(text), Parsed::Wrong, "{text}");
        }
        for text in ["R10", "_OVR[4]-0.5", "-R1", "(R1+2)*3", "$AA_IW[X]", "2*R1", "#500"] {
            assert_eq!(parse(text), Parsed::Expression, "{text}");
        }
    }
}
