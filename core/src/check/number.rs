//! Numbers as people and programs write them.

use super::expression::written;
use crate::SIMULATES;
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
    let number = if SIMULATES { digits.parse().ok() } else { plain(digits) };
    number.filter(|number: &f64| number.is_finite()).map(Parsed::Number)
}

/// The same as `parse` of f64 up to 15 digits and the exponents of f64's exact powers of ten, 22 each way; nearly the
/// same beyond. The tables of `parse` are a tenth of the page's first module, which all first visits wait for.
fn plain(digits: &str) -> Option<f64> {
    const MOST: usize = 19; // digits that fit into u64
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((digits, "0"));
    let exponent: i32 = exponent.parse().ok()?;
    let unsigned = mantissa.strip_prefix(['-', '+']).unwrap_or(mantissa);
    let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let all = || whole.bytes().chain(fraction.bytes());
    if all().next().is_none() || !all().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let zeros = all().take_while(|digit| *digit == b'0').count();
    let counted = all().skip(zeros).take(MOST).fold(0_u64, |number, digit| number * 10 + u64::from(digit - b'0'));
    let left = (whole.len() + fraction.len()).saturating_sub(zeros + MOST);
    let power = i64::from(exponent) + left as i64 - fraction.len() as i64;
    let ten = |power: i64| 10_f64.powi(power.clamp(0, 400) as i32);
    let number = if counted == 0 { 0.0 } else { counted as f64 * ten(power) / ten(-power) };
    Some(if mantissa.starts_with('-') { -number } else { number })
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

    // oracle: peer (the standard library's reading)
    #[test]
    fn the_first_module_reads_the_same() {
        let figures = ["0", "00", "1", "7", "132", "0132", "050030", "999999999999999", "123456789012345"];
        let fractions = ["", ".", ".0", ".5", ".03", ".030", ".0000001"];
        let exponents = ["", "e0", "e3", "e-3", "e+6"];
        let mut texts = Vec::new();
        for figure in figures {
            for fraction in fractions.iter().filter(|text| figure.len() + text.len() <= 16) {
                for exponent in exponents {
                    texts.extend(["", "-", "+"].map(|sign| format!("{sign}{figure}{fraction}{exponent}")));
                }
            }
        }
        texts.extend(["0e999", "-0", ".5", "-.25", "5.", "1e22", "1e-22", "0.1", "0.3", "2.675"].map(str::to_owned));
        for text in texts {
            assert_eq!(plain(&text), text.parse().ok(), "{text}");
        }
        for text in ["", ".", "-", "+.", "1.2.3", "--5", "e5", "1e", "1e5e5", "1e99999999999", "+-1", "1e5.0"] {
            assert_eq!(plain(text), text.parse().ok().filter(|number: &f64| number.is_finite()), "{text}");
        }
        for text in ["1e999", "-1e999"] {
            assert!(plain(text).is_some_and(f64::is_infinite), "{text}");
        }
        for text in ["12345678901234567890", "0.12345678901234567890123", "1e-300", "1.7e308"] {
            let exact: f64 = text.parse().unwrap_or(f64::NAN);
            assert!(plain(text).is_some_and(|near| (near / exact - 1.0).abs() < 1e-13), "{text}");
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
