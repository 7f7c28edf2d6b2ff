//! A large program that need not be held whole: its file is read once, in pieces of whole lines, by a thread of its own
//! while the pieces before are carried out. Where a later piece shows that lines need one another, what was done counts
//! for nothing, and the program is held whole.

use crate::file::{Problem, unreadable};
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
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// A file up to this size is held whole, bytes.
const HELD: u64 = 32 << 20;
/// A piece, bytes, up to the end of a line.
const PIECE: u64 = 1 << 20;
/// Most bytes of a piece that has no end of a line.
const LONGEST: usize = 64 << 20;
/// Pieces that are read before they are needed.
const AHEAD: usize = 2;

/// A program that is run in pieces.
pub struct Stream {
    /// Its file.
    pub path: PathBuf,
    size: f64,
    /// Language of the program.
    pub dialect: Dialect,
    come: Rc<RefCell<Come>>,
}

/// What came of a file so far.
#[derive(Default)]
struct Come {
    from: Option<Receiver<Result<Piece, Why>>>,
    /// Why no more comes before its end.
    why: Option<Why>,
}

/// Why a file does not come in pieces.
enum Why {
    /// Its lines need one another, or it is in another encoding.
    Whole,
    /// It cannot be read.
    Failed(Error),
}

impl Come {
    fn next(&mut self) -> Option<Piece> {
        match self.from.as_ref()?.recv().ok()? {
            Ok(piece) => Some(piece),
            Err(why) => {
                (self.why, self.from) = (Some(why), None);
                None
            }
        }
    }
}

impl Stream {
    /// A program in this language, else in that in which it is written; none: it is held whole, as it is small, or as
    /// its first lines need others.
    pub fn of(path: &Path, language: impl FnOnce(&[u8]) -> Dialect) -> Option<Stream> {
        let size = std::fs::metadata(path).ok().filter(|file| file.is_file() && file.len() > HELD)?.len();
        let size = u32::try_from(size).ok()?; // places are
        let first = Texts::of(path).ok()?.next()?.ok()?;
        let dialect = language(&first);
        let begins = read(dialect, &first).begins_pieces();
        begins.then(|| Stream { path: path.to_owned(), size: f64::from(size), dialect, come: Rc::default() })
    }

    /// The beginning of the program, and what gives a run of it the rest.
    pub fn begin(&self) -> Result<(Rc<Program>, impl FnOnce(Session) -> Session + 'static), Problem> {
        let named = |error: Error| unreadable(&self.path, &error);
        let mut texts = Texts::of(&self.path).map_err(named)?;
        let first = texts.next().transpose().map_err(named)?.unwrap_or_default();
        let mut recogniser = Recogniser::default();
        recogniser.take(&first);
        let (dialect, size, done) = (self.dialect, self.size, first.len() as f64);
        let (to, from) = sync_channel(AHEAD);
        std::thread::spawn(move || read_on(Rest { dialect, size, done, texts, recogniser }, &to));
        *self.come.borrow_mut() = Come { from: Some(from), why: None };
        let come = Rc::clone(&self.come);
        let more = move || come.borrow_mut().next();
        let share = [0.0, done / size];
        Ok((Rc::new(read(dialect, &first)), move |session: Session| session.in_pieces(share, Box::new(more))))
    }

    /// Whether what was run is the program: what comes behind the end of the run is looked at too.
    pub fn was_run(&self) -> Result<bool, Problem> {
        let mut come = self.come.borrow_mut();
        while come.next().is_some() {}
        match come.why.take() {
            None => Ok(true),
            Some(Why::Whole) => Ok(false),
            Some(Why::Failed(error)) => Err(unreadable(&self.path, &error)),
        }
    }

    /// Lines and columns of places, both from 1; the file is read once more.
    pub fn positions(&self, places: impl Iterator<Item = u32>) -> Result<BTreeMap<u32, (u32, u32)>, Problem> {
        let mut waiting: Vec<u32> = places.collect();
        waiting.sort_unstable_by(|one, other| other.cmp(one));
        let mut found = BTreeMap::new();
        let (mut start, mut lines) = (0, 0);
        for text in Texts::of(&self.path).map_err(|error| unreadable(&self.path, &error))? {
            let text = text.map_err(|error| unreadable(&self.path, &error))?;
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
    syntax::read_lean(dialect, text, &Arc::default())
}

/// A file behind its first piece.
struct Rest {
    dialect: Dialect,
    size: f64,
    /// Bytes of the first piece.
    done: f64,
    texts: Texts,
    /// It took the first piece.
    recogniser: Recogniser,
}

/// Reads the pieces behind the first one, until there is none or nobody takes them any more.
fn read_on(rest: Rest, to: &SyncSender<Result<Piece, Why>>) {
    let Rest { dialect, size, mut done, texts, mut recogniser } = rest;
    for text in texts {
        let piece = text.map_err(Why::Failed).and_then(|text| {
            recogniser.take(&text);
            let from = done;
            done += text.len() as f64;
            let program = read(dialect, &text);
            let goes_on = program.goes_on_in_pieces();
            goes_on.then_some(Piece { program, share: [from / size, done / size] }).ok_or(Why::Whole)
        });
        let ends = piece.is_err();
        if to.send(piece).is_err() || ends {
            return;
        }
    }
    if !matches!(recogniser.finish(), Ok(Encoding::Utf8 | Encoding::Utf8Marked)) {
        drop(to.send(Err(Why::Whole)));
    }
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
