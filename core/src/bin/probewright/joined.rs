//! A program and the files named with it: one text, as the control has one program memory. What is found in it is told
//! in the file where it stands.

use crate::file::{self, Problem};
use probewright_core::diagnostic::{Diagnostic, Edit, Span};
use probewright_core::dialect::Dialect;
use probewright_core::syntax;
use std::path::{Path, PathBuf};

/// A file in the text.
struct Part {
    path: PathBuf,
    /// Where it begins in the text, bytes.
    start: usize,
    /// Its first line in the text, from 0.
    line: u32,
    source: Vec<u8>,
}

/// A program with the files named with it.
pub struct Joined {
    /// All of it.
    pub text: Vec<u8>,
    /// Language of the program.
    pub dialect: Dialect,
    parts: Vec<Part>,
}

impl Joined {
    /// Reads a program and the files with it. A file without a header gets one with its name.
    pub fn read(path: &Path, with: &[PathBuf], control: Option<file::Control>) -> Result<Joined, Problem> {
        let source = file::program(path)?;
        let dialect = file::dialect(control, &source);
        let mut joined = Joined { text: Vec::new(), dialect, parts: Vec::new() };
        joined.add(path, source, false);
        for path in with {
            joined.add(path, file::program(path)?, true);
        }
        Ok(joined)
    }

    /// In this language.
    pub fn of(self, dialect: Dialect) -> Joined {
        Joined { dialect, ..self }
    }

    fn add(&mut self, path: &Path, source: Vec<u8>, named: bool) {
        if named {
            // nothing counts behind an end of file, and what follows is in a line of its own
            let last = self.parts.last().map_or(0, |part| part.start);
            let end = syntax::read(self.dialect, self.text.get(last..).unwrap_or_default()).end as usize;
            self.text.truncate(last + end);
            self.text.push(b'\n');
            if self.dialect == Dialect::Sinumerik && !source.trim_ascii_start().starts_with(b"%") {
                self.text.extend(header(path).into_bytes());
            }
        }
        let (from, before) = self.parts.last().map_or((0, 0), |part| (part.start, part.line));
        let line = before + self.text.iter().skip(from).filter(|byte| **byte == b'\n').count() as u32;
        self.parts.push(Part { path: path.to_owned(), start: self.text.len(), line, source: source.clone() });
        self.text.extend(source);
    }

    /// The file that holds a line of the text (from 0), and the line in it.
    pub fn line(&self, line: u32) -> (&Path, u32) {
        let part = self.parts.iter().rfind(|part| part.line <= line);
        part.map_or((Path::new(""), line), |part| (&*part.path, line - part.line))
    }

    /// The files that something was found in, the program in any case, each with what was found there.
    pub fn files(&self, found: &[Diagnostic]) -> Vec<(&Path, &[u8], Vec<Diagnostic>)> {
        let mut all: Vec<_> = self.parts.iter().map(|part| (&*part.path, &*part.source, Vec::new())).collect();
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

/// `SUB.SPF` is `%_N_SUB_SPF`, `GUD4.DEF` is `%_N_GUD4_DEF`.
fn header(path: &Path) -> String {
    let name = path.file_stem().map_or_else(String::new, |name| name.to_string_lossy().to_ascii_uppercase());
    let name: String = name.chars().map(|one| if one.is_ascii_alphanumeric() { one } else { '_' }).collect();
    let name = name.strip_prefix("_N_").unwrap_or(&name);
    let ending = path.extension().map_or_else(String::new, |ending| ending.to_string_lossy().to_ascii_uppercase());
    let bare = ["_SPF", "_MPF", "_DEF"].iter().any(|ending| name.ends_with(ending));
    match (bare, ending.as_str()) {
        (true, _) => format!("%_N_{name}\n"),
        (false, "DEF") => format!("%_N_{name}_DEF\n"),
        (false, "MPF") => format!("%_N_{name}_MPF\n"),
        (false, _) => format!("%_N_{name}_SPF\n"),
    }
}
