//! A program and the files named with it: one text, as the control has one program memory. What is found in it is told
//! in the file where it stands.

use crate::file::{self, Problem};
use probewright_core::app::RecordFile;
use probewright_core::diagnostic::{Diagnostic, Edit, Span};
use probewright_core::dialect::Dialect;
use probewright_core::syntax::joined;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file in the text.
struct Part {
    path: PathBuf,
    /// Where it begins in the text, bytes.
    start: usize,
    /// Its first line in the text, from 0.
    line: u32,
    /// What is in it; none: the text, which is this file alone.
    source: Option<Vec<u8>>,
}

/// The files that are named; of a folder every program and definition file below it, but the program itself.
fn every(program: &Path, with: &[PathBuf]) -> Result<Vec<PathBuf>, Problem> {
    let same = |path: &Path| path.canonicalize().ok().zip(program.canonicalize().ok()).is_some_and(|(a, b)| a == b);
    let mut found = Vec::new();
    for path in with {
        if !path.is_dir() {
            found.push(path.clone());
            continue;
        }
        let mut files = file::below(path)?;
        files.retain(|path| is_program(path) && !same(path));
        found.extend(files);
    }
    Ok(found)
}

/// Name of a file without its folder.
fn name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Whether a file of a folder is one of the programs or definitions of a machine, by its ending.
fn is_program(path: &Path) -> bool {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().to_ascii_lowercase());
    let ending = name.rsplit(['.', '_']).next().filter(|ending| ending.len() < name.len());
    ending.is_some_and(|ending| ["mpf", "spf", "def", "arc", "nc"].contains(&ending))
}

/// A program with the files named with it.
pub struct Joined {
    /// All of it.
    pub text: Arc<Vec<u8>>,
    /// Language of the program.
    pub dialect: Dialect,
    parts: Vec<Part>,
}

impl Joined {
    /// Reads a program and the files with it.
    pub fn read(path: &Path, with: &[PathBuf], control: Option<file::Control>) -> Result<Joined, Problem> {
        let source = file::program(path)?;
        file::no_log(path, &source)?;
        Joined::around(path, source, with, control, &file::program)
    }

    /// A program whose text is known, with the files around it as `read` gives them.
    pub fn around(
        path: &Path,
        source: Vec<u8>,
        with: &[PathBuf],
        control: Option<file::Control>,
        read: &dyn Fn(&Path) -> Result<Vec<u8>, Problem>,
    ) -> Result<Joined, Problem> {
        let dialect = file::dialect(control, &source);
        let mut sources = vec![(path.to_owned(), (!with.is_empty()).then(|| source.clone()))];
        let mut joined = joined::Joined::new(dialect, source);
        for path in &every(path, with)? {
            let source = read(path)?;
            joined.add(&name(path), &source);
            sources.push((path.clone(), Some(source)));
        }
        let (mut line, mut from) = (0, 0);
        let parts: Vec<Part> = sources
            .into_iter()
            .zip(joined.starts.clone())
            .map(|((path, source), start)| {
                let before = joined.text.get(from..start).unwrap_or_default();
                line += before.iter().filter(|byte| **byte == b'\n').count() as u32;
                from = start;
                Part { path, start, line, source }
            })
            .collect();
        Ok(Joined { parts, text: joined.text, dialect })
    }

    /// A program alone whose text is not held.
    pub fn unheld(path: &Path, dialect: Dialect) -> Joined {
        let program = Part { path: path.to_owned(), start: 0, line: 0, source: None };
        Joined { text: Arc::default(), dialect, parts: vec![program] }
    }

    /// In this language.
    pub fn of(self, dialect: Dialect) -> Joined {
        Joined { dialect, ..self }
    }

    /// The file that holds a line of the text (from 0), and the line in it.
    pub fn line(&self, line: u32) -> (&Path, u32) {
        let part = self.parts.iter().rfind(|part| part.line <= line);
        part.map_or((Path::new(""), line), |part| (&*part.path, line - part.line))
    }

    /// The name of the file behind the program that holds a line of the text (from 1), and the line in it; none: the
    /// program itself.
    pub fn within(&self, line: u32) -> (Option<String>, u32) {
        let part = self.parts.iter().skip(1).rfind(|part| part.line < line);
        part.map_or((None, line), |part| (Some(part.path.display().to_string()), line - part.line))
    }

    /// The file that holds a place of the text, what is in it, and the place there; the program comes first.
    pub fn place(&self, place: Span) -> Option<(&Path, &[u8], Span)> {
        let behind = self.parts.partition_point(|part| part.start <= place.start as usize);
        let part = self.parts.get(behind.saturating_sub(1))?;
        let start = part.start as u32;
        let place = Span { start: place.start.checked_sub(start)?, end: place.end.checked_sub(start)? };
        Some((&part.path, part.source.as_deref().unwrap_or(&self.text), place))
    }

    /// Whether a place of the text belongs to the program itself.
    pub fn of_program(&self, place: Span) -> bool {
        self.parts.get(1).is_none_or(|part| (place.start as usize) < part.start)
    }

    /// Name of the file with the program.
    pub fn name(&self) -> String {
        self.parts.first().map_or_else(String::new, |part| name(&part.path))
    }

    /// Name and text of each file beside the program.
    pub fn sources(&self) -> impl Iterator<Item = (String, &[u8])> {
        self.parts.iter().skip(1).map(|part| (name(&part.path), part.source.as_deref().unwrap_or_default()))
    }

    /// The files beside the program.
    pub fn beside(&self) -> Vec<RecordFile> {
        let beside = self.parts.iter().skip(1);
        beside.map(|part| RecordFile { name: name(&part.path), line: part.line + 1 }).collect()
    }

    /// The files that something was found in, the program in any case, each with what was found there.
    pub fn files<'a>(&'a self, found: &[Diagnostic]) -> Vec<(&'a Path, &'a [u8], Vec<Diagnostic>)> {
        let source = |part: &'a Part| part.source.as_deref().unwrap_or(&self.text);
        let mut all: Vec<_> = self.parts.iter().map(|part| (&*part.path, source(part), Vec::new())).collect();
        for one in found {
            let start = one.span.unwrap_or_default().start as usize;
            let behind = self.parts.partition_point(|part| part.start <= start);
            let at = behind.saturating_sub(1); // parts stand in the order of the text
            if let (Some(part), Some((.., own))) = (self.parts.get(at), all.get_mut(at)) {
                own.push(moved(one.clone(), part.start as u32));
            }
        }
        let mut first = true;
        all.retain(|(.., found)| std::mem::take(&mut first) || !found.is_empty());
        all
    }
}

/// A finding in the text as one of the file that begins here. A cure that reaches into another file is none.
fn moved(mut found: Diagnostic, start: u32) -> Diagnostic {
    let back = |span: Span| Some(Span { start: span.start.checked_sub(start)?, end: span.end.checked_sub(start)? });
    found.span = found.span.and_then(back);
    found.cure = found.cure.and_then(|mut cure| {
        let edits = cure.edits.into_iter().map(|edit| Some(Edit { span: back(edit.span)?, ..edit }));
        cure.edits = edits.collect::<Option<_>>()?;
        Some(cure)
    });
    found
}
