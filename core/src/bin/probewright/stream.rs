//! A large program that need not be held whole: its file is read in pieces of whole lines, once to see whether it can
//! be run so, and once to be run.

use crate::file::Problem;
use probewright_core::dialect::Dialect;
use probewright_core::encoding::{Encoding, Recogniser};
use probewright_core::run::Session;
use probewright_core::run::pieces::Piece;
use probewright_core::syntax::position::Positions;
use probewright_core::syntax::{self, Program};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// A file up to this size is held whole, bytes.
const HELD: u64 = 32 << 20;
/// A piece, bytes, up to the end of a line.
const PIECE: u64 = 1 << 20;
/// Most bytes of a piece that has no end of a line.
const LONGEST: usize = 64 << 20;

/// A program that is run in pieces.
pub struct Stream {
    /// Its file.
    pub path: PathBuf,
    size: f64,
    /// Language of the program.
    pub dialect: Dialect,
    failed: Rc<RefCell<Option<Error>>>,
}

impl Stream {
    /// A program in this language, else in that in which it is written; none: it is held whole, as it is small, or as
    /// its lines need one another.
    pub fn of(path: &Path, language: impl FnOnce(&[u8]) -> Dialect) -> Option<Stream> {
        let size = std::fs::metadata(path).ok().filter(|file| file.is_file() && file.len() > HELD)?.len();
        let size = u32::try_from(size).ok()?; // places are
        let mut texts = Texts::of(path).ok()?;
        let first = texts.next()?.ok()?;
        let dialect = language(&first);
        let mut recogniser = Recogniser::default();
        recogniser.take(&first);
        if !read(dialect, &first).begins_pieces() {
            return None;
        }
        for text in texts {
            let text = text.ok()?;
            recogniser.take(&text);
            if !read(dialect, &text).goes_on_in_pieces() {
                return None;
            }
        }
        let known = matches!(recogniser.finish(), Ok(Encoding::Utf8 | Encoding::Utf8Marked));
        known.then(|| Stream { path: path.to_owned(), size: f64::from(size), dialect, failed: Rc::default() })
    }

    /// The beginning of the program, and what gives a run of it the rest.
    pub fn begin(&self) -> Result<(Rc<Program>, impl FnOnce(Session) -> Session + 'static), Problem> {
        let named = |error: Error| format!("{}: {error}", self.path.display());
        let mut texts = Texts::of(&self.path).map_err(named)?;
        let first = texts.next().transpose().map_err(named)?.unwrap_or_default();
        let (dialect, size, failed) = (self.dialect, self.size, Rc::clone(&self.failed));
        let mut done = first.len() as f64;
        let share = [0.0, done / size];
        let more = move || {
            let text = texts.next()?.map_err(|error| *failed.borrow_mut() = Some(error)).ok()?;
            let from = done;
            done += text.len() as f64;
            Some(Piece { program: read(dialect, &text), share: [from / size, done / size] })
        };
        Ok((Rc::new(read(dialect, &first)), move |session: Session| session.in_pieces(share, Box::new(more))))
    }

    /// Whether all of the file could be read.
    pub fn end(&self) -> Result<(), Problem> {
        match self.failed.borrow_mut().take() {
            Some(error) => Err(format!("{}: {error}", self.path.display()).into()),
            None => Ok(()),
        }
    }

    /// Lines and columns of places, both from 1; the file is read once more.
    pub fn positions(&self, places: impl Iterator<Item = u32>) -> Result<BTreeMap<u32, (u32, u32)>, Problem> {
        let mut waiting: Vec<u32> = places.collect();
        waiting.sort_unstable_by(|one, other| other.cmp(one));
        let mut found = BTreeMap::new();
        let (mut start, mut lines) = (0, 0);
        for text in Texts::of(&self.path).map_err(|error| format!("{}: {error}", self.path.display()))? {
            let text = text.map_err(|error| format!("{}: {error}", self.path.display()))?;
            let end = start + text.len() as u32;
            let mut positions = None;
            while let Some(place) = waiting.pop_if(|place| *place < end || f64::from(end) >= self.size) {
                let positions = positions.get_or_insert_with(|| Positions::new(&text));
                let (line, column) = positions.line_column(place - start);
                found.insert(place, (lines + line, column));
            }
            if waiting.is_empty() {
                break;
            }
            lines += text.iter().filter(|byte| **byte == b'\n').count() as u32;
            start = end;
        }
        Ok(found)
    }
}

fn read(dialect: Dialect, text: &[u8]) -> Program {
    syntax::read_to_run(dialect, text, &Arc::default())
}

/// The lines of a file, some at a time.
struct Texts {
    file: File,
    /// The beginning of a line whose end has not come yet.
    rest: Vec<u8>,
}

impl Texts {
    fn of(path: &Path) -> Result<Texts, Error> {
        Ok(Texts { file: File::open(path)?, rest: Vec::new() })
    }

    fn piece(&mut self) -> Result<Vec<u8>, Error> {
        let mut text = std::mem::take(&mut self.rest);
        loop {
            let before = text.len();
            if self.file.by_ref().take(PIECE).read_to_end(&mut text)? == 0 {
                return Ok(text);
            }
            let end = text.get(before..).and_then(|new| new.iter().rposition(|byte| *byte == b'\n'));
            if let Some(end) = end {
                self.rest = text.split_off(before + end + 1);
                return Ok(text);
            }
            if text.len() > LONGEST {
                return Err(ErrorKind::FileTooLarge.into());
            }
        }
    }
}

impl Iterator for Texts {
    type Item = Result<Vec<u8>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        Some(self.piece()).filter(|piece| !piece.as_ref().is_ok_and(Vec::is_empty))
    }
}
