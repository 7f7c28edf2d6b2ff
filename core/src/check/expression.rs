//! Expressions as they are typed: how a control writes them, and what they are worth.

use crate::control::{Control, Value};
use crate::dialect::Dialect;
use crate::syntax::fold::{Known, names_in, number};
use crate::syntax::{ExprId, Grammar, Program, WordKind, is_value_of, read};
use std::collections::BTreeSet;

/// An expression as a program of this control writes it: with decimal points, on NCT in brackets where it calculates
/// (`D[#101+1]`). None: it is none there.
pub fn written(dialect: Dialect, text: &str) -> Option<String> {
    let text = text.trim();
    let pointed = pointed(text);
    let brackets = Grammar::of(dialect).by_address;
    let readings = || [Some(pointed.as_str()), Some(text).filter(|text| *text != pointed)].into_iter().flatten();
    let bracketed = readings().filter(|_| brackets).map(|text| format!("[{text}]"));
    readings().map(str::to_owned).chain(bracketed).find(|text| is_value_of(dialect, text))
}

/// With each comma between two digits as a point, but for those between the arguments of a function or index.
fn pointed(text: &str) -> String {
    let bytes = text.as_bytes();
    let digit = |at: Option<usize>| at.and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_digit);
    let between = |at: usize| digit(at.checked_sub(1)) && digit(Some(at + 1));
    let mut lists: Vec<bool> = Vec::new(); // of the open brackets: whether a name stands before it
    let mut named = false;
    let point = |(at, c): (usize, char)| {
        match c {
            '(' | '[' => lists.push(named),
            ')' | ']' => drop(lists.pop()),
            _ => {}
        }
        if !c.is_whitespace() {
            named = c.is_alphanumeric() || matches!(c, '_' | '#' | '$');
        }
        if c == ',' && between(at) && lists.last() != Some(&true) { '.' } else { c }
    };
    text.char_indices().map(point).collect()
}

/// What an expression is worth that is written so, by what is known of its variables.
pub fn worth(dialect: Dialect, written: &str, known: Known) -> Option<f64> {
    let (program, id) = alone(dialect, written)?;
    number(&program, id, known)
}

/// A calculated number as it is shown, without the digits that only calculating brought.
pub fn shown(number: f64) -> String {
    if number.fract() == 0.0 && number.abs() < 1e12 {
        return number.to_string();
    }
    format!("{number:.12e}").parse().unwrap_or(number).to_string()
}

/// The names in an expression that is written so, in upper case.
pub fn names(dialect: Dialect, written: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    if let Some((program, id)) = alone(dialect, written) {
        names_in(&program, id, &mut found);
    }
    found
}

/// A program of this expression alone.
fn alone(dialect: Dialect, written: &str) -> Option<(Program, ExprId)> {
    let name = if Grammar::of(dialect).by_address { "D" } else { "_X=" };
    let program = read(dialect, format!("{name}{written}").as_bytes());
    let id = match program.words[..] {
        [ref word] => match word.kind {
            WordKind::Assign { value, .. } | WordKind::Address { value, .. } => value,
            _ => return None,
        },
        _ => return None,
    };
    Some((program, id))
}

/// Whether a name is that of an arithmetic parameter, `R1`, or of a variable of macros, `#101`: only what assigns it
/// gives it a value.
pub fn is_parameter(name: &str) -> bool {
    let number = name.strip_prefix(['R', '#']).unwrap_or_default();
    !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
}

/// The number that such a variable holds when a program begins, where the machine was given one.
pub fn begun(control: &Control, name: &str) -> Option<f64> {
    match control.data.given(name).filter(|_| is_parameter(name))? {
        Value::Number(number) => Some(*number),
        Value::Text(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand (N: brackets of macro expressions are square; a decimal comma is no sign of either language)
    #[test]
    fn a_control_gets_what_it_can_read() {
        for (text, sinumerik, nct) in [
            ("R2", Some("R2"), None),
            ("2*R3", Some("2*R3"), None),
            ("50+0,5", Some("50+0.5"), Some("[50+0.5]")),
            ("50-0.5", Some("50-0.5"), Some("[50-0.5]")),
            ("_EV[1]+0,5", Some("_EV[1]+0.5"), None),
            ("MIN(1,5)", Some("MIN(1,5)"), None),
            ("ATAN2(50,5)+0,5", Some("ATAN2(50,5)+0.5"), None),
            ("SQRT((50+0,5)*2)", Some("SQRT((50+0.5)*2)"), None),
            ("(50+0,5)*R1", Some("(50+0.5)*R1"), None),
            ("#101", None, Some("#101")),
            ("#101+1", None, Some("[#101+1]")),
            ("[#101+1]/2,5", None, Some("[[#101+1]/2.5]")),
            ("R2 M30", None, None),
        ] {
            assert_eq!(written(Dialect::Sinumerik, text).as_deref(), sinumerik, "{text}");
            assert_eq!(written(Dialect::Nct, text).as_deref(), nct, "{text}");
        }
    }

    // oracle: hand
    #[test]
    fn worth_is_that_of_the_variables() {
        let known = |name: &str| match name {
            "R2" => Some(50.02),
            "#101" => Some(7.0),
            _ => None,
        };
        for (dialect, text, number) in [
            (Dialect::Sinumerik, "R2", Some(50.02)),
            (Dialect::Sinumerik, "2*R2-0.04", Some(100.0)),
            (Dialect::Sinumerik, "R9+1", None),
            (Dialect::Sinumerik, "SQRT(R2-1.02)", Some(7.0)),
            (Dialect::Sinumerik, "100*SIN(30)", Some(100.0 * 30.0_f64.to_radians().sin())),
            (Dialect::Sinumerik, "ABS(-R2)", Some(50.02)),
            (Dialect::Sinumerik, "ROUND(R2)+TRUNC(2.9)", Some(52.0)),
            (Dialect::Sinumerik, "POT(3)", Some(9.0)),
            (Dialect::Sinumerik, "ATAN2(1,1)", Some(45.0)),
            (Dialect::Sinumerik, "SQRT(-1)", None),
            (Dialect::Sinumerik, "SQRT(1,2)", None),
            (Dialect::Sinumerik, "1/(R2-50.02)", None),
            (Dialect::Nct, "[SQRT[#101+2]]", Some(3.0)),
            (Dialect::Nct, "[#101+1]", Some(8.0)),
            (Dialect::Nct, "-#101", Some(-7.0)),
        ] {
            assert_eq!(worth(dialect, text, &known), number, "{text}");
        }
    }
}
