//! The machine as a form: what is set once per machine, from the tables of user and machine data.

use crate::check::{Parsed, parse};
use crate::control::gud::{Element, Gud, System, Unit};
use crate::control::idle::idle;
use crate::control::machine_data::MACHINE_DATA;
use crate::control::nct_data::NctDatum;
use crate::control::setting_data::{SETTING_DATA, SettingDatum, replaces};
use crate::control::versions::{Versions, versions};
use crate::control::{Control, GENERATION, OLDER_JOG, Units, Value, gud, machine_data, nct_data};
use crate::dialect::Dialect;
use crate::manual::Cited;
use crate::message::Message;
use crate::range::Range;
use crate::refused::Refused;
use crate::support;
use serde::Serialize;

/// Most places of one element that are shown; the control may have thousands of memories.
const SHOWN: usize = 100;

/// How a datum is entered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "MachineKind"))]
pub enum Entry {
    /// A number.
    Real,
    /// A whole number.
    Integer,
    /// One of its choices.
    Choice {
        /// The numbers.
        choices: &'static [i64],
    },
    /// A text.
    Text,
}

/// A datum that can be set.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Setting {
    /// As a program writes it: `_WP[0,1]`, `MD18600`.
    pub name: String,
    /// What else it is looked for as: the identifier of a setting datum, the user datum of older controls.
    #[serde(skip_serializing_if = "String::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<String>"))]
    pub also: String,
    /// Key of its name; `.help`, and `.v0`, `.v1`, … of a choice, may stand behind it.
    pub key: String,
    /// Array whose field with this number (from 1) it belongs to.
    #[serde(skip)]
    pub field: Option<(&'static str, usize)>,
    /// How it is entered.
    #[serde(flatten)]
    pub entry: Entry,
    /// Unit as it counts on this machine.
    pub unit: &'static str,
    /// What is allowed, in that unit.
    pub range: Range,
    /// Place in the manual.
    pub source: Cited,
    /// Whether nothing in the simulation reads it.
    pub idle: bool,
    /// Versions of the measuring cycles in which it is there, where that is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub versions: Option<&'static Versions>,
}

/// Settings of one subject.
pub struct Group {
    /// Key of its name.
    pub key: String,
    /// Settings of the group, fields of the same number together.
    pub settings: Vec<Setting>,
}

/// Everything that can be set on this control.
pub fn groups(control: &Control) -> Vec<Group> {
    if control.dialect == Dialect::Nct {
        return nct(control.basic_units);
    }
    let subjects = gud::SUBJECTS.iter().map(|subject| group(subject.key, of_subject(subject, control)));
    let machine = group("machine-data", MACHINE_DATA.iter().flat_map(of_machine_datum).collect());
    let newer = SETTING_DATA.iter().filter(|_| control.has_setting_data());
    let newer = group("setting-data", newer.flat_map(|datum| of_setting_datum(datum, control)).collect());
    subjects.chain([machine, newer]).filter(|group| !group.settings.is_empty()).collect()
}

/// The groups of an NCT control.
fn nct(basic: Units) -> Vec<Group> {
    let setting = |datum: &NctDatum| Setting {
        name: datum.name.to_owned(),
        also: String::new(),
        key: datum.key(),
        field: None,
        entry: match datum.element.choices {
            [] if datum.element.unit == Unit::None => Entry::Integer,
            [] => Entry::Real,
            choices => Entry::Choice { choices },
        },
        unit: unit(datum.element.unit, basic),
        range: datum.element.range,
        source: Cited(datum.element.source),
        idle: false,
        versions: None,
    };
    let subjects = nct_data::SUBJECTS.iter();
    subjects.map(|subject| group(subject.key, subject.data.iter().map(setting).collect())).collect()
}

fn group(subject: &str, settings: Vec<Setting>) -> Group {
    Group { key: format!("machine-group-{subject}"), settings }
}

/// Settings of a subject; before those of the masks stand the generation of the control and whether they count, before
/// those of JOG its version.
fn of_subject(subject: &'static gud::Subject, control: &Control) -> Vec<Setting> {
    let own = match subject.key {
        gud::MASKS => vec![
            ours(GENERATION, "datum-pw-generation", &[0, 1, 2, 3]),
            ours(support::FORMS, support::FORMS_KEY, &[0, 1]),
        ],
        gud::JOG => vec![ours(OLDER_JOG, "datum-pw-jog", &[0, 1])],
        _ => Vec::new(),
    };
    let data = subject.data.iter().filter(|gud| gud.of_machine());
    own.into_iter().chain(data.flat_map(|gud| of_datum(gud, control))).collect()
}

/// A setting of ours that is one of these numbers.
fn ours(name: &str, key: &str, choices: &'static [i64]) -> Setting {
    Setting {
        name: name.to_owned(),
        also: String::new(),
        key: key.to_owned(),
        field: None,
        entry: Entry::Choice { choices },
        unit: "",
        range: Range::closed(0.0, choices.len() as f64 - 1.0),
        source: Cited(""),
        idle: false,
        versions: None,
    }
}

/// Settings of a datum, field by field, without those that newer controls have in setting data.
fn of_datum(gud: &'static Gud, control: &Control) -> Vec<Setting> {
    let fields = (control.number(gud.counted) as usize).min(SHOWN);
    let generation = control.number(GENERATION);
    let shown = gud.elements.iter().filter(|one| !one.internal && !replaces(gud, one, generation));
    let places = shown.flat_map(|element| gud.places(element, fields).into_iter().map(move |at| (at, element)));
    let mut places: Vec<(Vec<usize>, &Element)> = places.collect();
    if !gud.counted.is_empty() {
        places.sort_by_key(|(at, _)| at.first().copied()); // stable: elements keep their order
    }
    places.into_iter().map(|(at, element)| setting(gud, element, &at, control.basic_units)).collect()
}

fn setting(gud: &'static Gud, element: &Element, at: &[usize], basic: Units) -> Setting {
    let numbered = !gud.counted.is_empty();
    let entry = match gud.kind {
        _ if !element.choices.is_empty() => Entry::Choice { choices: element.choices },
        gud::Kind::Text | gud::Kind::Frame => Entry::Text,
        gud::Kind::Real => Entry::Real,
        gud::Kind::Integer | gud::Kind::Bool => Entry::Integer,
    };
    let name = gud.spelled(at);
    Setting {
        idle: idle(&name),
        versions: versions(&name),
        name,
        also: String::new(),
        key: gud.key(element),
        field: at.first().filter(|_| numbered).map(|k| (gud.name, k + 1)),
        entry,
        unit: unit(element.unit, basic),
        range: element.range,
        source: Cited(element.source),
    }
}

/// Settings of a setting datum: what its user datum says counts for it.
fn of_setting_datum(datum: &'static SettingDatum, control: &Control) -> Vec<Setting> {
    let generation = control.number(GENERATION);
    let also = || format!("{} {}", datum.identifier(), datum.older_name());
    let of_its_own = |name: String| Setting {
        name,
        also: also(),
        key: datum.key(generation),
        field: None,
        entry: Entry::Real,
        unit: "",
        range: Range::ANY,
        source: Cited(""),
        idle: true,
        versions: None,
    };
    let one = |place: Option<usize>| match datum.older(generation) {
        Some((gud, element)) => {
            let older = setting(gud, element, &datum.older_place(place, generation), control.basic_units);
            Setting {
                name: datum.spelled(place),
                also: also(),
                field: None,
                source: Cited(""),
                versions: None,
                ..older
            }
        }
        None => of_its_own(datum.spelled(place)),
    };
    datum.places(control).into_iter().map(one).collect()
}

fn of_machine_datum(datum: &'static machine_data::MachineDatum) -> Vec<Setting> {
    let setting = |name: String| Setting {
        idle: idle(&name),
        versions: versions(&name),
        name,
        also: String::new(),
        key: datum.key(),
        field: None,
        entry: match datum.text {
            true => Entry::Text,
            false if datum.is_whole() => Entry::Integer,
            false => Entry::Real,
        },
        unit: datum.unit,
        range: datum.range(),
        source: Cited(datum.source),
    };
    datum.names().into_iter().map(setting).collect()
}

/// Name of a unit on a machine with this basic system.
fn unit(unit: Unit, basic: Units) -> &'static str {
    let inch = |system| system == System::Basic && basic == Units::Inch;
    match unit {
        Unit::None => "",
        Unit::Length(system) if inch(system) => "inch",
        Unit::Length(_) => "mm",
        Unit::Feed(system) if inch(system) => "inch/min",
        Unit::Feed(_) => "mm/min",
        Unit::Speed(system) if inch(system) => "ft/min",
        Unit::Speed(_) => "m/min",
        Unit::Degree => "deg",
        Unit::Rpm => "rpm",
        Unit::Percent => "%",
    }
}

/// Why a typed value is not taken, and what would be.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Refusal {
    /// What is wrong.
    pub message: Message,
    /// The cure.
    pub hint: Message,
}

impl Refusal {
    /// With the cure whose key is that of the cause and `-hint`.
    pub(crate) fn new(message: Message) -> Refusal {
        Refusal { hint: Message::new(format!("{}-hint", message.key)), message }
    }
}

impl Refusal {
    /// What a machine cannot be.
    pub(crate) fn of(refused: Refused) -> Refusal {
        Refusal { message: refused.message, hint: Message::new("equip-hint") }
    }
}

/// The value that a typed text gives a setting; an empty one is answered by the caller with what is delivered.
///
/// # Errors
/// Why the text is no value of the setting.
pub fn accept(setting: &Setting, text: &str) -> Result<Value, Refusal> {
    if setting.entry == Entry::Text {
        return plain(text);
    }
    let number = match parse(text) {
        Parsed::Number(number) => Some(number),
        _ => machine_data::number(text),
    };
    let Some(number) = number else {
        return Err(Refusal::new(Message::new("check-not-a-number").text("value", text)));
    };
    if setting.entry == Entry::Integer && number.fract() != 0.0 {
        return Err(Refusal::new(Message::new("check-not-whole").number("value", number)));
    }
    allowed(setting, number).map(|()| Value::Number(number))
}

/// Data of a machine that are no values of their settings, as the form and the check of a machine refuse them: a setup
/// file may have them, as a program may write them.
pub fn doubts(control: &Control) -> Vec<(String, Refusal)> {
    groups(control).iter().flat_map(|group| &group.settings).filter_map(|setting| doubt(control, setting)).collect()
}

/// Why the value that a machine has is none of a setting.
pub fn doubt(control: &Control, setting: &Setting) -> Option<(String, Refusal)> {
    let Some(Value::Number(number)) = control.data.get(&setting.name) else { return None };
    let switch = |name: &str| match control.data.get(name) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    };
    if setting.entry == Entry::Text || !has_effect(&setting.name, switch) {
        return None;
    }
    let refusal = accept(setting, &number.to_string()).err()?;
    Some((setting.name.clone(), refusal))
}

/// Whether it matters what a datum is: no speed of positioning does with collision monitoring off (B:13751-13763), no
/// direction of rotation where the cycle has the speed.
pub fn has_effect(name: &str, switch: impl Fn(&str) -> Option<f64>) -> bool {
    match name {
        "_SPEED[1]" | "_SPEED[2]" => switch("_CHBIT[2]") != Some(0.0),
        "_CM[5]" => switch("_CBIT[12]") != Some(1.0),
        _ => true,
    }
}

/// A text that fits between quotation marks.
fn plain(text: &str) -> Result<Value, Refusal> {
    if text.contains('"') || text.chars().any(char::is_control) {
        return Err(Refusal::new(Message::new("check-text-characters")));
    }
    Ok(Value::Text(text.to_owned()))
}

fn allowed(setting: &Setting, number: f64) -> Result<(), Refusal> {
    let range = setting.range;
    let hint = match setting.entry {
        Entry::Choice { choices } if choices.iter().all(|choice| *choice as f64 != number) => {
            let list: Vec<String> = choices.iter().map(i64::to_string).collect();
            Message::new("check-range-choice-hint").text("choices", list.join(", "))
        }
        _ if range.contains(number) => return Ok(()),
        _ if range.max.is_finite() => Message::new("check-range-both-hint"),
        _ if range.min_included => Message::new("check-range-from-hint"),
        _ => Message::new("check-range-above-hint"),
    };
    let unit = match setting.unit {
        "" => String::new(),
        unit => format!("\u{a0}{unit}"),
    };
    let message = Message::new("check-range").text("param", &setting.name).number("value", number).text("unit", &unit);
    let hint = hint.number("min", range.min).number("max", range.max);
    Err(Refusal { message, hint: hint.text("unit", unit) })
}
