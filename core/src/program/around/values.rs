//! The values of a block: what a field has where nothing is entered, what it offers, what is wrong with it.

use super::{Block, Field, Kind, is_difference, results};
use crate::check::{Parsed, parse};
use crate::dialect::Dialect;
use crate::entry::{Element, Inputs, ResultField, Typed, names};
use crate::message::Message;
use crate::program::of_control::is_taken;
use crate::range::Range;

/// Longest name of a label, a program or a file, characters.
const LONGEST_NAME: usize = 31;
/// Longest operator text, characters.
const LONGEST_TEXT: usize = 100;
/// Numbers that are tried for the name of a file.
const MOST_FILES: u32 = 1000;
/// Numbers of programs and blocks of NCT.
const NUMBERS: Range = Range::closed(1.0, 9999.0);

/// What a field has where nothing is entered; a text: the key of it.
pub fn preset(field: &Field, inputs: &Inputs) -> String {
    match field.kind {
        Kind::Result => named(results(inputs).first()),
        Kind::Deviation => named(results(inputs).first().filter(|field| is_difference(field))),
        Kind::Side => side(inputs).to_owned(),
        Kind::Limit => limit(field, inputs),
        _ => field.preset.to_owned(),
    }
}

fn named(field: Option<&&'static ResultField>) -> String {
    field.map_or_else(String::new, |field| field.name.to_owned())
}

/// Half of the tolerance that the call gives, as deviations count from its middle (B:2203-2211), else what the field
/// has (mm); in the unit of the call.
fn limit(field: &Field, inputs: &Inputs) -> String {
    let given = [names::TUL, names::TLL].iter().any(|name| inputs.written.contains(name));
    let both = inputs.any(names::TUL).zip(inputs.any(names::TLL)).filter(|_| given);
    let half = both.map(|(upper, lower)| (upper - lower) / 2.0).filter(|half| *half > 0.0);
    let Some(limit) = half.or_else(|| field.preset.parse().ok()) else { return field.preset.to_owned() };
    format!("{}", (limit / inputs.units.factor() * 1e4).round() / 1e4)
}

/// What is entered, and of a file that is made anew its name where none is: a log of the same name would be deleted
/// (B:11229). `taken`: text of the program in upper case.
pub fn completed(block: &Block, typed: &Typed, taken: &str) -> Typed {
    let mut all = typed.clone();
    for field in block.fields.iter().filter(|field| matches!(field.kind, Kind::NewFile)) {
        let entered = typed.get(field.name).is_some_and(|text| !text.trim().is_empty());
        let stem = field.preset.trim_end_matches(|one: char| one.is_ascii_digit());
        let free = (1..=MOST_FILES).map(|number| format!("{stem}{number}"));
        let free = free.filter(|_| !entered).find(|name| !taken.contains(&format!("\"{name}\"")));
        all.extend(free.map(|name| (field.name.to_owned(), name)));
    }
    all
}

/// Material is left where a hole is too small, and where a shaft is too large.
fn side(inputs: &Inputs) -> &'static str {
    match inputs.cycle.aim(inputs).map(|aim| aim.element) {
        Some(Element::Hole | Element::Groove | Element::Pocket) => "<",
        _ => ">",
    }
}

/// What a field offers: values with the key of the name of each; empty: anything can be entered.
pub fn choices(field: &Field, inputs: &Inputs) -> Vec<(&'static str, &'static str)> {
    match field.kind {
        Kind::Result | Kind::Deviation => results(inputs).into_iter().map(|field| (field.name, field.key)).collect(),
        Kind::Side => vec![("<", "around-side-small"), (">", "around-side-large")],
        _ => Vec::new(),
    }
}

/// What is entered; else what counts without; a text in the reader's words.
pub(super) fn value(field: &Field, typed: &Typed, inputs: &Inputs, words: &dyn Fn(&str) -> String) -> String {
    let entered = typed.get(field.name).map(|text| text.trim()).filter(|text| !text.is_empty());
    match (entered, &field.kind) {
        (None, Kind::Text) => text(&words(field.preset), inputs.cycle.dialect),
        (None, _) => preset(field, inputs),
        (Some(entered), Kind::Text) => text(entered, inputs.cycle.dialect),
        (Some(entered), kind) => plain(kind, entered),
    }
}

/// As a program has it: a number with a point, a name in upper case.
fn plain(kind: &Kind, entered: &str) -> String {
    match (kind, parse(entered)) {
        (Kind::Limit | Kind::Whole(_) | Kind::Variable(_), Parsed::Number(number)) => format!("{number}"),
        (Kind::Program | Kind::Target | Kind::Result | Kind::Deviation, _) => entered.to_ascii_uppercase(),
        _ => entered.to_owned(),
    }
}

/// Whether a sign ends a text of the program, or its line.
fn ends(one: char, dialect: Dialect) -> bool {
    one.is_control() || one == '"' || dialect == Dialect::Nct && matches!(one, '(' | ')')
}

/// A text without what would end it.
fn text(entered: &str, dialect: Dialect) -> String {
    entered
        .chars()
        .map(|one| if ends(one, dialect) { ' ' } else { one })
        .take(LONGEST_TEXT)
        .collect::<String>()
        .trim()
        .to_owned()
}

/// What is wrong with a value; none: it can be written.
pub fn problem(block: &Block, field: &Field, typed: &Typed, inputs: &Inputs) -> Option<Message> {
    let value = value(field, typed, inputs, &|key| key.to_owned());
    let about = |key: &'static str| Some(Message::new(key).text("value", &value));
    if value.is_empty() {
        return Some(Message::new("around-wrong-missing"));
    }
    let nct = inputs.cycle.dialect == Dialect::Nct;
    match &field.kind {
        Kind::Result | Kind::Deviation | Kind::Side => {
            let known = choices(field, inputs).iter().any(|(choice, _)| *choice == value);
            let key = if matches!(field.kind, Kind::Side) { "around-wrong-side" } else { "around-wrong-choice" };
            if known { None } else { about(key) }
        }
        Kind::Limit => match parse(&value) {
            Parsed::Number(number) if number >= 0.0 => None,
            _ => about("around-wrong-limit"),
        },
        Kind::Whole(range) | Kind::Variable(range) => whole(&value, range),
        Kind::Program | Kind::Target if nct => whole(&value, &NUMBERS),
        Kind::Program | Kind::Target => {
            let free = is_program(&value) && !is_taken(&value);
            if free { None } else { about("around-wrong-name") }
        }
        Kind::File | Kind::NewFile => {
            if is_name(&value) {
                None
            } else {
                about("around-wrong-name")
            }
        }
        Kind::Text => unprinted(typed.get(field.name)?.trim(), inputs.cycle.dialect),
    }
    .or_else(|| twice(block, field, typed, inputs))
}

/// What of a text would not stand in the program as it was entered.
fn unprinted(entered: &str, dialect: Dialect) -> Option<Message> {
    if let Some(sign) = entered.chars().find(|one| ends(*one, dialect)) {
        let sign = if sign.is_control() { "\u{2424}".to_owned() } else { sign.to_string() };
        return Some(Message::new("around-wrong-sign").text("sign", sign));
    }
    let long = entered.chars().count() > LONGEST_TEXT;
    long.then(|| Message::new("around-wrong-long").number("most", LONGEST_TEXT as f64))
}

/// Two programs of a block are not the same one.
fn twice(block: &Block, field: &Field, typed: &Typed, inputs: &Inputs) -> Option<Message> {
    let of = |field: &Field| value(field, typed, inputs, &|key| key.to_owned());
    let others = block.fields.iter().take_while(|other| other.name != field.name);
    let mut programs = others.filter(|other| matches!(other.kind, Kind::Program));
    let own = matches!(field.kind, Kind::Program).then(|| of(field))?;
    programs.any(|other| of(other) == own).then(|| Message::new("around-wrong-twice").text("value", &own))
}

fn whole(value: &str, range: &Range) -> Option<Message> {
    let inside = matches!(parse(value), Parsed::Number(number) if number.fract() == 0.0 && range.contains(number));
    let message = || Message::new("around-wrong-whole").number("min", range.min).number("max", range.max);
    (!inside).then(message)
}

/// Names of programs and labels begin with two letters or underscores; L with a number is one of programs.
fn is_program(text: &str) -> bool {
    let mut begin = text.bytes().take(2);
    let letters = text.len() > 1 && begin.all(|byte| byte.is_ascii_alphabetic() || byte == b'_');
    let number =
        text.strip_prefix('L').is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|one| one.is_ascii_digit()));
    is_name(text) && (letters || number)
}

fn is_name(text: &str) -> bool {
    let begins = text.starts_with(|one: char| one.is_ascii_alphabetic() || one == '_');
    begins && text.len() <= LONGEST_NAME && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::block;
    use super::*;

    // oracle: manual B:11229 (a log of the same name would be deleted)
    #[test]
    fn a_new_file_has_a_name_of_its_own() {
        let log = block(Dialect::Sinumerik, "log").unwrap();
        let file = |typed: &Typed, text: &str| completed(log, typed, text).get("file").cloned();
        assert_eq!(file(&Typed::new(), "").as_deref(), Some("LOG_1"));
        assert_eq!(file(&Typed::new(), "_PROTNAME[1]=\"LOG_1\"\nR1=\"LOG_3\"").as_deref(), Some("LOG_2"));
        let typed = Typed::from([("file".to_owned(), "LOG_1".to_owned())]);
        assert_eq!(file(&typed, "\"LOG_1\"").as_deref(), Some("LOG_1"), "what is entered counts");
    }
}
