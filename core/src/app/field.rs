//! A field of a form as it is shown.

use crate::form;
use crate::form::{Choice, Entry, Group};
use crate::message::Message;
use crate::name::Name;
use crate::range::Range;
use serde::Serialize;

/// A field of a form. Numbers of `fallback` and `range` are in its unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Field {
    /// Parameter, as the manual writes it: `_SETVAL`.
    pub name: Name,
    /// Its name in words.
    pub label: Message,
    /// What it means.
    pub help: Message,
    /// How it is entered.
    pub kind: FieldKind,
    /// As typed; empty: nothing is.
    pub value: String,
    /// The expression of the program of which the value is the worth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expression: Option<String>,
    /// There where it chooses the variant, on which the other fields depend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chooses: Option<bool>,
    /// What the number is a code of, where that is not the same in all variants.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<&'static str>,
    /// What counts while nothing is typed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fallback: Option<f64>,
    /// `mm`, `inch`, `deg`, `mm/min`, `inch/min` or nothing.
    pub unit: &'static str,
    /// Whether it has to be given.
    pub required: bool,
    /// Why it is required or optional.
    pub reason: Message,
    /// What the control takes, of a number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
    /// What can be chosen, of a choice.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub choices: Option<Vec<Choice>>,
    /// Digits that mean something of their own, of a number that is put together from such.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub digits: Option<Vec<Group>>,
    /// Place in the manual.
    pub source: &'static str,
}

/// How a field is entered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum FieldKind {
    /// Real number.
    Real,
    /// Whole number.
    Integer,
    /// One of its choices.
    Choice,
    /// A number put together from groups of digits.
    Digits,
    /// Text.
    Text,
}

impl Field {
    /// A field of the form; `expression`: that of the program of which the value is the worth.
    pub(super) fn new(field: form::Field, expression: Option<String>) -> Field {
        let (mut range, mut choices, mut digits) = (None, None, None);
        let kind = match field.entry {
            Entry::Real => FieldKind::Real,
            Entry::Integer => FieldKind::Integer,
            Entry::Text(_) => FieldKind::Text,
            Entry::Choice(list) => {
                choices = Some(list);
                FieldKind::Choice
            }
            Entry::Digits(groups) => {
                digits = Some(groups);
                FieldKind::Digits
            }
        };
        if matches!(kind, FieldKind::Real | FieldKind::Integer) {
            range = Some(field.range);
        }
        Field {
            name: field.name,
            label: field.label,
            help: field.help,
            kind,
            value: field.value,
            expression,
            chooses: field.chooses.then_some(true),
            code: field.code,
            fallback: field.fallback,
            unit: field.unit,
            required: field.required,
            reason: field.reason,
            range,
            choices,
            digits,
            source: field.source,
        }
    }
}
