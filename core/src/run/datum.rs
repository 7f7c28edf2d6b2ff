//! Values while a program runs.

use crate::control::{Frame, Value};

/// A value of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Datum {
    /// NCT: a variable to which nothing was written. 0 in arithmetic; an address with it is as if not written.
    Vacant,
    /// REAL, INT, BOOL.
    Number(f64),
    /// STRING.
    Text(String),
    /// CHAR: a character by its code.
    Char(u8),
    /// FRAME.
    Frame(Box<Frame>),
    /// A word that stands for itself: axis `X`, part of a frame `TR`.
    Word(String),
    /// Several values, to be spread over an array; none: left as it is.
    List(Vec<Option<Datum>>),
    /// One value for so many elements of an array; none: up to its end.
    Repeat(Box<Datum>, Option<usize>),
}

impl Datum {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Datum::Number(value) => Some(*value),
            Datum::Char(code) => Some(f64::from(*code)),
            Datum::Vacant => Some(0.0),
            _ => None,
        }
    }

    /// The character, if it is one or a text of one.
    pub fn character(&self) -> Option<char> {
        match self {
            Datum::Char(code) => Some(char::from(*code)),
            Datum::Text(text) => super::types::single(text).map(char::from),
            _ => None,
        }
    }

    /// As it is shown in a text: numbers with at most ten decimals and no zeros at the end, a character as itself.
    pub fn shown(&self) -> String {
        match self {
            Datum::Number(value) => shown(*value),
            Datum::Char(code) => char::from(*code).to_string(),
            Datum::Text(text) | Datum::Word(text) => text.clone(),
            _ => String::new(),
        }
    }

    /// As it is shown, but a number with all of its digits.
    pub fn exact(&self) -> String {
        match self {
            Datum::Number(value) => value.to_string(),
            other => other.shown(),
        }
    }

    /// As user data hold it.
    pub fn value(&self) -> Option<Value> {
        match self {
            Datum::Number(value) => Some(Value::Number(*value)),
            Datum::Text(text) => Some(Value::Text(text.clone())),
            Datum::Char(code) => Some(Value::Number(f64::from(*code))),
            _ => None,
        }
    }
}

fn shown(value: f64) -> String {
    let exact = value.to_string();
    let decimals = exact.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let text = match decimals {
        0 => exact + ".",
        1..=10 => exact,
        _ => format!("{value:.10}"),
    };
    match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" => "0".to_owned(),
        short => short.to_owned(),
    }
}

impl From<&Value> for Datum {
    fn from(value: &Value) -> Datum {
        match value {
            Value::Number(number) => Datum::Number(*number),
            Value::Text(text) => Datum::Text(text.clone()),
        }
    }
}

impl From<bool> for Datum {
    fn from(value: bool) -> Datum {
        Datum::Number(f64::from(u8::from(value)))
    }
}
