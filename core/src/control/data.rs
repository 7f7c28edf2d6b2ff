//! User and machine data: what was written, over what the control was delivered with.
//!
//! A control is copied at every keystroke and holds some hundred data as delivered; these are made once and shared.

use super::{Control, Make, TOOL_LENGTH_TYPE, Units, Value, arrays, gud, machine_data, nct_data};
use crate::dialect::Dialect;
use serde::de::{Deserialize, Deserializer, Visitor};
use std::collections::HashMap;
use std::fmt;
use std::fmt::Formatter;
use std::hash::{BuildHasherDefault, DefaultHasher};
use std::sync::OnceLock;
#[cfg(test)]
use std::{cell::RefCell, collections::BTreeSet};

/// Setting of ours, a name that no program can write: 1 lets `_MZ_MASK` decide over forms and code. Up to SW 4.5 the
/// masks were those of CYCLE103 (B:15297-15310, A:15977-16007).
pub const FORMS: &str = "PW-FORMS";
/// Setting of ours: 1 gives measuring in JOG the masks that it had up to measuring cycles SW 6.2.
pub const OLDER_JOG: &str = "PW-JOG";
/// Setting of ours: the generation of the control, 1 to 3; 0: not told. Up to 840D sl 1.x it takes assignments, from
/// 2.5 assignments with setting data, from 840D sl 2.7 and 828D 4.4 argument lists.
pub const GENERATION: &str = "PW-GENERATION";
/// The generation that takes argument lists.
pub const OF_LISTS: f64 = 3.0;

impl Control {
    /// Whether it has user data, an R parameter, a machine datum or a variable with this name for such a value.
    pub fn knows(&self, name: &str, value: &Value) -> bool {
        let text = matches!(value, Value::Text(_));
        (self.make().knows)(name, text) && self.variable(name).is_none() || self.defines(name, text)
    }

    /// Whether a definition file adds a datum of this name with this index, which holds a text, or a number.
    fn defines(&self, name: &str, text: bool) -> bool {
        let Some((stem, index)) = arrays::split(name) else { return false };
        let Some(datum) = self.definitions.find(stem) else { return false };
        datum.text() == text && index.len() == datum.sizes.len() && arrays::place(&index, &datum.sizes).is_some()
    }
}

/// Whether a SINUMERIK control has a datum of this name that holds a text, or a number.
pub(super) fn sinumerik(name: &str, text: bool) -> bool {
    if name.starts_with('_') || name.starts_with("E_") {
        return gud::named(name).is_some_and(|gud| gud.text() == text);
    }
    let machine = ["MD", "SD", "TOOLENV["].iter().any(|start| name.starts_with(start));
    let of_machine = machine_data::of_machine(name) && (!text || machine_data::is_text(name));
    machine || of_machine || !text && ([FORMS, OLDER_JOG, GENERATION].contains(&name) || numbered(name, 'R', 1000))
}

/// Whether an NCT control has a datum of this name that holds a text, or a number.
pub(super) fn nct(name: &str, text: bool) -> bool {
    !text && (numbered(name, '#', 10_000) || nct_data::find(name).is_some())
}

/// Whether it is a letter and a number below this one, as data are kept: without leading zeroes.
fn numbered(name: &str, letter: char, most: usize) -> bool {
    let digits = name.strip_prefix(letter).filter(|digits| *digits == "0" || !digits.starts_with('0'));
    digits.and_then(|digits| digits.parse::<usize>().ok()).is_some_and(|number| number < most)
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(Reader)
    }
}

struct Reader;

impl Visitor<'_> for Reader {
    type Value = super::Value;

    fn expecting(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("document-number-or-text")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Value, E> {
        Ok(Value::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Value, E> {
        Ok(Value::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Value, E> {
        Ok(Value::Number(value as f64))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::Text(text.to_owned()))
    }
}

#[cfg(test)]
thread_local! {
    /// Names of the data that are looked at, while a test wants to know what a cycle depends on.
    pub static LOOKED_AT: RefCell<Option<BTreeSet<String>>> = const { RefCell::new(None) };
}

#[cfg(test)]
fn look_at(name: &str) {
    LOOKED_AT.with_borrow_mut(|names| names.as_mut().map(|names| names.insert(name.to_owned())));
}

/// A value as a number, 0 where it is none.
fn number(value: Option<&Value>) -> f64 {
    if let Some(Value::Number(number)) = value { *number } else { 0.0 }
}

/// By name, in an order that is the same in every run. A measurement asks for some hundred data; names that begin alike
/// are slow to sort.
type ByName<T> = HashMap<String, T, BuildHasherDefault<DefaultHasher>>;

/// Data by name; see [`super::Control::data`].
#[derive(Clone, Debug)]
pub struct Data {
    delivered: &'static ByName<Value>,
    /// What differs; `None`: a delivered datum that is gone.
    written: ByName<Option<Value>>,
    /// SD 42950 as a number, 0 where it is none: every motion asks for it.
    length_type: f64,
}

impl Data {
    /// As delivered.
    pub fn delivered(dialect: Dialect, units: Units) -> Data {
        static MADE: [[OnceLock<ByName<Value>>; 2]; 2] = [const { [const { OnceLock::new() }; 2] }; 2];
        let made = &MADE[dialect as usize][units as usize];
        let delivered = made.get_or_init(|| (Make::of(dialect).delivered)(units).into_iter().collect());
        Data { delivered, written: ByName::default(), length_type: number(delivered.get(TOOL_LENGTH_TYPE)) }
    }

    /// A datum; `None` where it was never set.
    pub fn get(&self, name: &str) -> Option<&Value> {
        #[cfg(test)]
        look_at(name);
        self.written.get(name).map_or_else(|| self.delivered.get(name), Option::as_ref)
    }

    /// SD 42950, by which lengths of tools count.
    pub fn length_type(&self) -> f64 {
        #[cfg(test)]
        look_at(TOOL_LENGTH_TYPE);
        self.length_type
    }

    /// A datum that was written since the delivery.
    pub fn given(&self, name: &str) -> Option<&Value> {
        self.written.get(name)?.as_ref()
    }

    /// Whether there is such a datum.
    pub fn contains_key(&self, name: &str) -> bool {
        self.get(name).is_some()
    }

    /// Writes a datum; gives the one of before.
    pub fn insert(&mut self, name: String, value: Value) -> Option<Value> {
        let before = self.get(&name).cloned();
        if name == TOOL_LENGTH_TYPE {
            self.length_type = number(Some(&value));
        }
        self.written.insert(name, Some(value));
        before
    }

    /// Takes a datum away; gives it.
    pub fn remove(&mut self, name: &str) -> Option<Value> {
        let before = self.get(name).cloned();
        if name == TOOL_LENGTH_TYPE {
            self.length_type = 0.0;
        }
        self.written.insert(name.to_owned(), None);
        before
    }

    /// Whether the same was written to both: then they are equal, which takes no look at what was delivered.
    pub fn written_alike(&self, other: &Data) -> bool {
        self.written == other.written
    }

    /// How many were written since the delivery.
    pub fn written(&self) -> usize {
        self.written.len()
    }

    /// All data, in no order.
    pub fn iter(&self) -> impl Iterator<Item = (&String, &Value)> {
        let delivered = self.delivered.iter();
        let written = self.written.iter();
        delivered
            .filter(|(name, _)| !self.written.contains_key(*name))
            .chain(written.filter_map(|(name, value)| Some((name, value.as_ref()?))))
    }

    /// Data that were written since the delivery to one of both, of the same make and system of units.
    pub fn unlike<'a>(&'a self, other: &'a Data) -> impl Iterator<Item = (&'a String, &'a Value)> {
        let written = self.written.iter().filter_map(|(name, value)| Some((name, value.as_ref()?)));
        let there = other.written.keys().filter(|name| !self.written.contains_key(*name));
        written.chain(there.filter_map(|name| Some((name, self.delivered.get(name)?))))
    }

    /// Their names, in no order.
    pub fn keys(&self) -> impl Iterator<Item = &String> {
        self.iter().map(|(name, _)| name)
    }
}

impl PartialEq for Data {
    fn eq(&self, other: &Data) -> bool {
        self.iter().all(|(name, value)| other.get(name) == Some(value))
            && other.keys().all(|name| self.contains_key(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn what_is_written_counts_before_what_was_delivered() {
        // oracle: hand
        let delivered = Data::delivered(Dialect::Nct, Units::Metric);
        let mut data = delivered.clone();
        data.insert("#509".to_owned(), Value::Number(41.0));
        data.insert("#500".to_owned(), Value::Number(1.0));
        data.remove("#511");
        assert_eq!(data.get("#509"), Some(&Value::Number(41.0)));
        assert!(!data.contains_key("#511"));
        let calls = |name: &&str| name.starts_with("P90");
        let names: BTreeSet<_> = data.keys().map(String::as_str).filter(|name| !calls(name)).collect();
        assert_eq!(names, BTreeSet::from(["#1002", "#1003", "#500", "#509", "#512", "P9143"]));
        assert_ne!(data, delivered);
        assert_eq!(data.length_type(), 0.0);
        data.insert(TOOL_LENGTH_TYPE.to_owned(), Value::Number(2.0));
        assert_eq!(data.length_type(), 2.0);
        data.remove(TOOL_LENGTH_TYPE);
        assert_eq!(data.length_type(), 0.0);
        data.insert("#509".to_owned(), Value::Number(40.0));
        data.insert("#511".to_owned(), Value::Number(1500.0));
        data.remove("#500");
        assert_eq!(data, delivered);
    }
}
