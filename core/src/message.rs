//! A text by its key. The words live in `core/messages/<language>/*.ftl` (Fluent); the core never holds a sentence.

use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::ops::Deref;

/// One argument of a message.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Arg {
    /// A number; the reader of the message formats it.
    Number(f64),
    /// A name or text that is shown as it is (parameter, cycle, word of a program).
    Text(String),
}

/// A text to be shown: key of the message files, with its arguments.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Message {
    /// Key in the message files, for example `check-out-of-range`; stems of the catalogue make others (`alarm-61307`).
    pub key: Cow<'static, str>,
    /// Named arguments, in no particular order.
    #[serde(serialize_with = "by_name")]
    #[cfg_attr(test, ts(as = "std::collections::BTreeMap<String, Arg>"))]
    pub args: Vec<(&'static str, Arg)>,
}

fn by_name<S: Serializer>(args: &[(&'static str, Arg)], to: S) -> Result<S::Ok, S::Error> {
    to.collect_map(args.iter().map(|(name, arg)| (name, arg)))
}

/// As it is in a document, with the sentence that [`crate::words::Words::speak`] adds.
#[cfg(feature = "cli")]
impl schemars::JsonSchema for Message {
    fn schema_name() -> Cow<'static, str> {
        "Message".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "object",
            "properties": {
                "key": { "type": "string" },
                "args": { "type": "object", "additionalProperties": { "type": ["number", "string"] } },
                "text": { "type": "string" }
            },
            "required": ["key", "args"]
        })
    }
}

impl Message {
    /// A message without arguments.
    pub fn new(key: impl Into<Cow<'static, str>>) -> Self {
        Self { key: key.into(), args: Vec::new() }
    }

    /// With a number; a 0 has no sign.
    pub fn number(mut self, name: &'static str, value: f64) -> Self {
        self.args.push((name, Arg::Number(value + 0.0)));
        self
    }

    /// With a text, shortened where a user or a file made it long; control characters, which a terminal obeys, as
    /// blanks.
    pub fn text(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.args.push((name, Arg::Text(printable(&value.into()))));
        self
    }

    /// With several texts, each shortened as [`Message::text`], and none left out.
    pub fn texts(mut self, name: &'static str, all: &[impl Deref<Target = str>]) -> Self {
        let all: Vec<String> = all.iter().map(|one| printable(one)).collect();
        self.args.push((name, Arg::Text(all.join(", "))));
        self
    }

    /// With a place of the manual, whole: no user and no file makes it long.
    pub fn source(mut self, source: impl std::fmt::Display) -> Self {
        self.args.push(("source", Arg::Text(source.to_string())));
        self
    }

    /// A text among the arguments.
    pub fn word(&self, name: &str) -> Option<&str> {
        self.args.iter().find_map(|(known, arg)| match arg {
            Arg::Text(text) if *known == name => Some(text.as_str()),
            _ => None,
        })
    }
}

/// Most characters of a text in a message.
const SHOWN: usize = 100;

/// A text on one line, at most `SHOWN` characters and three points.
pub fn printable(text: &str) -> String {
    let mut shown: String = text.chars().take(SHOWN).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn a_text_of_a_file_is_one_short_line() {
        assert_eq!(printable("_SETVAL"), "_SETVAL");
        assert_eq!(printable("a\u{1b}[2J\r\nb"), "a [2J  b");
        let long = printable(&"ü".repeat(1_000_000));
        assert_eq!(long.chars().count(), SHOWN + 1);
        assert!(long.ends_with("ü…"));
        assert_eq!(printable(&"x".repeat(SHOWN)).len(), SHOWN);
    }
}
