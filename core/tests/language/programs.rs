//! Whole programs of the language, `programs/*.mpf`, each with what it does behind it: the positions that its blocks
//! reach, `;= X Y Z` and A where it turns, or the key of the fault that stops it, `;! run-arc`. They use what programs
//! use that were written for another interpreter, with the values of its examples.

use super::{near, setup};
use probewright_core::control::{Tool, Value};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Stop;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use std::path::Path;

/// What the programs together use, as it stands in a block without blanks; a line a subject: numbers and words, names
/// and texts, arrays, arithmetic, truth, flow, motions, frames and tools.
const CONSTRUCTS: &str = r#"
X1.5 Y-2. C=90. B=-1.5 x100 N20 F=( S8000 M103M2M3M4M5 X1X=3
DEFREAL DEFINT DEFSTRING[28] ="" R0=0 DEFINTbb,aa=12 lIFT Lift
DEFREALGAPS[4,3]=SET(5,,,9 GRID[2,3,4]=REP(1,24) GRID[I1,I2,I3]= ACC[E]=50 ACC[WHICH] ACC[4]
1+1-1+-1 2*-3 -2/3 7DIV3 7MOD4.1 7DIV0.4 5DIVR1 (2+3)*4 SIN(30) COS(60) TAN(45) ASIN(0.5) ACOS(0.5) ATAN2(30.5,80.1)
SQRT(POT(3)+POT(4)) IFTRUE IFyes == >= <= AND OR XOR IFNOT 6B_AND3 R11=SPEED>=100
ELSE ENDIF WHILE ENDWHILE FORI1=0TO1 ENDFOR REPEAT UNTIL GOTOF90 GOTOBAGAIN GOTODONE GOTOCNOWHERE GOTOFN100
CASE(4+3)OF7GOTOFSEVENTH DEFAULTGOTOF PART_IS_NEW M30 M2
IC(2/3) E=IC( G2X100Y0I50J0 Z10I0J25K5 CR=60 BSPLINESD=2 PW=0.5 ASPLINEBNATETAN CSPLINEPL=1
TRANSX100Y20 ATRANSX50 ROT TRANSX=AWAY $AA_IW[Z] $AA_IM[Z] T="BALL_MILL_8MM"M6
"#;

/// Name and text of every program.
fn programs() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/language/programs");
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    paths.map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap())).collect()
}

/// Starts at X1600 Y900 Z0, with a rotary axis A and nothing in the spindle.
fn go(text: &str) -> Outcome {
    let mut setup = setup();
    setup.position = Mcs([1600.0, 900.0, 0.0]);
    let control = &mut setup.control;
    (control.tool, control.edge) = (0, 0);
    let axis = Value::Text("A".into());
    control.data.insert("MD20080[3]".into(), axis);
    let mill = Tool { name: "BALL_MILL_8MM".into(), edges: [(1, Default::default())].into() };
    control.tools.insert(8, mill);
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

/// Positions of X Y Z A at the ends of the motions of a run, as they follow each other.
fn positions(outcome: &Outcome) -> Vec<[f64; 4]> {
    let mut now = [1600.0, 900.0, 0.0, 0.0];
    let mut all = Vec::new();
    for entry in &outcome.trace.entries {
        match entry.step {
            Step::Motion { to, .. } => now = [to[0], to[1], to[2], now[3]],
            Step::Table { to, .. } => now[3] = to.0,
            _ => continue,
        }
        all.push(now);
    }
    all.dedup_by(|a, b| a.iter().zip(b.iter()).all(|(a, b)| (a - b).abs() < 1e-9));
    all
}

/// The positions that stand behind a program.
fn expected(text: &str) -> Vec<[f64; 4]> {
    let lines = text.lines().filter_map(|line| line.strip_prefix(";= "));
    let position = |line: &str| {
        let mut axes = [0.0; 4];
        axes.iter_mut().zip(line.split(' ')).for_each(|(axis, number)| *axis = number.parse().unwrap());
        axes
    };
    lines.map(position).collect()
}

// oracle: hand; and peer: another interpreter gives the same for programs of the same constructs and values
#[test]
fn programs_go_their_way() {
    let programs = programs();
    assert_eq!(programs.len(), 31);
    for (name, text) in programs {
        let outcome = go(&text);
        if let Some((_, key)) = text.split_once(";! ") {
            let stopped = matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == key.trim());
            assert!(stopped, "{name}: {:?}", outcome.stop);
            continue;
        }
        assert_eq!(outcome.stop, None, "{name}: {:?}", outcome.diagnostics);
        let (found, expected) = (positions(&outcome), expected(&text));
        let close = |(a, b): (&[f64; 4], &[f64; 4])| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.000_051);
        let same = found.len() == expected.len() && found.iter().zip(&expected).all(close);
        assert!(same, "{name}: {found:?} instead of {expected:?}");
    }
    assert_eq!(go("T=\"BALL_MILL_8MM\" M6").control.tool, 8);
}

// oracle: self (the list above is what the programs are there for)
#[test]
fn every_construct_stands_in_a_program() {
    let blocks = |text: &str| -> String {
        text.lines().map(|line| line.split(';').next().unwrap_or_default().replace(' ', "") + "\n").collect()
    };
    let all: String = programs().iter().map(|(_, text)| blocks(text)).collect();
    let missing: Vec<&str> = CONSTRUCTS.split_whitespace().filter(|one| !all.contains(one)).collect();
    assert_eq!(missing, Vec::<&str>::new());
}

/// Short programs: text and the positions X Y Z of its blocks that move, calculated by hand.
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
        let outcome = go(text);
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
