//! The fields of a form, in the order in which they are shown.

use super::{codes, masks, variant};
use crate::check;
use crate::control::Control;
use crate::entry::{Cycle, Inputs, Kind, Level, Param, Typed, factor, unit_name};
use crate::message::Message;
use crate::name::Name;
use crate::range::Range;
use crate::support::Support;

/// One field. Numbers of `fallback` and `range` are in the unit that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// As the manual writes it.
    pub name: Name,
    /// Its name in words.
    pub label: Message,
    /// What it means.
    pub help: Message,
    /// How it is entered.
    pub entry: Entry,
    /// As typed.
    pub value: String,
    /// It chooses the variant, on which the other fields depend.
    pub chooses: bool,
    /// What the number is a code of, where its digits mean something else in other variants.
    pub code: Option<&'static str>,
    /// Value that counts while nothing is typed.
    pub fallback: Option<f64>,
    /// `mm`, `inch`, `deg`, `mm/min`, `inch/min` or nothing.
    pub unit: &'static str,
    /// Whether it has to be given.
    pub required: bool,
    /// Why it is asked for.
    pub reason: Message,
    /// What the control takes.
    pub range: Range,
    /// Place in the manual.
    pub source: &'static str,
}

/// How a field is entered.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// Real number.
    Real,
    /// Whole number.
    Integer,
    /// Text of at most this many characters.
    Text(usize),
    /// One of these numbers.
    Choice(Vec<Choice>),
    /// A number put together from groups of digits.
    Digits(Vec<Group>),
}

/// A number with its name.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Choice {
    /// Number as it is written.
    pub value: i64,
    /// Its name.
    pub label: Message,
}

/// Digits that mean something of their own.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
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
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let support = Support::of(cycle, control);
    let shown = |param: &&Param| support.is_none_or(|support| !support.hides(param, &inputs));
    let params = cycle.params.iter().filter(shown);
    params.filter_map(|param| field(param, &inputs, typed, control)).collect()
}

fn field(param: &'static Param, inputs: &Inputs, typed: &Typed, control: &Control) -> Option<Field> {
    let (level, reason) = param.need(inputs)?;
    let (stem, unit) = (param.label(inputs), param.unit_with(inputs));
    Some(Field {
        name: param.name,
        label: Message::new(format!("param-{stem}")),
        help: Message::new(format!("param-{stem}-help")),
        entry: entry(param, inputs, control),
        value: typed.get(param.name.as_str()).cloned().unwrap_or_default(),
        chooses: matches!(param.kind, Kind::Variant(_)),
        code: matches!(param.kind, Kind::Knum).then_some(stem),
        fallback: param.fallback(control),
        unit: unit_name(unit, control),
        required: level == Level::Required && param.default.is_none(),
        reason: Message::new(reason),
        range: shown(param.range, factor(unit, control)),
        source: param.source,
    })
}

/// Ranges of the catalogue are in mm and shown in the unit of the field.
fn shown(range: Range, per: f64) -> Range {
    Range { min: range.min / per, max: range.max / per, ..range }
}

fn entry(param: &Param, inputs: &Inputs, control: &Control) -> Entry {
    let number = inputs.given(param.name).unwrap_or(0.0) as i64;
    let support = Support::of(inputs.cycle, control);
    match &param.kind {
        Kind::Real => Entry::Real,
        Kind::Integer => Entry::Integer,
        Kind::Text(most) => Entry::Text(*most),
        Kind::Choice(_) | Kind::ChoiceBy(_) | Kind::ChoiceIf(..) => {
            let choices = param.kind.choices(inputs);
            choices.map_or(Entry::Real, |list| Entry::Choice(codes::choices(list)))
        }
        Kind::Variant([]) => Entry::Choice(codes::variants(inputs.cycle)),
        Kind::Variant(groups) => Entry::Digits(variant::groups(inputs.cycle, groups, number)),
        Kind::Digits(groups) => {
            let groups = codes::groups(groups, number);
            Entry::Digits(masks::groups(support, groups))
        }
        Kind::Knum => masks::target(support, codes::knum(param, inputs, control), inputs),
    }
}
