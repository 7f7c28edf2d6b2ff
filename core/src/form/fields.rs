//! The fields of a form, in the order in which they are shown.

use super::{codes, masks, variant};
use crate::check;
use crate::control::Control;
use crate::entry::{Columns, Cycle, Inputs, Kind, Level, Param, Topic, Typed, factor, unit_name};
use crate::manual::Cited;
use crate::manual::explained::concept_of;
use crate::message::Message;
use crate::name::Name;
use crate::range::Range;
use crate::support::Support;
use serde::Serialize;

/// A field of a form. Numbers of `fallback` and `range` are in its unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Field {
    /// Parameter, as the manual writes it: `_SETVAL`.
    pub name: Name,
    /// Name of the field in words.
    pub label: Message,
    /// What it means.
    pub help: Message,
    /// Section of the form in which it is asked for.
    pub topic: Topic,
    /// How it is entered.
    #[serde(flatten)]
    pub entry: Entry,
    /// As typed; empty: nothing is.
    pub value: String,
    /// The expression of the program of which the value is the worth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expression: Option<String>,
    /// As a program has the value, where it was typed with a decimal comma.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub written: Option<String>,
    /// There where it chooses the variant, on which the other fields depend.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub chooses: bool,
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
    /// Which argument of the list of a newer control it is, where the call is written so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub argument: Option<Message>,
    /// Place in the manual.
    pub source: Cited,
    /// The concept that explains what it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub concept: Option<&'static str>,
}

/// How a field is entered.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "FieldKind"))]
pub enum Entry {
    /// Real number.
    Real {
        /// What the control takes.
        range: Range,
    },
    /// Whole number.
    Integer {
        /// What the control takes.
        range: Range,
    },
    /// One of its choices.
    Choice {
        /// What can be chosen.
        choices: Vec<Choice>,
    },
    /// A number put together from groups of digits.
    Digits {
        /// Digits that mean something of their own.
        digits: Vec<Group>,
    },
    /// Text.
    Text {
        /// Where it lists columns: these.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        columns: Option<Columns>,
    },
}

impl Field {
    /// The columns of a text that lists them.
    pub fn columns(&mut self) -> Option<&mut Columns> {
        if let Entry::Text { columns } = &mut self.entry { columns.as_mut() } else { None }
    }
}

/// A number with its name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Choice {
    /// Number as it is written.
    pub value: i64,
    /// Name of the choice.
    pub label: Message,
}

/// Digits that mean something of their own.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "DigitGroup"))]
pub struct Group {
    /// What they mean.
    pub label: Message,
    /// Value of the lowest digit: 1, 10, 100, …
    pub place: i64,
    /// How many.
    pub digits: u32,
    /// What they are now.
    pub value: i64,
    /// Named values; empty: any number of that many digits.
    pub choices: Vec<Choice>,
    /// The whole number to which each choice leads; empty: the digits alone change.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<i64>>"))]
    pub leads: Vec<i64>,
}

/// The fields that these values ask for; those that they do not use are left out, and those that the settings of the
/// machine leave out (`_MZ_MASK`, see [`crate::support`]).
pub fn fields(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Vec<Field> {
    fields_by(&check::read(cycle, typed, control, &mut Vec::new()), typed, control)
}

/// The fields that typed values ask for, which were read as these inputs.
pub(crate) fn fields_by(inputs: &Inputs, typed: &Typed, control: &Control) -> Vec<Field> {
    let support = Support::of(inputs.cycle, control);
    let shown = |param: &&Param| support.is_none_or(|support| !support.hides(param, inputs));
    inputs.cycle.params.iter().filter(shown).filter_map(|param| field(param, inputs, typed, control)).collect()
}

fn field(param: &'static Param, inputs: &Inputs, typed: &Typed, control: &Control) -> Option<Field> {
    let (level, reason) = param.need(inputs)?;
    let value = typed.get(param.name.as_str()).cloned().unwrap_or_default();
    let (stem, unit) = (param.label(inputs), param.unit_with(inputs));
    Some(Field {
        name: param.name,
        label: Message::new(format!("param-{stem}")),
        help: Message::new(format!("param-{stem}-help")),
        topic: param.topic(),
        entry: entry(param, inputs, shown(param.range, factor(unit, control)), control, &value),
        value,
        expression: None,
        written: None,
        chooses: matches!(param.kind, Kind::Variant(_)),
        code: matches!(param.kind, Kind::Knum).then_some(stem),
        fallback: param.fallback(control),
        unit: unit_name(unit, control),
        required: level == Level::Required && param.default.is_none(),
        reason: Message::new(reason),
        argument: None,
        source: Cited(param.source),
        concept: concept_of(param.name.as_str()).map(|concept| concept.id),
    })
}

/// Ranges of the catalogue are in mm and shown in the unit of the field.
fn shown(range: Range, per: f64) -> Range {
    Range { min: range.min / per, max: range.max / per, ..range }
}

fn entry(param: &Param, inputs: &Inputs, range: Range, control: &Control, value: &str) -> Entry {
    let number = inputs.given(param.name).unwrap_or(0.0) as i64;
    let support = Support::of(inputs.cycle, control);
    match &param.kind {
        Kind::Real => Entry::Real { range },
        Kind::Integer => Entry::Integer { range },
        Kind::Text(_) => Entry::Text { columns: param.columns.and_then(|read| read(value, inputs, control)) },
        Kind::Choice(_) | Kind::ChoiceBy(_) | Kind::ChoiceIf(..) => match param.kind.choices(inputs) {
            Some(list) => Entry::Choice { choices: codes::choices(list) },
            None => Entry::Real { range },
        },
        Kind::Variant([]) => Entry::Choice { choices: codes::variants(inputs.cycle) },
        Kind::Variant(groups) => Entry::Digits { digits: variant::groups(inputs, groups, number) },
        Kind::Digits(groups) => Entry::Digits { digits: masks::groups(support, codes::groups(groups, number, inputs)) },
        Kind::Knum => masks::target(support, codes::knum(param, inputs, control), inputs),
    }
}
