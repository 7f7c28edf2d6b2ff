//! Values while a program runs.

use crate::control::{Frame, Value};

/// A value of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Datum {
    /// REAL, INT, BOOL.
    Number(f64),
    /// STRING.
    Text(String),
    /// FRAME.
    Frame(Box<Frame>),
    /// A word that stands for itself: axis `X`, part of a frame `TR`.
    Word(String),
    /// Several values, to be spread over an array; none: left as it is.
    List(Vec<Option<Datum>>),
    /// One value for a whole array.
    Repeat(Box<Datum>),
}

impl Datum {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Datum::Number(value) => Some(*value),
            _ => None,
        }
    }

    /// As it is shown in a text: whole numbers without decimals.
    pub fn shown(&self) -> String {
        match self {
            Datum::Number(value) => format!("{value}"),
            Datum::Text(text) | Datum::Word(text) => text.clone(),
            _ => String::new(),
        }
    }

    /// As user data hold it.
    pub fn value(&self) -> Option<Value> {
        match self {
            Datum::Number(value) => Some(Value::Number(*value)),
            Datum::Text(text) => Some(Value::Text(text.clone())),
            _ => None,
        }
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
