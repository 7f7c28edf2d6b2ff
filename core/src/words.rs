//! The words behind the keys, for the terminal and the tests. The page has its own reader of the same files.

use crate::message::{Arg, Message};
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use serde_json::{Map, Value};

/// A language. English has every message; the others are held against it by a test.
pub struct Language {
    /// As in `LANG`, without a country.
    pub code: &'static str,
    /// Name and text of each file.
    pub files: &'static [(&'static str, &'static str)],
}

/// The languages: the folders of `messages/`, as the build script finds them.
pub const LANGUAGES: &[Language] = include!(concat!(env!("OUT_DIR"), "/languages.rs"));

fn english() -> &'static [(&'static str, &'static str)] {
    LANGUAGES.iter().find(|language| language.code == "en").map_or(&[], |language| language.files)
}

/// Words of one language.
pub struct Words {
    bundle: FluentBundle<FluentResource>,
}

impl Words {
    /// English.
    pub fn english() -> Words {
        Words::new(unic_langid::langid!("en"), english())
    }

    /// A language by its code, as in `zh` or `zh_CN.UTF-8`.
    pub fn of(code: &str) -> Option<Words> {
        let code = code.split(['_', '-', '.', '@']).next()?;
        let language = LANGUAGES.iter().find(|language| language.code == code)?;
        let tag = language.code.parse().ok()?;
        Some(Words::new(tag, language.files))
    }

    /// A language from its files. A line that Fluent does not understand is left out; a test finds it.
    fn new(language: unic_langid::LanguageIdentifier, files: &[(&str, &str)]) -> Words {
        let mut bundle = FluentBundle::new_concurrent(vec![language]);
        bundle.set_use_isolating(false); // a terminal shows the marks as rubbish
        for (_, text) in files {
            let read = FluentResource::try_new((*text).to_owned());
            bundle.add_resource_overriding(read.unwrap_or_else(|(resource, _)| resource));
        }
        Words { bundle }
    }

    /// Its code, as `LANGUAGES` has it.
    pub fn language(&self) -> &str {
        self.bundle.locales.first().map_or("", |tag| tag.language.as_str())
    }

    /// The text of a message; `key.attribute` takes an attribute. A missing one shows its key.
    pub fn text(&self, message: &Message) -> String {
        self.find(message).unwrap_or_else(|| message.key.to_string())
    }

    /// The text of a message, if there is one.
    pub fn find(&self, message: &Message) -> Option<String> {
        let mut args = FluentArgs::new();
        for (name, arg) in &message.args {
            let value = match arg {
                Arg::Number(number) => FluentValue::from(rounded(*number)),
                Arg::Text(text) => self.argument(text),
            };
            args.set(*name, value);
        }
        self.format(&message.key, &args)
    }

    fn format(&self, key: &str, args: &FluentArgs) -> Option<String> {
        let (id, attribute) = key.split_once('.').map_or((key, None), |(id, name)| (id, Some(name)));
        let entry = self.bundle.get_message(id)?;
        let pattern = match attribute {
            Some(name) => entry.get_attribute(name)?.value(),
            None => entry.value()?,
        };
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(args), &mut errors);
        Some(text.into_owned())
    }

    /// A text as an argument; one that is itself a key is put into words first, as in the page.
    fn argument<'a>(&self, text: &'a str) -> FluentValue<'a> {
        self.spoken(text).map_or_else(|| FluentValue::from(text), FluentValue::from)
    }

    /// Adds to everything in a document that has a key what it says: `text`, of an alarm `cause` and `cure` too.
    pub fn speak(&self, document: &mut Value) {
        match document {
            Value::Array(list) => list.iter_mut().for_each(|one| self.speak(one)),
            Value::Object(members) => {
                members.values_mut().for_each(|one| self.speak(one));
                helped_otherwise(members);
                for (name, said) in self.said(members) {
                    members.entry(name).or_insert(said.into());
                }
            }
            _ => {}
        }
    }

    fn said(&self, members: &Map<String, Value>) -> Vec<(&'static str, String)> {
        let Some(key) = members.get("key").and_then(Value::as_str) else { return Vec::new() };
        let mut args = FluentArgs::new();
        let given = members.get("args").and_then(Value::as_object);
        for (name, value) in given.into_iter().flatten() {
            let number = value.as_f64().map(|number| FluentValue::from(rounded(number)));
            let text = || self.argument(value.as_str().unwrap_or_default());
            args.set(name.as_str(), number.unwrap_or_else(text));
        }
        let find = |key: &str| self.format(key, &args);
        // a cycle and a parameter have the stems of their keys
        let text = find(key).or_else(|| find(&format!("{key}-title"))).or_else(|| find(&format!("param-{key}")));
        let parts = [("text", text), ("cause", find(&format!("{key}.cause"))), ("cure", find(&format!("{key}.cure")))];
        parts.into_iter().filter_map(|(name, text)| Some((name, text?))).collect()
    }

    /// The words of a text that is a key.
    fn spoken(&self, text: &str) -> Option<String> {
        let of_key = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let key = text.contains('-') && text.starts_with(|c: char| c.is_ascii_lowercase()) && text.chars().all(of_key);
        key.then(|| self.find(&Message::new(text.to_owned())))?
    }

    /// The text of a key without arguments.
    pub fn key(&self, key: impl Into<std::borrow::Cow<'static, str>>) -> String {
        self.text(&Message::new(key))
    }
}

/// An alarm that is told with another remedy than its own: cause and remedy of a call do not stand beside it.
fn helped_otherwise(members: &mut Map<String, Value>) {
    let key = |name: &str| members.get(name).and_then(|one| one.get("key")).and_then(Value::as_str);
    let [Some(alarm), Some(hint)] = ["message", "hint"].map(key) else { return };
    if hint == format!("{alarm}.cure") {
        return;
    }
    if let Some(message) = members.get_mut("message").and_then(Value::as_object_mut) {
        message.remove("cause");
        message.remove("cure");
    }
}

/// As a person reads it: to a millionth, so that the last bits of a sum do not show. Very large numbers and small ones
/// from a billionth on stay as they are.
pub fn rounded(number: f64) -> f64 {
    let shown = (number * 1e6).round() / 1e6;
    match number.abs() {
        size if size < 1e-9 => 0.0,
        size if size < 1e9 && shown != 0.0 => shown,
        _ => number,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;

    fn folder() -> Vec<String> {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("messages/en");
        let mut names: Vec<String> = std::fs::read_dir(path)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".ftl"))
            .collect();
        names.sort();
        names
    }

    // oracle: self
    #[test]
    fn every_message_file_is_read_and_understood() {
        let listed: Vec<&str> = english().iter().map(|(name, _)| *name).collect();
        assert_eq!(listed, folder());
        for (name, text) in LANGUAGES.iter().flat_map(|language| language.files) {
            if let Err((_, errors)) = FluentResource::try_new((*text).to_owned()) {
                panic!("{name}: {errors:?}");
            }
        }
    }

    // oracle: self
    #[test]
    fn a_key_stands_in_one_file_only() {
        let mut seen = std::collections::BTreeMap::new();
        for (name, text) in english() {
            for line in text.lines() {
                let Some((key, _)) = line.split_once(" =") else { continue };
                if line.starts_with(|c: char| c.is_ascii_lowercase()) {
                    assert_eq!(seen.insert(key.to_owned(), *name), None, "{key} in {name}");
                }
            }
        }
    }

    // oracle: hand
    #[test]
    fn numbers_show_no_last_bits() {
        assert_eq!(rounded(0.030_000_000_000_029_56), 0.03);
        assert_eq!(rounded(-2.0 / 3.0), -0.666_667);
        assert_eq!(rounded(-3e-14), 0.0);
        assert_eq!(rounded(1e-7), 1e-7);
        assert_eq!(rounded(1e308), 1e308);
        assert_eq!(rounded(0.0), 0.0);
    }

    // oracle: hand
    #[test]
    fn a_language_is_found_by_its_code() {
        for code in ["zh", "zh_CN.UTF-8", "zh-CN"] {
            assert!(Words::of(code).is_some(), "{code}");
        }
        for code in ["", "C", "xx_YY.UTF-8"] {
            assert!(Words::of(code).is_none(), "{code}");
        }
    }

    // oracle: hand
    #[test]
    fn words_take_arguments_and_attributes() {
        let words = Words::english();
        assert!(words.key("alarm-61334.cure").contains("_SZA"));
        assert_eq!(words.key("no-such-key"), "no-such-key");
    }
}
