//! The text of a call.

use super::{Foreign, ForeignCycle, Parameter, Value};
use crate::message::Message;
use std::collections::BTreeMap;

/// Why a call is not written.
#[derive(Clone, Debug, PartialEq)]
pub enum Unwritten {
    /// Not enough of the cycle is published: why.
    Unpublished(Message),
    /// It has no such parameter.
    Unknown(String),
    /// What stands at a parameter is no number.
    NoNumber(&'static str),
    /// The value of a parameter lies outside its range.
    Outside(&'static str),
    /// The first of these limits, the largest value, is smaller than the second.
    Limits(&'static str, &'static str),
    /// These parameters need a value.
    Missing(Vec<&'static str>),
}

/// A call with the values as typed; what is usual where none is typed.
///
/// # Errors
/// It cannot be written: why.
pub fn written(
    control: &Foreign,
    cycle: &'static ForeignCycle,
    typed: &BTreeMap<String, String>,
) -> Result<String, Unwritten> {
    if let Some(why) = cycle.unwritten(control) {
        return Err(Unwritten::Unpublished(why));
    }
    if let Some(name) = typed.keys().find(|name| cycle.parameter(name).is_none()) {
        return Err(Unwritten::Unknown(name.clone()));
    }
    let (mut values, mut missing) = (Vec::new(), Vec::new());
    for parameter in cycle.parameters {
        let text = typed.iter().find(|(name, _)| name.eq_ignore_ascii_case(parameter.name)).map(|(_, text)| text);
        match text {
            Some(text) => {
                let number = text.trim().replace(',', ".").parse().ok().filter(|value: &f64| value.is_finite());
                values.push((parameter, number.ok_or(Unwritten::NoNumber(parameter.name))?));
            }
            None => match usual(parameter) {
                Some(value) => values.push((parameter, value)),
                None => missing.push(parameter.name),
            },
        }
    }
    if !missing.is_empty() {
        return Err(Unwritten::Missing(missing));
    }
    if let Some((parameter, _)) = values.iter().find(|(parameter, value)| !parameter.takes(*value)) {
        return Err(Unwritten::Outside(parameter.name));
    }
    let value = |name: &str| values.iter().find(|(known, _)| known.name == name).map_or(0.0, |(_, value)| *value);
    let crossed = cycle.limits().find(|(most, least)| are_crossed(value(most.name), value(least.name)));
    if let Some((most, least)) = crossed {
        return Err(Unwritten::Limits(most.name, least.name));
    }
    Ok((control.call)(cycle, &values))
}

/// Whether no size is within two limits; 0 is no limit.
pub(super) fn are_crossed(most: f64, least: f64) -> bool {
    most != 0.0 && most < least
}

/// What is written where nobody says otherwise: no limits, no tool.
fn usual(parameter: &Parameter) -> Option<f64> {
    match parameter.value {
        Value::Usual(value) => Some(value),
        Value::Maximum(_) | Value::Minimum(_) | Value::Tool => Some(0.0),
        _ => None,
    }
}
