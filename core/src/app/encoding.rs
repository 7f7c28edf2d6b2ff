//! What a file is, by its bytes.

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
    },
    /// No program.
    Other {
        /// What it is instead.
        why: Message,
    },
}

impl From<Result<Encoding, &'static str>> for Recognised {
    fn from(found: Result<Encoding, &'static str>) -> Recognised {
        match found {
            Ok(encoding) => Recognised::Program { encoding },
            Err(what) => Recognised::Other { why: Message::new(what) },
        }
    }
}
