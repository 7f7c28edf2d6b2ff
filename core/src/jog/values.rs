//! The values of a mask: what a field takes, what is wrong with what was entered.

use super::mask::{Field, Kind, Least, Mask};
use super::offset;
use crate::control::{Control, ROTARY};
use crate::geometry::FARTHEST;
use crate::message::Message;
use std::collections::BTreeMap;

/// The word of the coordinate rotation where a rotary axis could be chosen too.
pub const ROTATION: &str = "rotation";

/// A value.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "JogValue"))]
pub enum Value {
    /// A number, mm or degree.
    Number(f64),
    /// A word of a choice.
    Word(String),
}

/// Values by the names of their fields.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
#[serde(transparent)]
pub struct Values(BTreeMap<&'static str, Value>);

impl Values {
    /// What a mask has when it is opened for the first time: 0, or the first choice.
    pub fn first(mask: &Mask, control: &Control) -> Values {
        let value = |field: &Field| match words(field, &Values::default(), control) {
            Some(words) => Value::Word(words.into_iter().next().unwrap_or_default()),
            None => Value::Number(0.0),
        };
        let mut values = Values(mask.fields.iter().map(|field| (field.name, value(field))).collect());
        values.settle(mask, control);
        values
    }

    /// A number; 0 where there is none.
    pub fn number(&self, name: &str) -> f64 {
        match self.0.get(name) {
            Some(Value::Number(number)) => *number,
            _ => 0.0,
        }
    }

    /// A word; empty where there is none.
    pub fn word(&self, name: &str) -> &str {
        match self.0.get(name) {
            Some(Value::Word(word)) => word,
            _ => "",
        }
    }

    /// A value.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.0.get(name)
    }

    /// Sign of a direction, +1 or -1.
    pub fn sign(&self, name: &str) -> f64 {
        if self.word(name) == "-" { -1.0 } else { 1.0 }
    }

    /// Puts a value that was checked or is given by the control.
    pub(super) fn put(&mut self, name: &'static str, value: Value) {
        self.0.insert(name, value);
    }

    /// Makes choices that another field rules out the first of those that are left.
    fn settle(&mut self, mask: &Mask, control: &Control) {
        for field in mask.fields {
            let Some(words) = words(field, self, control) else { continue };
            let open = matches!(field.kind, Kind::Offset { .. });
            if !open && !words.iter().any(|word| word == self.word(field.name)) {
                self.put(field.name, Value::Word(words.into_iter().next().unwrap_or_default()));
            }
        }
    }

    /// Enters a text into a field.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn enter(&mut self, mask: &Mask, field: &'static Field, text: &str, control: &Control) -> Result<(), Message> {
        let text = text.trim();
        let value = match words(field, self, control) {
            Some(words) => Value::Word(word(field, words, text, self, control)?),
            None => Value::Number(number(field, text)?),
        };
        self.put(field.name, value);
        self.settle(mask, control);
        Ok(())
    }

    /// Whether a field is shown.
    pub fn shown(&self, field: &Field) -> bool {
        field.when.iter().all(|(name, words)| words.contains(&self.word(name)))
    }

    /// The first field that keeps NC start from measuring, and why.
    pub fn missing(&self, mask: &Mask) -> Option<(&'static Field, Message)> {
        let shown = mask.fields.iter().filter(|field| self.shown(field));
        let wrong = |field: &'static Field| Some((field, fits(field, self.number(field.name)).err()?));
        shown.filter(|field| matches!(field.kind, Kind::Length(_) | Kind::Angle)).find_map(wrong)
    }
}

/// The words from which a field chooses; none: it takes a number.
pub fn words(field: &Field, values: &Values, control: &Control) -> Option<Vec<String>> {
    let owned = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    Some(match field.kind {
        Kind::Length(_) | Kind::Angle => return None,
        Kind::Words(words) => owned(words),
        Kind::Offset { turned } => offset::choices(control, turned),
        Kind::OtherAxis => {
            let axes = ["X", "Y", "Z"].into_iter();
            axes.filter(|axis| *axis != values.word("axis")).map(str::to_owned).collect()
        }
        Kind::Turned => {
            let rotary = ROTARY.into_iter().filter(|axis| control.rotary_axis(axis).is_some());
            std::iter::once(ROTATION).chain(rotary).map(str::to_owned).collect()
        }
    })
}

/// All words that a field takes, where those that it offers are not all.
pub fn taken(field: &Field, values: &Values, control: &Control) -> Option<Vec<String>> {
    let mut words = words(field, values, control)?;
    if matches!(field.kind, Kind::Offset { .. }) {
        words.push(offset::others(control));
    }
    Some(words)
}

fn word(field: &Field, words: Vec<String>, text: &str, values: &Values, control: &Control) -> Result<String, Message> {
    if let Kind::Offset { turned } = field.kind
        && let Some(store) = offset::named(control, &text.to_ascii_uppercase(), turned)
    {
        return Ok(offset::name(control, store));
    }
    let found = words.into_iter().find(|word| word.eq_ignore_ascii_case(text));
    let known = || taken(field, values, control).unwrap_or_default().join(", ");
    found.ok_or_else(|| wrong_word(field.name, text, known()))
}

/// That a field takes other words, or has none.
pub(super) fn wrong_word(field: &str, text: &str, known: String) -> Message {
    let key = if text.is_empty() { "jog-empty-word" } else { "jog-wrong-word" };
    Message::new(key).text("field", field).text("text", text).text("known", known)
}

/// A number as a person types it, with a point or a comma.
fn number(field: &Field, text: &str) -> Result<f64, Message> {
    if text.is_empty() {
        return Err(Message::new("jog-empty-number").text("field", field.name));
    }
    let typed = text.replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite());
    let wrong = || Message::new("jog-wrong-number").text("field", field.name).text("text", text);
    let number = typed.ok_or_else(wrong)?;
    if number.abs() > FARTHEST {
        let far = Message::new("jog-wrong-far").text("field", field.name).number("value", number);
        return Err(far.number("limit", FARTHEST));
    }
    fits(field, number)?;
    Ok(number)
}

/// Whether a number is one that the field takes.
fn fits(field: &Field, number: f64) -> Result<(), Message> {
    let key = match field.kind {
        Kind::Length(Least::Above) if number <= 0.0 => "jog-wrong-above",
        Kind::Length(Least::Zero) if number < 0.0 => "jog-wrong-below",
        _ => return Ok(()),
    };
    Err(Message::new(key).text("field", field.name).number("value", number))
}
