//! Files beside a program, as the control has them in one program memory: subprograms, definition files.

use super::program_text::ProgramText;
use crate::dialect::Dialect;
use crate::syntax::joined::Joined;
use crate::syntax::position::Positions;
use crate::syntax::programs::is_definition;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A file beside a program.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Beside {
    /// Name of the file, by which calls find it.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Where a file beside the program begins: places and lines of an answer go on there.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct FileStart {
    /// Name of the file.
    pub name: String,
    /// Its first character, UTF-16 units.
    pub from: u32,
    /// Its first line, from 1.
    pub line: u32,
}

/// A program with what lies beside it.
pub(super) struct Whole {
    joined: Joined,
    names: Vec<String>,
}

impl Whole {
    /// With all files.
    pub fn new(dialect: Dialect, text: ProgramText, with: Option<Vec<Beside>>) -> Whole {
        let mut whole = Whole { joined: Joined::held(dialect, text.0), names: Vec::new() };
        for Beside { name, text } in with.unwrap_or_default() {
            whole.joined.add(&name, text.as_bytes());
            whole.names.push(name);
        }
        whole
    }

    /// With the definition files alone: what is written anew stands in the program itself.
    pub fn defined(dialect: Dialect, text: ProgramText, with: Option<Vec<Beside>>) -> Whole {
        let with = with.map(|with| with.into_iter().filter(|one| is_definition(&one.name)).collect());
        Whole::new(dialect, text, with)
    }

    /// Language of the program.
    pub fn dialect(&self) -> Dialect {
        self.joined.dialect
    }

    /// All of it.
    pub fn text(&self) -> &Arc<Vec<u8>> {
        &self.joined.text
    }

    /// Where each file begins, by the places of this text.
    pub fn files(&self, positions: &Positions) -> Vec<FileStart> {
        let starts = self.joined.starts.iter().skip(1).zip(&self.names);
        let start = |(start, name): (&usize, &String)| FileStart {
            name: name.clone(),
            from: positions.utf16(*start as u32),
            line: positions.line_column(*start as u32).0,
        };
        starts.map(start).collect()
    }

    /// The file beside the program that holds a line of the text, from 1, and the line in it; none: the program itself.
    pub fn line(files: &[FileStart], line: u32) -> (Option<String>, u32) {
        let start = files.iter().rfind(|start| start.line <= line);
        start.map_or((None, line), |start| (Some(start.name.clone()), line - start.line + 1))
    }

    /// Whether this byte belongs to the program itself.
    pub fn of_program(&self, place: u32) -> bool {
        self.joined.starts.get(1).is_none_or(|start| (place as usize) < *start)
    }
}
