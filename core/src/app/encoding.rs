//! What a file is, by its bytes.

use crate::dialect::Dialect;
use crate::encoding::Encoding;
use crate::message::Message;
use serde::Serialize;

/// What a file is, by its bytes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Recognised {
    /// A program.
    Program {
        /// How it is encoded.
        encoding: Encoding,
        /// The control that its beginning tells; absent: it tells none.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        control: Option<Dialect>,
    },
    /// No program.
    Other {
        /// What it is instead.
        why: Message,
    },
}

impl Recognised {
    /// What was found by all bytes of a file, and what its first ones tell.
    pub fn of(found: Result<Encoding, &'static str>, control: Option<Dialect>) -> Recognised {
        match found {
            Ok(encoding) => Recognised::Program { encoding, control },
            Err(what) => Recognised::Other { why: Message::new(what) },
        }
    }
}
