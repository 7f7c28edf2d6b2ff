//! The machine of a question: the core's own, or one that the user described.

use super::Error;
use crate::control::{Plane, UnitFunction, Units, Value};
use crate::dialect::Dialect;
use crate::machine::Setup;
use crate::setup_file;
use crate::setup_file::SetupFile;
use serde::de::value::{MapAccessDeserializer, StringDeserializer};
use serde::de::{DeserializeSeed, IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;

/// The machine of a question.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(untagged))]
pub enum Machine {
    /// The core's own, with what is chosen for it.
    Own(OwnMachine),
    /// One that a setup file describes.
    File(Box<SetupFile>),
}

/// The core's own machine.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OwnMachine {
    /// What it begins with.
    pub own: Beginning,
}

/// What the core's own machine begins with.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Beginning {
    /// Basic system of units; none: metric.
    pub basic: Option<Units>,
    /// Working plane; absent: G17.
    #[cfg_attr(test, ts(optional = false, as = "Plane"))]
    pub plane: Option<Plane>,
    /// G function of units; none: that of the basic system.
    #[cfg_attr(test, ts(optional = false, as = "UnitFunction"))]
    pub units: Option<UnitFunction>,
    /// User and machine data that differ.
    #[cfg_attr(test, ts(optional, as = "Option<BTreeMap<String, Value>>"))]
    pub data: BTreeMap<String, Value>,
    /// User data that definition files add: lines with `DEF`.
    #[cfg_attr(test, ts(optional, as = "Option<Vec<String>>"))]
    pub definitions: Vec<String>,
}

impl<'de> Deserialize<'de> for Machine {
    fn deserialize<D: Deserializer<'de>>(document: D) -> Result<Machine, D::Error> {
        document.deserialize_map(Either)
    }
}

/// Reads a machine: the first member tells which document it is.
struct Either;

impl<'de> Visitor<'de> for Either {
    type Value = Machine;

    fn expecting(&self, to: &mut fmt::Formatter) -> fmt::Result {
        to.write_str("document-object")
    }

    fn visit_map<M: MapAccess<'de>>(self, mut members: M) -> Result<Machine, M::Error> {
        let first: Option<String> = members.next_key()?;
        if first.as_deref() == Some("own") {
            return Ok(Machine::Own(OwnMachine { own: members.next_value()? }));
        }
        let all = MapAccessDeserializer::new(Again { first, rest: members });
        Ok(Machine::File(Box::new(SetupFile::deserialize(all)?)))
    }
}

/// The members of a document whose first name was read already.
struct Again<M> {
    first: Option<String>,
    rest: M,
}

impl<'de, M: MapAccess<'de>> MapAccess<'de> for Again<M> {
    type Error = M::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, M::Error> {
        let Some(first) = self.first.take() else { return self.rest.next_key_seed(seed) };
        let first: StringDeserializer<M::Error> = first.into_deserializer();
        seed.deserialize(first).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, M::Error> {
        self.rest.next_value_seed(seed)
    }
}

/// What a question starts from.
pub(super) struct Start {
    /// What is there.
    pub setup: Setup,
    /// Whether the user described it; else it is the core's own.
    pub described: bool,
}

/// The machine of a question; none: the core's own as it is.
pub(super) fn start(dialect: Dialect, machine: Option<Machine>) -> Result<Start, Error> {
    let own = match machine {
        Some(Machine::File(file)) => {
            return Ok(Start { setup: setup_file::setup(*file)?, described: true });
        }
        Some(Machine::Own(OwnMachine { own })) => own,
        _ => Beginning::default(),
    };
    let basic = own.basic.unwrap_or(Units::Metric);
    let mut setup = Setup::calibrated_in(dialect, own.plane.unwrap_or(Plane::G17), basic);
    if let Some(function) = own.units {
        super::choose_units(&mut setup.control, function)?;
    }
    if !own.definitions.is_empty() {
        setup.control.definitions = setup_file::defined(&own.definitions)?;
    }
    if !own.data.is_empty() {
        for (name, value) in own.data {
            setup.control.data.insert(name, value);
        }
        setup.control.take_setting_data();
        setup.control.fill_fields();
        setup.has_its_data()?;
    }
    Ok(Start { setup, described: false })
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: self (what a described machine is held against): it is not looked at at every keystroke
    #[test]
    fn the_own_machine_can_be() {
        for dialect in [Dialect::Sinumerik, Dialect::Nct] {
            for units in [Units::Metric, Units::Inch] {
                assert_eq!(Setup::calibrated_in(dialect, Plane::G17, units).possible(), Ok(()));
            }
        }
    }
}
