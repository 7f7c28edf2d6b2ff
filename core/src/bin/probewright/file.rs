//! Reading files, each in whatever encoding it is written, why one cannot be read or written, and which control a
//! program is for.

use crate::check::severity;
use clap::ValueEnum;
use probewright_core::app::{MachineProblem, machine_doubts};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::encoding::{Encoding, recognise};
use probewright_core::machine::setup::Setup;
use probewright_core::message::{Message, printable};
use probewright_core::words::Words;
use probewright_core::{app, foreign, json};
use serde_json::Value;
use std::io::{BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// Control as named on the command line.
#[derive(Clone, Copy, ValueEnum)]
pub enum Control {
    Sinumerik,
    Nct,
}

/// Why a command did not work, as a line.
pub type Problem = Box<dyn std::error::Error>;

/// A problem that words tell, behind the file that it is about.
#[derive(Debug)]
struct Told {
    path: Option<PathBuf>,
    message: Message,
}

impl std::error::Error for Told {}

impl std::fmt::Display for Told {
    fn fmt(&self, to: &mut std::fmt::Formatter) -> std::fmt::Result {
        to.write_str(&self.message.key)
    }
}

/// A wrong use.
pub fn wrong(message: Message) -> Problem {
    Box::new(Told { path: None, message })
}

/// What is wrong with a file.
pub fn wrong_file(path: &Path, message: Message) -> Problem {
    Box::new(Told { path: Some(path.to_owned()), message })
}

/// What is wrong with several files together: the first of them is named.
pub fn wrong_files(paths: &[PathBuf], message: Message) -> Problem {
    paths.first().map_or_else(|| wrong(message.clone()), |path| wrong_file(path, message.clone()))
}

/// A file or folder that cannot be read: why, and what helps.
pub fn unreadable(path: &Path, error: &std::io::Error) -> Problem {
    wrong_file(path, told_by_system(error, false))
}

/// A file or folder that cannot be written: why, and what helps.
pub fn unwritable(path: &Path, error: &std::io::Error) -> Problem {
    wrong_file(path, told_by_system(error, true))
}

/// What the system says, which knows its own language only.
fn told_by_system(error: &std::io::Error, writes: bool) -> Message {
    let key = match (error.kind(), writes) {
        (ErrorKind::NotFound | ErrorKind::NotADirectory, false) => "terminal-file-missing",
        (ErrorKind::NotFound | ErrorKind::NotADirectory, true) => "terminal-file-no-folder",
        (ErrorKind::PermissionDenied, false) => "terminal-file-denied",
        (ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem, true) => "terminal-file-protected",
        (ErrorKind::IsADirectory, _) => "terminal-file-folder",
        (ErrorKind::AlreadyExists, true) => "terminal-file-exists",
        (ErrorKind::StorageFull | ErrorKind::QuotaExceeded, true) => "terminal-file-full",
        (ErrorKind::FileTooLarge, false) => "terminal-file-line",
        (_, false) => "terminal-file-unread",
        (_, true) => "terminal-file-unwritten",
    };
    let number = error.raw_os_error().map_or_else(|| error.kind().to_string(), |number| number.to_string());
    Message::new(key).text("number", number)
}

/// Tells a problem on standard error; where that is closed, nobody can be told.
pub fn complain_about(problem: &Problem, words: &Words) {
    complain(&format!("{}: {}", words.key("terminal-error"), told(problem, words)));
}

/// A problem in words.
pub fn told(problem: &Problem, words: &Words) -> String {
    match problem.downcast_ref::<Told>() {
        Some(Told { path, message }) => {
            let file = path.as_ref().map_or(String::new(), |path| format!("{}: ", path.display()));
            file + &words.text(message)
        }
        None => match problem.downcast_ref::<std::io::Error>() {
            Some(error) => words.text(&told_by_system(error, true)), // files are named: this is the output
            None => problem.to_string(),
        },
    }
}

/// Largest file that is read, bytes; a device like /dev/zero never ends.
const LARGEST: u64 = 100 << 20;
/// Largest part program that is held, bytes: with straight motions alone a run takes four times that.
const LARGEST_PROGRAM: u64 = 1 << 30;

/// Bytes of a file; the error names the file.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    limited(path, LARGEST)
}

fn limited(path: &Path, largest: u64) -> Result<Vec<u8>, Problem> {
    let mut source = Vec::new();
    std::fs::File::open(path)
        .and_then(|file| file.take(largest + 1).read_to_end(&mut source))
        .map_err(|error| unreadable(path, &error))?;
    if source.len() as u64 > largest {
        return Err(wrong_file(path, Message::new("terminal-large").number("most", (largest >> 20) as f64)));
    }
    Ok(source)
}

/// A part program in UTF-8, whatever it is written in; the error names the file and says what it is instead. A byte
/// that stands for no character becomes the sign for that, except in UTF-8, where it stays.
pub fn program(path: &Path) -> Result<Vec<u8>, Problem> {
    let ends = std::fs::metadata(path).is_ok_and(|file| file.is_file());
    decoded(path, limited(path, if ends { LARGEST_PROGRAM } else { LARGEST })?)
}

/// Refuses a log of measurements where a program is wanted, and says where it is read.
pub fn no_log(path: &Path, source: &[u8]) -> Result<(), Problem> {
    let foreign = foreign::log_of(source).map(|control| control.name);
    let key = match (foreign, app::log_of(source)) {
        (Some(_), _) => "terminal-foreign-log",
        (None, Some(_)) => "terminal-read-log",
        (None, None) => return Ok(()),
    };
    let told = Message::new(key).text("path", printable(&path.display().to_string()));
    Err(wrong_file(path, told.text("control", foreign.unwrap_or_default())))
}

/// Bytes of a text in UTF-8.
fn decoded(path: &Path, source: Vec<u8>) -> Result<Vec<u8>, Problem> {
    let encoding = recognise(&source).map_err(|what| wrong_file(path, Message::new(what)))?;
    Ok(match table(encoding) {
        None => source,
        Some(table) => table.decode(&source).0.into_owned().into_bytes(),
    })
}

/// A part program as it is, except in UTF-16, where a character is no byte: that comes in UTF-8.
pub fn as_it_is(path: &Path) -> Result<Vec<u8>, Problem> {
    let source = limited(path, LARGEST_PROGRAM)?;
    let encoding = recognise(&source).map_err(|what| wrong_file(path, Message::new(what)))?;
    if encoding.to_string().starts_with("utf-16") { program(path) } else { Ok(source) }
}

/// The table that puts a text into UTF-8; none: it is.
fn table(encoding: Encoding) -> Option<&'static encoding_rs::Encoding> {
    let label = encoding.to_string();
    let table = encoding_rs::Encoding::for_label(label.trim_end_matches("-marked").as_bytes());
    table.filter(|table| *table != encoding_rs::UTF_8)
}

/// Writes texts one behind the other into a file; the error names it.
pub fn write(path: &Path, texts: impl Iterator<Item = String>) -> Result<(), Problem> {
    let written = std::fs::File::create(path).and_then(|file| {
        let mut file = BufWriter::new(file);
        for text in texts {
            file.write_all(text.as_bytes())?;
        }
        file.flush()
    });
    written.map_err(|error| unwritable(path, &error))
}

/// Makes a folder with those around it; the error names it.
pub fn make_folder(folder: &Path) -> Result<(), Problem> {
    std::fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))
}

/// Writes a document, with the sentence beside every key.
pub fn print_json(mut document: Value, words: &Words, out: &mut dyn Write) -> Result<(), Problem> {
    words.speak(&mut document);
    Ok(writeln!(out, "{}", serde_json::to_string_pretty(&document)?)?)
}

/// A line on standard error; where that is closed, nobody can be told.
pub fn complain(line: &str) {
    drop(writeln!(std::io::stderr(), "{line}"));
}

/// Every file below a folder, sorted; the error names the folder that cannot be read.
pub fn below(folder: &Path) -> Result<Vec<PathBuf>, Problem> {
    let (mut folders, mut files) = (vec![folder.to_owned()], Vec::new());
    while let Some(folder) = folders.pop() {
        let wrong = |error: std::io::Error| unreadable(&folder, &error);
        for entry in std::fs::read_dir(&folder).map_err(wrong)? {
            let entry = entry.map_err(wrong)?;
            let kind = entry.file_type().map_err(wrong)?;
            match kind {
                _ if kind.is_dir() => folders.push(entry.path()),
                _ if kind.is_file() => files.push(entry.path()),
                _ => {} // a link may lead back
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Text of a file that is no program (a setup, a scenario, a protocol, a script), whatever it is written in. The error
/// names the file.
pub fn text(path: &Path) -> Result<String, Problem> {
    let text = decoded(path, bytes(path)?)?;
    Ok(String::from_utf8_lossy(&text).trim_start_matches('\u{feff}').to_owned())
}

/// Text of a file that a machine exported: an archive may have parts that are no text, the others are read.
pub fn exported(path: &Path) -> Result<String, Problem> {
    let source = limited(path, LARGEST)?;
    let text = decoded(path, source.clone()).unwrap_or(source);
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// The machine of a setup file. The error names the file, and the line and column in it; who reads JSON gets it as a
/// document too.
pub fn setup(path: &Path, as_json: bool, words: &Words, out: &mut dyn Write) -> Result<Setup, Problem> {
    let refused = match json::setup_from_json(&text(path)?) {
        Ok(setup) => {
            doubts(path, &setup, words);
            return Ok(setup);
        }
        Err(refused) => refused,
    };
    if as_json {
        let file = path.display().to_string();
        print_json(serde_json::json!({ "file": file, "refused": refused }), words, out)?;
        out.flush()?;
    }
    let cure = if refused.position.is_some() { format!(" {}", words.key("terminal-file-cure")) } else { String::new() };
    Err((refusal(path, &refused, words) + &cure).into())
}

/// Tells data of a machine that are outside of their limits; a run shows what comes of them.
fn doubts(path: &Path, setup: &Setup, words: &Words) {
    for MachineProblem { refusal, .. } in machine_doubts(&setup.control) {
        let texts = [&refusal.message, &refusal.hint].map(|message| words.text(message));
        complain(&format!("{}: {}: {}", path.display(), severity(Severity::Warning), texts.join(" ")));
    }
}

/// Why a file is refused, behind its name and the place in it.
pub fn refusal(path: &Path, refused: &json::Error, words: &Words) -> String {
    let place = refused.position.map_or(String::new(), |(line, column)| format!("{line}:{column}:"));
    format!("{}:{place} {}", path.display(), words.text(&refused.message))
}

/// The control that was asked for, else the one that the program is written for.
pub fn dialect(control: Option<Control>, source: &[u8]) -> Dialect {
    match control {
        Some(Control::Sinumerik) => Dialect::Sinumerik,
        Some(Control::Nct) => Dialect::Nct,
        None => Dialect::of(source),
    }
}
