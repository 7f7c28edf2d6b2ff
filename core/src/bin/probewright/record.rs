//! The record of a run, written as a table or as a document.

use crate::file::{self, Problem};
use probewright_core::app::{Record, csv};
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::words::Words;
use std::path::{Path, PathBuf};

/// A file whose ending says how the record is written.
pub struct File {
    path: PathBuf,
    table: bool,
}

impl File {
    /// Refuses another ending, before anything is run.
    pub fn of(path: &Path) -> Result<File, Problem> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let table = match ending.as_deref() {
            Some("csv") => true,
            Some("json") => false,
            _ => return Err(file::wrong_file(path, Message::new("terminal-record-ending"))),
        };
        Ok(File { path: path.to_owned(), table })
    }

    /// Writes a record.
    pub fn write(&self, record: &Record, words: &Words) -> Result<(), Problem> {
        let text = if self.table {
            csv(record, &|message| words.text(message))
        } else {
            let mut document = json::document(record);
            words.speak(&mut document);
            format!("{}\n", serde_json::to_string_pretty(&document)?)
        };
        file::write(&self.path, std::iter::once(text))
    }
}
