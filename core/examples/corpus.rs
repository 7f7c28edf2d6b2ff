//! Reads, checks and runs every program below a folder and prints what came of it: `cargo xtask corpus FOLDER`. A look
//! at programs that others wrote, which are no part of the tests.
#![allow(missing_docs)]

use probewright_core::control::{Edge, Plane, Tool, delivery};
use probewright_core::diagnostic::{Code, Span};
use probewright_core::dialect::Dialect;
use probewright_core::encoding::recognise;
use probewright_core::machine::{Setup, Stop};
use probewright_core::program::calls::calls;
use probewright_core::program::findings_of;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::{Program, read};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// What came of all files.
#[derive(Default)]
struct Summary {
    files: usize,
    /// Files that hold no program, and why.
    passed_over: BTreeMap<&'static str, usize>,
    blocks: usize,
    calls: usize,
    /// Files whose blocks and what stands between them are not the file again.
    lost: Vec<PathBuf>,
    /// How often each finding comes, and in how many files.
    findings: BTreeMap<String, (usize, usize)>,
    stops: BTreeMap<String, usize>,
    reading: Duration,
    running: Duration,
}

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1) else {
        eprintln!("error: which folder?");
        return ExitCode::from(2);
    };
    let mut paths = Vec::new();
    if let Err(error) = collect(Path::new(&folder), &mut paths) {
        eprintln!("error: {}: {error}", Path::new(&folder).display());
        return ExitCode::from(2);
    }
    paths.sort();
    let mut summary = Summary::default();
    for path in paths {
        summary.take(&path);
    }
    summary.print();
    ExitCode::from(u8::from(!summary.lost.is_empty()))
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, paths)?;
        } else {
            paths.push(path);
        }
    }
    Ok(())
}

impl Summary {
    /// One file: read, checked, run.
    fn take(&mut self, path: &Path) {
        let Ok(bytes) = std::fs::read(path) else {
            *self.passed_over.entry("not to be read").or_default() += 1;
            return;
        };
        let source = match recognise(&bytes) {
            Ok(encoding) => in_utf8(&encoding.to_string(), bytes),
            Err(_) => {
                *self.passed_over.entry("no program").or_default() += 1;
                return;
            }
        };
        let begin = Instant::now();
        let program = read(Dialect::of(&source), &source);
        let control = delivery(program.dialect);
        let sites = calls(&program);
        let mut codes: Vec<String> =
            findings_of(&program, &sites, &control).iter().map(|found| name(found.code)).collect();
        self.reading += begin.elapsed();
        let begin = Instant::now();
        let outcome = run(&program, &machine(&program), Limits::default());
        self.running += begin.elapsed();
        codes.extend(outcome.diagnostics.iter().map(|found| name(found.code)));
        self.files += 1;
        self.blocks += program.blocks.len();
        self.calls += sites.len();
        if put_together(&program) != source {
            self.lost.push(path.to_owned());
        }
        for code in codes.iter().collect::<BTreeSet<_>>() {
            self.findings.entry(code.clone()).or_default().1 += 1;
        }
        for code in codes {
            self.findings.entry(code).or_default().0 += 1;
        }
        *self.stops.entry(reason(outcome.stop.as_ref())).or_default() += 1;
    }

    fn print(&self) {
        let exact = self.files - self.lost.len();
        println!("{} files, {} blocks, {} calls of measuring cycles", self.files, self.blocks, self.calls);
        for (why, count) in &self.passed_over {
            println!("{count} passed over: {why}");
        }
        println!("{exact} read back to the byte");
        for path in &self.lost {
            println!("  not: {}", path.display());
        }
        println!("findings: times, files");
        for (code, (times, files)) in by_count(&self.findings) {
            println!("{times:>8} {files:>6}  {code}");
        }
        println!("runs end by");
        for (reason, count) in by_count(&self.stops) {
            println!("{count:>8}         {reason}");
        }
        println!("{:.1?} to read and check, {:.1?} to run", self.reading, self.running);
    }
}

/// The most frequent first.
fn by_count<T: Ord + Copy>(counted: &BTreeMap<String, T>) -> Vec<(&String, T)> {
    let mut all: Vec<(&String, T)> = counted.iter().map(|(name, count)| (name, *count)).collect();
    all.sort_by_key(|one| std::cmp::Reverse(one.1));
    all
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

/// A mill as delivered, its probe calibrated, with a milling cutter for every number by which a program calls a tool.
fn machine(program: &Program) -> Setup {
    let mut setup = Setup::calibrated(program.dialect, Plane::G17);
    let edge = Edge { kind: 120, length: [80.0, 0.0, 0.0], radius: 5.0, ..Edge::default() };
    for number in 1..=99 {
        let edges = (1..=9).map(|number| (number, edge.clone())).collect();
        setup.control.tools.entry(number).or_insert_with(|| Tool { name: format!("T{number}"), edges });
    }
    setup
}

fn name(code: Code) -> String {
    match code {
        Code::Alarm(number) => number.to_string(),
        Code::Nct(text) => text.to_owned(),
        Code::Own(number) => format!("PW{number:03}"),
    }
}

fn reason(stop: Option<&Stop>) -> String {
    match stop {
        None => "the end of the program".to_owned(),
        Some(Stop::Alarm(code)) => name(*code),
        Some(Stop::Fault(message)) => message.key.to_string(),
    }
}
