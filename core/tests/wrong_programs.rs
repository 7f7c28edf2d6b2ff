//! Wrong programs with the messages that they give: `tests/wrong/NAME.mpf` and what `probewright check` prints,
//! `NAME.txt`; with `NAME.json` it is held against that machine, else against `machine.json`, whose probe is
//! calibrated.
//! `PROBEWRIGHT_UPDATE=1` writes the texts anew; then they are read by a person. Of the programs in `tests/right`
//! nothing is to be said.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::control::Control;
use probewright_core::diagnostic::{Code, Diagnostic, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::json::setup_from_json;
use probewright_core::machine::Stop;
use probewright_core::program::change::apply;
use probewright_core::program::findings_on;
use probewright_core::report::findings::finding;
use probewright_core::run::{Limits, assumed};
use probewright_core::syntax::read;
use probewright_core::words::Words;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/wrong")
}

fn programs() -> Vec<PathBuf> {
    programs_in(&folder())
}

fn programs_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "mpf"))
        .collect();
    paths.sort();
    paths
}

// oracle: self (printed once, then read and corrected by hand)
#[test]
fn wrong_programs_give_helpful_messages() {
    let programs = programs();
    assert!(programs.len() >= 50, "{}", programs.len());
    for path in programs {
        let name = path.file_name().unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_probewright"));
        command.env("LC_ALL", "C").current_dir(folder());
        command.arg("check").arg(name);
        command.arg("--setup").arg(machine_beside(&path));
        let output = command.output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        let expected = path.with_extension("txt");
        if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
            std::fs::write(&expected, &printed).unwrap();
        }
        let wanted = std::fs::read_to_string(&expected).unwrap_or_default();
        assert_eq!(printed, wanted.replace("\r\n", "\n"), "{name:?}");
        assert!(!printed.is_empty(), "{name:?} is not wrong");
        assert!(!printed.contains("{$"), "{name:?} lacks an argument: {printed}");
    }
}

/// The machine of a program, else the one of all.
fn machine_beside(path: &Path) -> PathBuf {
    let own = path.with_extension("json");
    let common = folder().join("machine.json");
    if own.exists() { own } else { common }
}

fn machine(path: &Path) -> Control {
    let text = std::fs::read_to_string(machine_beside(path)).unwrap();
    setup_from_json(&text).unwrap().control
}

fn same(one: &Diagnostic, other: &Diagnostic) -> bool {
    (one.code, &one.message, one.param) == (other.code, &other.message, other.param)
}

// oracle: self (what a remedy promises)
#[test]
fn every_cure_mends_its_finding() {
    let mut cured = 0;
    for path in programs() {
        let source = std::fs::read(&path).unwrap();
        let control = machine(&path);
        let findings = |source: &[u8]| findings_on(&read(Dialect::Sinumerik, source), control.clone());
        let before = findings(&source);
        for finding in before.iter().filter(|finding| finding.cure.is_some()) {
            let edits = &finding.cure.as_ref().unwrap().edits;
            assert!(!edits.is_empty(), "{path:?} {finding:?}");
            let after = findings(&apply(&source, edits));
            let count = |list: &[Diagnostic]| list.iter().filter(|one| same(one, finding)).count();
            assert!(count(&after) < count(&before), "{path:?} {finding:?} {after:?}");
            let errors = |list: &[Diagnostic]| list.iter().filter(|one| one.severity == Severity::Error).count();
            assert!(errors(&after) <= errors(&before), "{path:?} {finding:?} {after:?}");
            cured += 1;
        }
    }
    assert!(cured >= 12, "{cured}");
}

// oracle: self (the sentence that the finding says, with what it found left open)
#[test]
fn every_finding_is_one_that_its_number_explains() {
    let words = Words::english();
    let mut told = 0;
    for path in programs() {
        let program = read(Dialect::Sinumerik, &std::fs::read(&path).unwrap());
        for one in findings_on(&program, machine(&path)) {
            let Code::Own(number) = one.code else {
                continue;
            };
            let explained = finding(&format!("PW{number}"), &words);
            let said = words.text(&one.message);
            let hint = one.hint.as_ref().map(|hint| words.text(hint)).unwrap_or_default();
            assert!(!said.contains("{$") && !hint.contains("{$"), "{said} {hint}");
            let fits = |line: &str| {
                let parts = line.split_once(": ").map_or("", |(_, text)| text).split('…');
                let mut rest = Some(said.as_str());
                for part in parts {
                    rest = rest.and_then(|rest| rest.split_once(part)).map(|(_, rest)| rest);
                }
                rest.is_some()
            };
            assert!(explained.lines().any(fits), "{said}\n{explained}");
            told += 1;
        }
    }
    assert!(told > 40, "{told}");
}

// oracle: hand (`tests/right`: programs as they are meant, of which a colleague has nothing to say)
#[test]
fn right_programs_give_no_finding() {
    let programs = programs_in(&folder().join("../right"));
    assert!(programs.len() >= 10, "{}", programs.len());
    let text = std::fs::read_to_string(folder().join("machine.json")).unwrap();
    let control = setup_from_json(&text).unwrap().control;
    for path in programs {
        let program = read(Dialect::Sinumerik, &std::fs::read(&path).unwrap());
        let found = findings_on(&program, control.clone());
        assert!(found.is_empty(), "{path:?} {found:?}");
    }
}

// oracle: hand (`tests/right`: no word stops a run; a machine that is made for a program proves no measurement)
#[test]
fn no_word_of_a_right_program_stops_its_run() {
    let mut stopped = Vec::new();
    for path in programs_in(&folder().join("../right")) {
        let program = read(Dialect::Sinumerik, &std::fs::read(&path).unwrap());
        let outcome = assumed::run(&program, Limits::default()).outcome;
        let wrong = |one: &&Diagnostic| one.severity == Severity::Error && matches!(one.code, Code::Own(_));
        let error = outcome.diagnostics.iter().find(wrong).map(|one| one.message.clone());
        let of_cycle = |stop: &Stop| match stop {
            Stop::Alarm(_) => true,
            Stop::Fault(message) => message.key == "run-no-simulation",
        };
        if !outcome.stop.as_ref().is_none_or(of_cycle) || outcome.stop.is_none() && error.is_some() {
            stopped.push((path, outcome.stop, error));
        }
    }
    assert_eq!(stopped, []);
}

// oracle: manual: its own programs (`tests/cases`) take their points far enough apart
#[test]
fn the_points_of_the_manual_are_not_warned_about() {
    let setup = std::fs::read_to_string(folder().join("machine.json")).unwrap();
    let control = setup_from_json(&setup).unwrap().control;
    let entries = std::fs::read_dir(folder().join("../cases")).unwrap();
    let programs = entries.map(|entry| entry.unwrap().path().join("program.mpf"));
    let mut count = 0;
    for path in programs.filter(|path| path.exists()) {
        let program = read(Dialect::Sinumerik, &std::fs::read(&path).unwrap());
        let found = findings_on(&program, control.clone());
        let doubt = |one: &&Diagnostic| matches!(one.code, Code::Own(170..=173));
        assert_eq!(found.iter().find(doubt), None, "{path:?}");
        count += 1;
    }
    assert!(count >= 20, "{count}");
}
