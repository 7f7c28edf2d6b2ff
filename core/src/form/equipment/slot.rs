//! A field of a row: what it holds, as it is shown and as it is typed.

use crate::control::{Control, Units, Value};
use crate::form::machine::{Entry, Refusal, Setting, accept};
use crate::geometry::Degrees;
use crate::machine::clock::Clock;
use crate::manual::Cited;
use crate::message::{Message, printable};
use crate::range::Range;
use serde::Serialize;

/// A field.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "EquipmentCell"))]
pub struct Cell {
    /// What is entered, and how; its name is the key of its words.
    #[serde(flatten)]
    pub setting: Setting,
    /// As typed.
    pub value: String,
}

/// What a field holds.
pub(super) enum Held<'a> {
    /// mm.
    Length(&'a mut f64),
    /// mm; empty: none.
    Limit(&'a mut Option<f64>),
    /// Radius in mm, shown as the diameter.
    Diameter(&'a mut f64),
    Angle(&'a mut Degrees),
    /// Degree.
    Degree(&'a mut f64),
    Plain(&'a mut f64),
    Whole(&'a mut i64),
    Choice(&'a mut i64, &'static [i64]),
    Text(&'a mut String),
    /// Empty: as delivered.
    Moment(&'a mut Clock),
}

/// A field that can be read and written.
pub(super) struct Slot<'a> {
    pub key: &'static str,
    held: Held<'a>,
    range: Range,
    /// Place in the manual.
    source: &'static str,
}

impl<'a> Slot<'a> {
    /// A field for any value.
    pub fn new(key: &'static str, held: Held<'a>) -> Slot<'a> {
        Slot { key, held, range: Range::ANY, source: "" }
    }

    /// With what is allowed, in the unit that is shown.
    pub fn within(self, range: Range) -> Slot<'a> {
        Slot { range, ..self }
    }

    /// With its place in the manual.
    pub fn cited(self, source: &'static str) -> Slot<'a> {
        Slot { source, ..self }
    }

    fn setting(&self, control: &Control) -> Setting {
        let (entry, unit) = match &self.held {
            Held::Length(_) | Held::Diameter(_) | Held::Limit(_) => (Entry::Real, length_unit(control)),
            Held::Angle(_) | Held::Degree(_) => (Entry::Real, "deg"),
            Held::Plain(_) => (Entry::Real, ""),
            Held::Whole(_) => (Entry::Integer, ""),
            Held::Choice(_, choices) => (Entry::Choice { choices }, ""),
            Held::Text(_) | Held::Moment(_) => (Entry::Text, ""),
        };
        let (name, key) = (self.key.to_owned(), self.key.to_owned());
        let (range, source) = (self.range, Cited(self.source));
        Setting { name, also: String::new(), key, field: None, entry, unit, range, source, idle: false, versions: None }
    }

    /// The field as it is shown.
    pub fn cell(&self, control: &Control) -> Cell {
        let factor = control.basic_factor();
        let value = match &self.held {
            Held::Length(value) => plain(**value / factor),
            Held::Limit(value) => value.map_or_else(String::new, |value| plain(value / factor)),
            Held::Diameter(radius) => plain(**radius * 2.0 / factor),
            Held::Angle(angle) => plain(angle.0),
            Held::Plain(value) | Held::Degree(value) => plain(**value),
            Held::Whole(value) | Held::Choice(value, _) => value.to_string(),
            Held::Text(text) => (**text).clone(),
            Held::Moment(clock) if **clock == Clock::default() => String::new(),
            Held::Moment(clock) => clock.to_string(),
        };
        Cell { setting: self.setting(control), value }
    }

    /// Takes a typed text; an empty one is 0, where the range has it.
    pub fn take(mut self, control: &Control, text: &str) -> Result<(), Refusal> {
        let factor = control.basic_factor();
        let setting = self.setting(control);
        let empty = text.trim().is_empty();
        if let (Held::Limit(limit), true) = (&mut self.held, empty) {
            **limit = None;
            return Ok(());
        }
        if let Held::Moment(clock) = &mut self.held {
            let wrong = |_| Refusal::new(Message::new("equip-moment").text("text", printable(text)));
            **clock = if empty { Clock::default() } else { text.parse().map_err(wrong)? };
            return Ok(());
        }
        let text = match &self.held {
            Held::Text(_) => text.trim(),
            _ if empty => "0",
            _ => text,
        };
        match (self.held, accept(&setting, text)?) {
            (Held::Length(value), Value::Number(number)) => *value = number * factor,
            (Held::Limit(value), Value::Number(number)) => *value = Some(number * factor),
            (Held::Diameter(radius), Value::Number(number)) => *radius = number * factor / 2.0,
            (Held::Angle(angle), Value::Number(number)) => *angle = Degrees(number),
            (Held::Plain(value) | Held::Degree(value), Value::Number(number)) => *value = number,
            (Held::Whole(value) | Held::Choice(value, _), Value::Number(number)) => *value = number as i64,
            (Held::Text(held), Value::Text(text)) => *held = text,
            _ => {}
        }
        Ok(())
    }
}

/// Decimals that stay after a change of units.
const KEPT: f64 = 1e9;

fn plain(value: f64) -> String {
    ((value * KEPT).round() / KEPT + 0.0).to_string()
}

fn length_unit(control: &Control) -> &'static str {
    if control.basic_units == Units::Inch { "inch" } else { "mm" }
}
