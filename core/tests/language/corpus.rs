//! Programs of another project with the axis positions that its interpreter gives for them (oracle: peer). They are no
//! part of this repository; where their folder is not there, nothing is compared. What comes out differently is listed
//! here with the reason, and argued in DESIGN.md.

use super::{near, setup};
use probewright_core::control::{Tool, Value};
use probewright_core::dialect::Dialect;
use probewright_core::machine::Stop;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use std::path::{Path, PathBuf};

/// Names that the other interpreter knows without a declaration; on the control it is an alarm.
const DECLARED: [(&str, &str); 3] = [
    ("arrays", "DEF INT nn,m,o\n"),
    ("custom_vars", "DEF INT aa=15,bb=9\n"),
    ("edge_cases", "DEF REAL E_MULTIPLIER,F_MULTI,ELX\n"),
];

/// Programs that stop here, and why.
const STOPPED: [(&str, &str); 3] = [
    ("axis_index_assignment", "run-unknown-variable"), // an axis E, which the machine does not have
    ("function_calls", "run-alarm-number"),            // SETAL(12345) is no number of a cycle or a user
    ("simple", "run-arc"),                             // G2 without centre and radius
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/corpus/language")
}

/// Starts where the tables start: X1600 Y900 Z0, a rotary axis A, nothing in the spindle.
fn go(name: &str, text: &str) -> Outcome {
    let mut setup = setup();
    setup.position = [1600.0, 900.0, 0.0];
    let control = &mut setup.control;
    (control.tool, control.edge) = (0, 0);
    let axis = Value::Text("A".into());
    control.data.insert("MD20080[3]".into(), axis);
    let mill = Tool { name: "BALL_MILL_8MM_SHORT".into(), edges: [(1, Default::default())].into() };
    control.tools.insert(8, mill);
    let before = DECLARED.iter().find(|(known, _)| *known == name);
    let text = format!("{}{text}", before.map_or("", |(_, text)| text));
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

/// Positions of X Y Z A as they follow each other in a table; none: the axis has not been programmed yet.
fn table(text: &str) -> Vec<[Option<f64>; 4]> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let column = |axis: &str| header.iter().position(|name| *name == axis);
    let columns = ["X", "Y", "Z", "A"].map(column);
    let mut rows: Vec<[Option<f64>; 4]> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            columns.map(|column| cells.get(column?)?.parse().ok())
        })
        .filter(|row| row.iter().any(Option::is_some))
        .collect();
    rows.dedup();
    rows
}

/// The same of a run: the ends of its motions.
fn positions(outcome: &Outcome) -> Vec<[f64; 4]> {
    let mut now = [1600.0, 900.0, 0.0, 0.0];
    let mut all = Vec::new();
    for entry in &outcome.trace.entries {
        match entry.step {
            Step::Motion { to: [x, y, z], .. } => now = [x, y, z, now[3]],
            Step::Table { to, .. } => now[3] = to,
            _ => continue,
        }
        all.push(now);
    }
    all.dedup_by(|a, b| a.iter().zip(b.iter()).all(|(a, b)| (a - b).abs() < 1e-9));
    all
}

fn meets(row: &[Option<f64>; 4], position: &[f64; 4]) -> bool {
    let mut pairs = row.iter().zip(position);
    pairs.all(|(row, position)| row.is_none_or(|row| (row - position).abs() < 0.000_51))
}

/// Every row of the table is reached in its order, and nothing else.
fn compare(name: &str, rows: &[[Option<f64>; 4]], positions: &[[f64; 4]]) {
    let mut at = 0;
    let mut reached = None;
    for row in rows {
        if reached.is_some_and(|position| meets(row, position)) {
            continue;
        }
        let rest = positions.get(at..).unwrap_or_default();
        let next = rest.iter().position(|position| meets(row, position));
        let next = next.unwrap_or_else(|| panic!("{name}: {row:?} is not reached: {rest:?}"));
        assert!(next == 0, "{name}: {:?} is too much", rest[0]);
        reached = rest.get(next);
        at += next + 1;
    }
    assert_eq!(at, positions.len(), "{name}: {:?}", positions.get(at..));
}

// oracle: peer
#[test]
fn programs_of_another_interpreter_go_the_same_way() {
    let Ok(entries) = std::fs::read_dir(folder()) else {
        return;
    };
    let mut compared = 0;
    for entry in entries {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "mpf") {
            continue;
        }
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let outcome = go(&name, &std::fs::read_to_string(&path).unwrap());
        if let Some((_, key)) = STOPPED.iter().find(|(known, _)| *known == name) {
            assert!(
                matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == *key),
                "{name}: {:?}",
                outcome.stop
            );
            continue;
        }
        assert_eq!(outcome.stop, None, "{name}: {:?}", outcome.diagnostics);
        let csv = ["csv", "raw"].map(|kind| match kind {
            "csv" => path.with_extension("csv"),
            _ => path.with_file_name(format!("{name}_raw.csv")),
        });
        let csv = csv.iter().find_map(|path| std::fs::read_to_string(path).ok());
        compare(&name, &table(&csv.unwrap()), &positions(&outcome));
        compared += 1;
    }
    assert!(compared >= 29, "{compared}");
}

/// Our own programs of the same kinds, so that the comparison is proven without that folder: text and the positions X Y
/// Z of its blocks that move, reckoned by hand.
const OWN: [(&str, &[[f64; 3]]); 7] = [
    (
        "DEF REAL STEP=2.5, TOP=6\nG1 X0 Y0 Z0 F500\nREPEAT\nZ=IC(STEP)\nUNTIL $AA_IW[Z]>=TOP-0.01\nTRANS Z20\n\
            Y=$AA_IW[Z]",
        &[[0.0, 0.0, 0.0], [0.0, 0.0, 2.5], [0.0, 0.0, 5.0], [0.0, 0.0, 7.5], [0.0, -12.5, 7.5]],
    ),
    (
        "G1 X0 Y0 Z0 F500\nTRANS X50 Y3\nX1 Y1\nATRANS X5\nX=IC(2)\nTRANS\nX4",
        &[[0.0, 0.0, 0.0], [51.0, 4.0, 0.0], [58.0, 4.0, 0.0], [4.0, 4.0, 0.0]],
    ),
    (
        "R1=3 R2=0\nG1 X0 Y0 Z0 F500\nBACK: X=R1*10\nR1=R1-1\nIF R1>0 GOTOB BACK\nGOTOF 90\nX999\nN90 Y7",
        &[[0.0, 0.0, 0.0], [30.0, 0.0, 0.0], [20.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 7.0, 0.0]],
    ),
    (
        "DEF INT GRID[2,3]=SET(1,2,3,4,5,6), ROW, COLUMN\nG1 X0 Y0 Z0 F500\nFOR ROW=0 TO 1\nFOR COLUMN=1 TO 2\n\
            X=GRID[ROW,COLUMN]\nENDFOR\nENDFOR",
        &[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0], [5.0, 0.0, 0.0], [6.0, 0.0, 0.0]],
    ),
    (
        "DEF INT WHICH=8\nG1 X0 Y0 Z0 F500\nCASE(WHICH+1) OF 7 GOTOF ONE 9 GOTOF TWO DEFAULT GOTOF THREE\nONE: X1\n\
            TWO: X2\nTHREE: X3",
        &[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]],
    ),
    (
        "DEF STRING[9] NAME=\"A-1\"\nG1 X0 Y0 Z0 F500\nIF (NAME==\"A-1\") AND NOT (2>3)\nX=7 DIV 2\nELSE\nX=9\nENDIF\n\
            Y=17 MOD 5 Z=2*-3",
        &[[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, -6.0]],
    ),
    (
        "G70 G1 X0 Y0 Z0 F500\nX1\nG710 X1\nG91 X=AC(0) Y=4\nG90 ROT Z90\nX=SQRT(POT(3)+POT(4)) Y0",
        &[[0.0, 0.0, 0.0], [25.4, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 5.0, 0.0]],
    ),
];

// oracle: hand
#[test]
fn our_own_programs_go_their_way() {
    for (text, expected) in OWN {
        let outcome = go("own", text);
        assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]), "{text}");
        let found = positions(&outcome);
        assert_eq!(found.len(), expected.len(), "{text}: {found:?}");
        for (found, expected) in found.iter().zip(expected) {
            for (found, expected) in found.iter().zip(expected) {
                near(*found, *expected, text);
            }
        }
    }
}
