//! What operators and functions of expressions give for numbers. Angles in degree. A run of a program and what is known
//! without one calculate by the same table.

use super::tree::Operator;
use crate::geometry::Degrees;

/// An operator between two numbers that gives a number in both languages; none: another one.
pub(crate) fn operate(operator: Operator, a: f64, b: f64) -> Option<f64> {
    let (x, y) = (a as i64, b as i64);
    Some(match operator {
        Operator::Plus => a + b,
        Operator::Minus => a - b,
        Operator::Times => a * b,
        Operator::Over => a / b,
        Operator::Div => (a / b).trunc(),
        Operator::Mod => a % b,
        Operator::BitAnd => (x & y) as f64,
        Operator::BitOr => (x | y) as f64,
        Operator::BitXor => (x ^ y) as f64,
        _ => return None,
    })
}

/// A function of numbers by its name in upper case; none: there is none with so many. Not finite: not of these.
pub(crate) fn function(name: &str, values: &[f64]) -> Option<f64> {
    let value = match (name, values) {
        ("SIN", [a]) => Degrees(*a).sin_cos().0,
        ("COS", [a]) => Degrees(*a).sin_cos().1,
        ("TAN", [a]) => a.to_radians().tan(),
        ("ASIN", [a]) => a.asin().to_degrees(),
        ("ACOS", [a]) => a.acos().to_degrees(),
        ("ATAN", [a]) => a.atan().to_degrees(),
        ("ATAN2" | "ATAN", [a, b]) => a.atan2(*b).to_degrees(),
        ("SQRT", [a]) => a.sqrt(),
        ("ABS", [a]) => a.abs(),
        ("POT", [a]) => a * a,
        ("TRUNC" | "FIX", [a]) => a.trunc(),
        ("FUP", [a]) => a.signum() * a.abs().ceil(),
        ("ROUND", [a]) => a.round(),
        ("ROUNDUP", [a]) => a.ceil(),
        ("LN", [a]) => a.ln(),
        ("EXP", [a]) => a.exp(),
        ("MINVAL", [a, b]) => a.min(*b),
        ("MAXVAL", [a, b]) => a.max(*b),
        ("BOUND", [low, high, value]) if low <= high => value.clamp(*low, *high),
        ("BOUND", [_, _, _]) => f64::NAN,
        _ => return None,
    };
    Some(value)
}
