//! A text by its key. The words live in `core/messages/<language>/*.ftl` (Fluent); the core never holds a sentence.

use std::borrow::Cow;

/// One argument of a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// A number; the reader of the message formats it.
    Number(f64),
    /// A name or text that is shown as it is (parameter, cycle, word of a program).
    Text(String),
}

/// A text to be shown: key of the message files, with its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Key in the message files, for example `check-out-of-range`; stems of the catalogue make others (`alarm-61307`).
    pub key: Cow<'static, str>,
    /// Named arguments, in no particular order.
    pub args: Vec<(&'static str, Arg)>,
}

impl Message {
    /// A message without arguments.
    pub fn new(key: impl Into<Cow<'static, str>>) -> Self {
        Self {
            key: key.into(),
            args: Vec::new(),
        }
    }

    /// The same with a number.
    pub fn number(mut self, name: &'static str, value: f64) -> Self {
        self.args.push((name, Arg::Number(value)));
        self
    }

    /// The same with a text.
    pub fn text(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.args.push((name, Arg::Text(value.into())));
        self
    }
}
