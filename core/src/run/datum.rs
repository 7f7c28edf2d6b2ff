//! Values while a program runs, and types of variables; conversions by the table in Job planning, 03/2006, 1.9.

use crate::control::{Frame, Value};

pub use crate::control::definitions::Type;

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
            Datum::Text(text) => single(text).map(char::from),
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
            Datum::Text(text) => Some(Value::Text(text.clone())),
            Datum::Number(_) | Datum::Char(_) => self.number().map(Value::Number),
            _ => None,
        }
    }
}

fn shown(value: f64) -> String {
    let exact = value.to_string();
    let long = exact.split_once('.').is_some_and(|(_, decimals)| decimals.len() > 10);
    let text = if long { format!("{value:.10}").trim_end_matches('0').trim_end_matches('.').to_owned() } else { exact };
    if text == "-0" { "0".to_owned() } else { text }
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

impl Type {
    /// What a variable holds as long as nothing was written: 0, FALSE, an empty text, the first axis, no displacement.
    pub fn empty(self) -> Datum {
        match self {
            Type::Real | Type::Int | Type::Bool => Datum::Number(0.0),
            Type::Char => Datum::Char(0),
            Type::Text(_) => Datum::Text(String::new()),
            Type::Axis => Datum::Word("X".into()),
            Type::Frame => Datum::Frame(Box::default()),
        }
    }

    /// A value as a variable of this type holds it; none: it has no place there.
    pub fn converted(self, value: &Datum) -> Option<Datum> {
        match (self, value) {
            (Type::Axis, Datum::Word(_)) | (Type::Frame, Datum::Frame(_)) => Some(value.clone()),
            (Type::Axis | Type::Frame, _) => None,
            (Type::Bool, Datum::Text(text)) => Some(Datum::from(!text.is_empty())),
            (Type::Char, Datum::Text(text)) => single(text).map(Datum::Char),
            (Type::Text(length), Datum::Text(text)) => (text.chars().count() <= length).then(|| value.clone()),
            (Type::Text(_), Datum::Char(_)) => Some(Datum::Text(value.shown())),
            (Type::Text(_), _) => None,
            _ => self.of_number(value.number()?),
        }
    }

    fn of_number(self, number: f64) -> Option<Datum> {
        match self {
            Type::Bool => Some(Datum::from(number != 0.0)),
            Type::Int => {
                let whole = number.round();
                (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&whole).then_some(Datum::Number(whole))
            }
            Type::Char => {
                let code = number.round();
                (0.0..=255.0).contains(&code).then_some(Datum::Char(code as u8))
            }
            _ => number.is_finite().then_some(Datum::Number(number)),
        }
    }
}

/// Code of a text of one character.
pub fn single(text: &str) -> Option<u8> {
    let mut characters = text.chars();
    let code = u8::try_from(u32::from(characters.next()?)).ok()?;
    characters.next().is_none().then_some(code)
}

/// A text with another character at this place.
pub fn replaced(text: &str, number: &str, character: &str) -> Option<String> {
    let (from, old) = text.char_indices().nth(number.parse().ok()?)?;
    let mut text = text.to_owned();
    text.replace_range(from..from + old.len_utf8(), character);
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(kind: Type, value: f64) -> Option<Datum> {
        kind.converted(&Datum::Number(value))
    }

    // oracle: manual (Job planning 03/2006, 1.9: a fraction from 0.5 is rounded up; not 0 is TRUE; one character only)
    #[test]
    fn values_are_converted_as_the_table_says() {
        assert_eq!(number(Type::Int, 2.5), Some(Datum::Number(3.0)));
        assert_eq!(number(Type::Int, 2.49), Some(Datum::Number(2.0)));
        assert_eq!(number(Type::Int, 3e9), None);
        assert_eq!(number(Type::Bool, -0.1), Some(Datum::Number(1.0)));
        assert_eq!(number(Type::Char, 65.0), Some(Datum::Char(65)));
        assert_eq!(number(Type::Char, 256.0), None);
        assert_eq!(number(Type::Text(9), 1.0), None);
        assert_eq!(number(Type::Frame, 1.0), None);
        let text = |kind: Type, text: &str| kind.converted(&Datum::Text(text.into()));
        assert_eq!(text(Type::Bool, ""), Some(Datum::Number(0.0)));
        assert_eq!(text(Type::Char, "A"), Some(Datum::Char(65)));
        assert_eq!(text(Type::Char, "AB"), None);
        assert_eq!(text(Type::Text(1), "AB"), None);
        assert_eq!(text(Type::Real, "1"), None);
        assert_eq!(Type::Text(3).converted(&Datum::Char(65)), Some(Datum::Text("A".into())));
    }
}
