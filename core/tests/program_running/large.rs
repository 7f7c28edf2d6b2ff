//! Large programs: blocks that are read when they come, and texts that come in pieces, do what the whole tree does.

use crate::running::machine;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::run::pieces::Piece;
use probewright_core::run::{Limits, Outcome, Session, assumed, run};
use probewright_core::syntax::{read, read_lean};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The part programs of a folder.
pub fn programs(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests").join(folder);
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files.filter(|path| path.extension().is_some_and(|ending| ending != "txt")).collect()
}

fn assert_same(one: &Outcome, other: &Outcome, what: &str) {
    assert_eq!(one.diagnostics, other.diagnostics, "{what}");
    assert_eq!(one.trace, other.trace, "{what}");
    assert_eq!(format!("{one:?}"), format!("{other:?}"), "{what}");
}

/// Motions that need more than a straight line: corners, contours, modal calls, variables with names of addresses,
/// increments, inches, diameters, arcs, spindle feeds, frames, words that could not be read.
const MOTIONS: [&str; 14] = [
    "G1 F100\nX10 RND=2\nY10\nX0\n",
    "RNDM=1 F100\nX10\nN20 Y10\nX0 Z5\n",
    "T20 D1 M6\nG41 G1 X10 F100\nY10\nX20\nG40 X30\nM30\n",
    "MCALL L10\nX1\nX2 Y2\nMCALL\nX3\nM30\n%_N_L10_SPF\nR1=R1+1\nM17\n",
    "DEF REAL F=5, G=1\nN1\nF100\nG1\nX1\nX2 F7\n",
    "G91 F100\nX1\nX1 Y1\nG90\nX1\n",
    "G70 F10\nX1\nG700\nX1 F2\n",
    "DIAMON F100\nX10\nZ5\n",
    "G2 X10 Y0 CR=20 F100\nX20 Y10\nG1 X0\n",
    "G95 S500 M3\nX10 F0.1\nG96 S100\nX20\nG93\nX30 F2\n",
    "ROT Z30\nF100\nX10\nTRANS X5\nX10\nMIRROR X0\nX10 Y5\n",
    "F100\nX((\nX10\nX20\nY5\n",
    "G1\nX10\nX20\n",
    "F100\nX1e9\nX99999999\nX5\n",
];

// oracle: self: a run of the whole tree
#[test]
fn a_block_that_is_read_when_it_comes_does_what_its_words_do() {
    let on = |setup: &Setup, text: &str, dialect| {
        let macros = Arc::default();
        let runs = [read(dialect, text.as_bytes()), read_lean(dialect, text.as_bytes(), &macros)];
        runs.map(|program| run(&program, setup, Limits::default()))
    };
    for text in MOTIONS {
        let [all, straight] = on(&machine(), text, Dialect::Sinumerik);
        assert_same(&all, &straight, text);
    }
    let nct = "O1\nG0 X5\nG1 X10 F100\n#1=5\nX#1\nY7\nG31 Z-5\nX1 Y1\nM99 P10\nN10 M30\n";
    let setup = Setup::calibrated(Dialect::Nct, machine().control.plane);
    let [all, straight] = on(&setup, nct, Dialect::Nct);
    assert_same(&all, &straight, nct);
}

// oracle: self: a run of the whole tree
#[test]
fn a_run_of_any_program_is_the_same_with_blocks_left_as_text() {
    let folders = ["right", "wrong"].map(programs).concat();
    assert!(folders.len() > 50);
    for path in folders {
        let source = std::fs::read(&path).unwrap();
        let dialect = Dialect::of(&source);
        let limits = Limits::unwatched(1000);
        let all = assumed::run(&read(dialect, &source), limits);
        let straight = assumed::run(&read_lean(dialect, &source, &Arc::default()), limits);
        assert_eq!(all.told, straight.told, "{path:?}");
        assert_eq!(all.setup, straight.setup, "{path:?}");
        assert_same(&all.outcome, &straight.outcome, &path.display().to_string());
    }
}

/// Runs a text in pieces of so many lines.
fn in_pieces(setup: &Setup, text: &str, lines: usize) -> Outcome {
    let all: Vec<&str> = text.split_inclusive('\n').collect();
    let read = |piece: &[&str]| read_lean(Dialect::Sinumerik, piece.concat().as_bytes(), &Arc::default());
    let mut pieces = all.chunks(lines).map(read).collect::<Vec<_>>().into_iter();
    let first = pieces.next().unwrap();
    assert!(first.begins_pieces(), "{text}");
    let more = move || {
        let program = pieces.next()?;
        assert!(program.goes_on_in_pieces());
        Some(Piece { program, share: [0.0, 1.0] })
    };
    Session::new(first, setup, Limits::default()).in_pieces([0.0, 1.0], Box::new(more)).complete()
}

/// What the end of a text is told with: a feed that is missing, an axis beyond the limits, functions of the machine,
/// tools, an end before the last line.
const TEXTS: [&str; 5] = [
    "%_N_A_MPF\nG17 G54\nM3 S1000\nX1\nX2\nX3\nN10 M77\nX4 F100\nM78 ; text\nM77\nG0 Z5\n",
    "T20 D1\nM6\nG1 X1 F100\nT9 D1\nM6\nX2\nX3\nG18\nX4 Z1\nM30\nX9\n",
    "_TUL=0.03\nMSG(\"A\")\nX1 F100\nX2\nMSG(\"B\")\nSTOPRE\nU5\nX3\nX99999999\nX4\n",
    "G1 X1 F100\nX2\nA=7 ; B\nV10 X5\n/X6\n\nX7\nX8",
    "TRANS X10\nG91 F100\nX1\nX1\nG2 X1 Y1 CR=1\nX1 G1\nG90\nX1\nG645\nS500\n",
];

// oracle: self: a run of the whole text
#[test]
fn a_text_in_pieces_does_what_it_does_whole() {
    for text in TEXTS {
        let whole = run(&read(Dialect::Sinumerik, text.as_bytes()), &machine(), Limits::default());
        for lines in [1, 2, 3, 7, 100] {
            assert_same(&whole, &in_pieces(&machine(), text, lines), text);
        }
    }
}
