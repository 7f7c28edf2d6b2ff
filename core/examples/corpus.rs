//! Reads, checks and runs every program below folders and prints what came of each: `cargo xtask corpus FOLDER…`. A
//! look at programs that others wrote, which are no part of the tests. What is below a folder is one machine: each
//! program is run with the definition files and the other programs there, on a machine that fits it.
#![allow(missing_docs)]

use probewright_core::control::{Value, delivery};
use probewright_core::diagnostic::{Code, Diagnostic, Severity, Span};
use probewright_core::dialect::Dialect;
use probewright_core::encoding::recognise;
use probewright_core::machine::Stop;
use probewright_core::message::Arg;
use probewright_core::program::calls::calls;
use probewright_core::program::findings_of;
use probewright_core::run::outcome::Outcome;
use probewright_core::run::{Limits, Session, assumed};
use probewright_core::syntax::joined::Joined;
use probewright_core::syntax::{Program, read};
use probewright_core::words::Words;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// Rows of a table that are printed.
const ROWS: usize = 25;
/// Parameters of its own that a program is given values for.
const PARAMETERS: usize = 40;

/// A file that holds a program or definitions.
struct File {
    path: PathBuf,
    source: Vec<u8>,
}

/// How often something came, and where it came first.
#[derive(Default)]
struct Row {
    count: usize,
    first: String,
}

/// What came of a folder.
#[derive(Default)]
struct Summary {
    programs: usize,
    definitions: usize,
    /// Files that hold no program, and why.
    passed_over: BTreeMap<&'static str, usize>,
    blocks: usize,
    calls: usize,
    /// Files whose blocks and what stands between them are not the file again.
    lost: Vec<PathBuf>,
    whole: usize,
    /// Of them, programs whose own parameters were given 0 or an empty text.
    given: usize,
    /// Why the others stopped.
    stops: BTreeMap<String, Row>,
    /// Errors that the check finds.
    errors: BTreeMap<String, Row>,
    reading: Duration,
    running: Duration,
}

fn main() -> ExitCode {
    let words = Words::english();
    let (mut failed, mut all) = (false, (0, 0));
    for folder in std::env::args_os().skip(1) {
        let folder = Path::new(&folder);
        let mut summary = Summary::default();
        let files = match summary.collect(folder) {
            Ok(files) => files,
            Err(error) => {
                eprintln!("error: {}: {error}", folder.display());
                return ExitCode::from(2);
            }
        };
        for file in files.iter().filter(|file| !is_definition(&file.path)) {
            summary.take(file, &files, &words);
        }
        println!("{}", folder.display());
        summary.print();
        failed |= !summary.lost.is_empty();
        all = (all.0 + summary.whole, all.1 + summary.programs);
    }
    println!("in all: {} of {} programs run whole", all.0, all.1);
    ExitCode::from(u8::from(failed))
}

impl Summary {
    /// The files below a folder, in the order of their names.
    fn collect(&mut self, folder: &Path) -> std::io::Result<Vec<File>> {
        let (mut folders, mut paths) = (vec![folder.to_owned()], Vec::new());
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder)? {
                let path = entry?.path();
                if path.is_dir() { folders.push(path) } else { paths.push(path) }
            }
        }
        paths.sort();
        let mut files = Vec::new();
        for path in paths {
            let source = std::fs::read(&path)?;
            match recognise(&source) {
                Ok(encoding) => files.push(File { path, source: in_utf8(&encoding.to_string(), source) }),
                Err(_) => *self.passed_over.entry("no program").or_default() += 1,
            }
        }
        self.definitions = files.iter().filter(|file| is_definition(&file.path)).count();
        Ok(files)
    }

    /// One program: read, checked, run with the other files.
    fn take(&mut self, file: &File, files: &[File], words: &Words) {
        let begin = Instant::now();
        let program = read(Dialect::of(&file.source), &file.source);
        self.programs += 1;
        self.blocks += program.blocks.len();
        self.calls += calls(&program).len();
        if put_together(&program) != file.source {
            self.lost.push(file.path.clone());
        }
        let alone = is(&file.path, "arc"); // an archive has its own definitions and programs
        let beside = || files.iter().filter(|other| !alone && other.path != file.path && !is(&other.path, "arc"));
        let defined = with(file, beside().filter(|other| is_definition(&other.path)));
        let own = program.end.max(1);
        let checked = findings_of(&defined, &calls(&defined), &delivery(defined.dialect));
        for found in checked.iter().filter(|found| found.severity == Severity::Error && starts_before(found, own)) {
            let line = found.span.map_or(0, |span| line_of(&defined, span.start));
            let what = format!("{} {}", name(found.code), words.text(&found.message));
            count(&mut self.errors, what, || format!("{}:{line}", file.path.display()));
        }
        self.reading += begin.elapsed();
        let begin = Instant::now();
        let (outcome, given) = run(&Rc::new(with(file, beside())));
        self.running += begin.elapsed();
        match &outcome.stop {
            None => {
                self.whole += 1;
                self.given += usize::from(given);
            }
            Some(stop) => {
                let line = outcome.line.unwrap_or(0);
                let why = reason(stop, words);
                count(&mut self.stops, why, || format!("{}, line {line} of all", file.path.display()));
            }
        }
    }

    fn print(&self) {
        let Summary { programs, definitions, blocks, calls, whole, given, .. } = self;
        println!("  {programs} programs, {definitions} definition files, {blocks} blocks, {calls} measuring calls");
        for (why, count) in &self.passed_over {
            println!("  {count} passed over: {why}");
        }
        for path in &self.lost {
            println!("  not read back to the byte: {}", path.display());
        }
        println!("  {whole} of {programs} run whole, {given} of them with 0 for parameters of their own");
        print_table("stopped", &self.stops);
        print_table("errors of the check", &self.errors);
        println!("  {:.1?} to read and check, {:.1?} to run", self.reading, self.running);
    }
}

/// Runs a program; one that needs values for its own parameters gets 0 or an empty text for them.
fn run(program: &Rc<Program>) -> (Outcome, bool) {
    let mut values = BTreeMap::new();
    loop {
        let given = |session: Session| session.with_arguments(values.clone());
        let outcome = assumed::run_with(program, None, Limits::default(), given, &mut |_| {}).outcome;
        let Some(Stop::Fault(message)) = &outcome.stop else { return (outcome, !values.is_empty()) };
        let asked = message.args.iter().find_map(|(name, arg)| match arg {
            Arg::Text(text) if *name == "word" && message.key == "run-parameter" => Some(text.to_string()),
            _ => None,
        });
        match asked.filter(|_| values.len() < PARAMETERS) {
            Some(word) if !values.contains_key(&word) => _ = values.insert(word, Value::Number(0.0)),
            _ => return (outcome, !values.is_empty()),
        }
    }
}

fn count(rows: &mut BTreeMap<String, Row>, what: String, place: impl FnOnce() -> String) {
    let row = rows.entry(what).or_insert_with(|| Row { count: 0, first: place() });
    row.count += 1;
}

/// The most frequent first.
fn print_table(title: &str, rows: &BTreeMap<String, Row>) {
    let mut all: Vec<_> = rows.iter().collect();
    all.sort_by_key(|(_, row)| std::cmp::Reverse(row.count));
    for (what, row) in all.iter().take(ROWS) {
        println!("  {title} {:>5}  {what}  ({})", row.count, row.first);
    }
    if all.len() > ROWS {
        println!("  {title}: {} more sorts", all.len() - ROWS);
    }
}

/// A program with others behind it.
fn with<'f>(file: &File, others: impl Iterator<Item = &'f File>) -> Program {
    let mut joined = Joined::new(Dialect::of(&file.source), file.source.clone());
    others.for_each(|other| joined.add(&name_of(&other.path), &other.source));
    read(joined.dialect, &joined.text)
}

fn is_definition(path: &Path) -> bool {
    is(path, "def")
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|own| own.eq_ignore_ascii_case(ending))
}

fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

fn starts_before(found: &Diagnostic, end: u32) -> bool {
    found.span.is_none_or(|span| span.start < end)
}

fn line_of(program: &Program, at: u32) -> usize {
    program.blocks.partition_point(|block| block.span.start <= at)
}

/// The text in UTF-8; what is UTF-8 stays as it is.
fn in_utf8(name: &str, bytes: Vec<u8>) -> Vec<u8> {
    let label = name.trim_end_matches("-marked");
    match encoding_rs::Encoding::for_label(label.as_bytes()) {
        Some(table) if label != "utf-8" => table.decode(&bytes).0.into_owned().into_bytes(),
        _ => bytes,
    }
}

/// The blocks of a program with the line ends between them, and what stands behind the end of the file.
fn put_together(program: &Program) -> Vec<u8> {
    let ends = |start, end| program.text(Span { start, end }).iter().filter(|byte| matches!(byte, b'\r' | b'\n'));
    let (mut text, mut behind) = (Vec::new(), 0);
    for block in &program.blocks {
        text.extend(ends(behind, block.span.start));
        text.extend(program.text(block.span));
        behind = block.span.end;
    }
    text.extend(ends(behind, program.end));
    text.extend(program.text(Span { start: program.end, end: program.source.len() as u32 }));
    text
}

fn name(code: Code) -> String {
    match code {
        Code::Alarm(number) => number.to_string(),
        Code::Nct(text) => text.to_owned(),
        Code::Own(number) => format!("PW{number:03}"),
    }
}

fn reason(stop: &Stop, words: &Words) -> String {
    match stop {
        Stop::Alarm(code) => format!("alarm {}", name(*code)),
        Stop::Fault(message) => words.text(message),
    }
}
