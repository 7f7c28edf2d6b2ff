//! What a file is, by its bytes.

use super::log_of;
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
        /// That it is the log of measurements, which is opened beside its program; absent: it is none.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        log: Option<Message>,
    },
    /// No program.
    Other {
        /// What it is instead.
        why: Message,
    },
}

/// What the first bytes of a file tell.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileHead {
    control: Option<Dialect>,
    log: Option<&'static str>,
}

impl FileHead {
    /// Of these bytes.
    pub fn of(bytes: &[u8]) -> FileHead {
        FileHead { control: Dialect::told(bytes), log: log_of(bytes) }
    }
}

impl Recognised {
    /// What was found by all bytes of a file, and what its first ones tell.
    pub fn of(found: Result<Encoding, &'static str>, begins: FileHead) -> Recognised {
        let log = begins.log.map(|control| Message::new("file-log").text("control", control));
        match found {
            Ok(encoding) => Recognised::Program { encoding, control: begins.control, log },
            Err(what) => Recognised::Other { why: Message::new(what) },
        }
    }
}
