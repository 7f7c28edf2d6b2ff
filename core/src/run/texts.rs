//! Functions of texts. Places in a text count from 0.

use super::datum::Datum;
use crate::control::variables::AXES;

/// Value of a function of texts; none: it is another function, or these are no values for it.
pub fn call(name: &str, values: &[Datum]) -> Option<Datum> {
    Some(match (name, values) {
        ("STRLEN", [Datum::Text(text)]) => Datum::Number(text.chars().count() as f64),
        ("TOUPPER", [Datum::Text(text)]) => Datum::Text(text.to_uppercase()),
        ("TOLOWER", [Datum::Text(text)]) => Datum::Text(text.to_lowercase()),
        ("ISNUMBER", [Datum::Text(text)]) => Datum::from(number(text).is_some()),
        ("NUMBER", [Datum::Text(text)]) => Datum::Number(number(text)?),
        ("INDEX", [Datum::Text(text), wanted]) => {
            let wanted = wanted.character()?;
            place(text.chars().position(|character| character == wanted))
        }
        ("RINDEX", [Datum::Text(text), wanted]) => {
            let wanted = wanted.character()?;
            let found = text.chars().enumerate().filter(|(_, c)| *c == wanted);
            place(found.last().map(|(at, _)| at))
        }
        ("MINDEX", [Datum::Text(text), Datum::Text(any)]) => {
            place(text.chars().position(|character| any.contains(character)))
        }
        ("MATCH", [Datum::Text(text), Datum::Text(part)]) => {
            let before = text.find(part.as_str()).and_then(|at| text.get(..at));
            place(before.map(|before| before.chars().count()))
        }
        ("SUBSTR", [Datum::Text(text), Datum::Number(from)]) => Datum::Text(text.chars().skip(whole(*from)?).collect()),
        ("SUBSTR", [Datum::Text(text), Datum::Number(from), Datum::Number(length)]) => {
            let rest = text.chars().skip(whole(*from)?);
            Datum::Text(rest.take(whole(*length)?).collect())
        }
        ("AXNAME", [Datum::Text(text)]) => {
            let name = text.to_ascii_uppercase();
            AXES.contains(&name.as_str()).then_some(Datum::Word(name))?
        }
        ("AXSTRING", [Datum::Word(name)]) => Datum::Text(name.clone()),
        _ => return None,
    })
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

/// A place, -1 where nothing was found.
fn place(found: Option<usize>) -> Datum {
    Datum::Number(found.map_or(-1.0, |at| at as f64))
}

fn whole(number: f64) -> Option<usize> {
    (number >= 0.0).then_some(number as usize)
}
