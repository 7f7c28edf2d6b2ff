//! Worked measurements of the manual, run as programs: every folder of `tests/cases` that has a `case.json`.
//! The truth of each case stands in its `oracle`. Written in the manner in which manuals print programs they have to
//! give the same.

#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod manner;
mod planes;

use probewright_core::catalogue::alarms;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax;
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

/// mm, and the unit of the datum.
const TOLERANCE: f64 = 1e-6;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folders with cases, sorted.
fn folders() -> Vec<PathBuf> {
    let all = std::fs::read_dir(root().join("tests/cases")).expect("folder tests/cases");
    let mut folders: Vec<PathBuf> =
        all.map(|entry| entry.unwrap().path()).filter(|path| path.join("case.json").exists()).collect();
    folders.sort();
    folders
}

/// Runs the cases of every folder with its program after a change of its text; how many there were.
fn every_case(change: impl Fn(Dialect, &str, &str) -> String) -> usize {
    let mut count = 0;
    for folder in folders() {
        let file = read(&folder);
        let program = match dialect(&file) {
            Dialect::Sinumerik => "program.mpf",
            Dialect::Nct => "program.nc",
        };
        let source = std::fs::read_to_string(folder.join(program)).unwrap();
        let name = folder.file_name().unwrap().to_string_lossy();
        count += cases(&folder, &file, &source, |text| change(dialect(&file), &name, text));
    }
    count
}

#[test]
fn own_programs() {
    let count = every_case(|_, _, source| source.to_owned());
    assert!(count >= 48, "only {count} cases found");
}

// oracle: the cases themselves; manuals print their programs in this manner
#[test]
fn programs_as_manuals_print_them() {
    let count = every_case(manner::printed);
    assert!(count >= 48, "only {count} cases found");
}

fn read(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("case.json")).unwrap();
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
}

/// The control of a folder.
fn dialect(file: &Value) -> Dialect {
    match file["setup"]["control"].as_str() {
        Some("nct") => Dialect::Nct,
        _ => Dialect::Sinumerik,
    }
}

/// An alarm by its number, or a message of NCT by its words.
fn code(value: &Value) -> Code {
    match value {
        Value::Number(number) => Code::Alarm(number.as_u64().unwrap() as u32),
        other => alarms::find(other.as_str().unwrap()).unwrap().code,
    }
}

/// Runs every case of a folder, its program written with `change`; how many there were.
fn cases(folder: &Path, file: &Value, source: &str, change: impl Fn(&str) -> String) -> usize {
    let cases = file["cases"].as_array().unwrap();
    for case in cases {
        let name = format!("{} {}", folder.file_name().unwrap().display(), case["id"]);
        assert!(case["oracle"].as_str().is_some_and(|oracle| !oracle.is_empty()), "{name}: no oracle");
        let mut source = source.to_string();
        for pair in case["replace"].as_array().into_iter().flatten() {
            let (old, new) = (pair[0].as_str().unwrap(), pair[1].as_str().unwrap());
            assert!(source.contains(old), "{name}: {old} is not in the program");
            source = source.replace(old, new);
        }
        let program = syntax::read(dialect(file), change(&source).as_bytes());
        let outcome = run(&program, &setup(file, case), Limits::default());
        expect(&name, &case["expect"], &outcome);
    }
    cases.len()
}

/// The setup of the file with what the case changes.
fn setup(file: &Value, case: &Value) -> Setup {
    let mut whole = file["setup"].clone();
    whole["workpiece"] = case["workpiece"].clone();
    for (member, value) in members(&case["setup"]) {
        whole[member] = value;
    }
    let mut setup = probewright_core::json::setup_from_json(&whole.to_string()).unwrap();
    for (name, value) in members(&case["data"]) {
        setup.control.set(name.clone(), value.as_f64().unwrap());
    }
    for (name, value) in members(&case["variables"]) {
        assert!(setup.control.set_variable(&name, value.as_f64().unwrap()), "{name}");
    }
    let settable = setup.control.settable;
    setup.control.activate(settable);
    setup
}

fn members(value: &Value) -> Map<String, Value> {
    value.as_object().cloned().unwrap_or_default()
}

/// Compares everything that the case tells.
fn expect(name: &str, expected: &Value, outcome: &Outcome) {
    let stop = expected.get("stop").map(|stop| Stop::Alarm(code(stop)));
    assert_eq!(outcome.stop, stop, "{name}: {:?}", outcome.diagnostics);
    if let Some(alarms) = expected["alarms"].as_array() {
        let alarms: Vec<Code> = alarms.iter().map(code).collect();
        assert_eq!(outcome.alarms(), alarms, "{name}");
    }
    for (datum, value) in members(&expected["data"]) {
        let found = outcome.control.number(&datum);
        close(name, &datum, found, value.as_f64().unwrap());
    }
    for (datum, value) in members(&expected["written"]) {
        let found = outcome.written().get(datum.as_str()).copied();
        close(name, &datum, found.unwrap(), value.as_f64().unwrap());
    }
    for (variable, value) in members(&expected["variables"]) {
        let found = outcome.control.variable(&variable).unwrap_or_default();
        close(name, &variable, found, value.as_f64().unwrap());
    }
    for (frame, origin) in members(&expected["origins"]) {
        let found = outcome.control.frames[&frame.parse().unwrap()].origin();
        points(name, "origins", &Value::Array(vec![origin]), &[found]);
    }
    points(name, "starts", &expected["starts"], &probings(outcome, |from, _, _| from));
    points(name, "touches", &expected["touches"], &touches(outcome));
    points(name, "ends", &expected["ends"], &ends(outcome));
    if let Some(feed) = expected["feed"].as_f64() {
        let feeds = probings(outcome, |_, _, feed| feed);
        assert!(!feeds.is_empty() && feeds.iter().all(|found| *found == feed), "{name}: {feeds:?}");
    }
    if let Some(angles) = expected["orientations"].as_array() {
        let turned = orientations(outcome);
        assert_eq!(turned.len(), angles.len(), "{name}: {turned:?}");
        for (found, angle) in turned.iter().zip(angles) {
            close(name, "orientation", *found, angle.as_f64().unwrap());
        }
    }
}

fn close(name: &str, what: &str, found: f64, expected: f64) {
    assert!((found - expected).abs() < TOLERANCE, "{name}: {what} is {found}, expected {expected}");
}

fn points(name: &str, what: &str, expected: &Value, found: &[[f64; 3]]) {
    let Some(expected) = expected.as_array() else {
        return;
    };
    assert_eq!(found.len(), expected.len(), "{name}: {what} {found:?}");
    for (found, expected) in found.iter().zip(expected) {
        for (found, expected) in found.iter().zip(expected.as_array().unwrap()) {
            close(name, what, *found, expected.as_f64().unwrap());
        }
    }
}

/// Something about every measuring motion, from start, end and feed.
fn probings<T>(outcome: &Outcome, tell: impl Fn([f64; 3], [f64; 3], f64) -> T) -> Vec<T> {
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    steps
        .filter_map(|step| match step {
            Step::Motion { kind: MotionKind::Measuring, from, to, feed, .. } => Some(tell(from.0, to.0, *feed)),
            _ => None,
        })
        .collect()
}

fn touches(outcome: &Outcome) -> Vec<[f64; 3]> {
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    steps
        .filter_map(|step| match step {
            Step::Touch { latched, .. } => Some(latched.0),
            _ => None,
        })
        .collect()
}

fn orientations(outcome: &Outcome) -> Vec<f64> {
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    steps
        .filter_map(|step| match step {
            Step::Orient { angle } => Some(angle.0),
            _ => None,
        })
        .collect()
}

/// Where the machine stood at the end of every call.
fn ends(outcome: &Outcome) -> Vec<[f64; 3]> {
    let mut here = [0.0; 3];
    let mut ends = Vec::new();
    for entry in &outcome.trace.entries {
        match &entry.step {
            Step::Motion { to, .. } => here = to.0,
            Step::CallEnd => ends.push(here),
            _ => {}
        }
    }
    ends
}
