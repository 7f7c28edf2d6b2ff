//! Programs that never end, grow without bounds or ask for the impossible: they are stopped, with a message at the
//! place.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::control::{Plane, Value};
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::{Setup, Stop};
use probewright_core::message::Arg;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::position::Positions;
use probewright_core::syntax::read;
use probewright_core::workpiece::{Shape, Solid};

/// Entries of a trace, fewer than a run may have.
const TRACE: usize = 50_000;

/// A calibrated probe 20 mm above the middle of a block of 100 mm.
fn go(text: &str) -> Outcome {
    limited(text, Limits { trace: TRACE, own: TRACE, ..Limits::unwatched(text.lines().count()) })
}

fn limited(text: &str, limits: Limits) -> Outcome {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Block { size: [100.0; 3] }, Mcs::default()));
    setup.position = Mcs([0.0, 0.0, 20.0]);
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, limits)
}

/// Key of the message with which a run stopped; every text of it is short.
fn stopped(outcome: &Outcome) -> String {
    for finding in &outcome.diagnostics {
        for (_, arg) in &finding.message.args {
            assert!(!matches!(arg, Arg::Text(text) if text.len() > 500));
        }
    }
    match &outcome.stop {
        Some(Stop::Fault(message)) => message.key.to_string(),
        other => panic!("{other:?} {:?}", outcome.diagnostics),
    }
}

/// Line and column of the finding with this key.
fn place(text: &str, key: &str) -> (u32, u32) {
    let outcome = go(text);
    let found = outcome.diagnostics.iter().find(|f| f.message.key == key);
    let span = found.unwrap_or_else(|| panic!("{key}: {:?}", outcome.diagnostics)).span;
    Positions::new(text.as_bytes()).line_column(span.unwrap().start)
}

// oracle: hand (each of these would run for minutes, days or for ever, or fill the memory)
#[test]
fn what_never_ends_or_grows_is_stopped() {
    let many = "1+".repeat(40);
    let arrays: String = (0..3000).map(|i| format!("DEF REAL A{i}[10000]\n")).collect();
    let frames: String = (1..100).map(|i| format!("$P_UIFR[{i}]=CTRANS(X,1)\n")).collect();
    let text = "x".repeat(50_000);
    for (program, key) in [
        ("A: R1=R1+1\nGOTOB A".to_owned(), "run-steps"),
        ("WHILE 1\nENDWHILE".to_owned(), "run-endless"),
        ("LOOP\nENDLOOP".to_owned(), "run-endless"),
        ("REPEAT\nUNTIL 0".to_owned(), "run-endless"),
        ("FOR R1=0 TO 1EX300\nENDFOR".to_owned(), "run-steps"),
        (format!("A: R1={many}1\nGOTOB A"), "run-endless"),
        ("A: _EV[0]=REP(2)\nGOTOB A".to_owned(), "run-endless"),
        ("DEF REAL Q[1000]\nA: Q[0]=REP(3)\nGOTOB A".to_owned(), "run-endless"),
        (arrays, "run-steps"),
        (format!("{frames}A: R1=R1+1\n$P_UIFR[1]=CTRANS(X,R1)\nGOTOB A"), "run-steps"),
        (format!("A: MSG(\"{text}\")\nGOTOB A"), "run-endless"),
        (format!("A: ({text}\nGOTOB A"), "run-endless"),
        ("%_N_MAIN_MPF\nDEEP\nM30\n%_N_DEEP_SPF\nDEEP\nM17".to_owned(), "run-depth"),
        ("_TXT[0]=\"xxxxxxxxxx\"\nA: _TXT[0]=_TXT[0]<<_TXT[0]\nGOTOB A".to_owned(), "run-text-long"),
        ("G1 F100 X0 Y0 Z20\nA: G2 X0 Y0 I10 J0\nGOTOB A".to_owned(), "run-endless"),
        ("_NMSP=1EX9 _MVAR=100 _KNUM=0 _MA=3 _SETVAL=0 _FA=20 _TSA=19\nCYCLE978".to_owned(), "run-trace-limit"),
    ] {
        let outcome = go(&program);
        let shown: String = program.chars().take(60).collect();
        assert_eq!(stopped(&outcome), key, "{shown}");
        assert!(outcome.trace.entries.len() <= 2 * TRACE, "{shown}");
        assert!(outcome.control.data.iter().count() < 20_000, "{shown}");
    }
}

// oracle: hand: no count of blocks stops these, their memory does
#[test]
fn what_fills_the_memory_is_stopped() {
    let arrays: String = (0..30).map(|i| format!("DEF REAL A{i}[10000]\n")).collect();
    let parameters: Vec<String> = (0..30).map(|i| format!("REAL A{i}[10000]")).collect();
    let called = format!("UP\nM30\n%_N_UP_SPF\nPROC UP({})\nM17", parameters.join(","));
    let limits = Limits { data: 100_000, ..Limits::default() };
    for text in [
        arrays.clone(),
        arrays.replace("DEF", "DEF NCK"),
        called,
        "A: R1=R1+1\n$TC_DP1[R1,1]=120\nGOTOB A".to_owned(),
        "A: R1=R1+1\n$TC_DP1[1,R1]=120\nGOTOB A".to_owned(),
        "A: R1=R1+1\n$A_DBD[R1]=1\nGOTOB A".to_owned(),
    ] {
        let outcome = limited(&text, limits);
        assert_eq!(stopped(&outcome), "run-data", "{}", text.get(..60).unwrap_or(&text));
    }
    // variables that are made again and again take room once
    let again = "%_N_MAIN_MPF\nUP P100\nM30\n%_N_UP_SPF\nDEF REAL A[5000]\nM17";
    assert_eq!(limited(again, limits).stop, None);
}

// oracle: hand
#[test]
fn the_impossible_is_told_at_its_place() {
    for (program, key, at) in [
        ("R1=1\nDEF REAL A[1000000000]", "run-array-size", (2, 10)),
        ("DEF REAL A[10000,10000]", "run-array-size", (1, 10)),
        ("DEF REAL A[0]", "run-array-size", (1, 10)),
        ("DEF REAL A[-3]", "run-array-size", (1, 10)),
        ("R[1EX9]=5", "run-unknown-variable", (1, 1)),
        ("  R[-1]=5", "run-unknown-variable", (1, 3)),
        ("_SETV[99999]=1", "run-index", (1, 1)),
        ("_SETV[-1]=1", "run-index", (1, 1)),
        ("_WP[0]=1", "run-index", (1, 1)),
        ("N10 R1=_OVR[32]", "run-index", (1, 8)),
        ("R1=5/(3-3)", "run-division", (1, 7)),
        ("R1=1EX308*10\nG0 X=R1", "run-range", (1, 4)),
        ("GOTOF NOWHERE", "run-label", (1, 1)),
        ("ENDIF", "run-unmatched", (1, 1)),
        ("T=4711\nM6", "run-no-tool", (2, 1)),
    ] {
        assert_eq!(place(program, key), at, "{program}");
    }
}

// oracle: hand
#[test]
fn lists_go_on_through_arithmetic_parameters() {
    let outcome = go("R[3]=SET(5,,7)");
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    assert_eq!(outcome.control.data.get("R3"), Some(&Value::Number(5.0)));
    assert_eq!(outcome.control.data.get("R4"), None);
    assert_eq!(outcome.control.data.get("R5"), Some(&Value::Number(7.0)));
}

// oracle: hand: no tool is narrower than 0; a way to the end of all numbers is no way; what is no size makes no array
#[test]
fn numbers_out_of_all_proportion_are_told() {
    let tool = "$TC_DP1[20,1]=120 $TC_DP3[20,1]=80\n$TC_DP6[20,1]=0 $TC_DP15[20,1]=-0.01\nT20 D1 M6\nG0 X0\nM30";
    assert_eq!(go(tool).stop, None);
    for (program, key) in [
        ("G0 X=1EX300", "run-far"),
        ("G1 F100 X0 Y0 Z20\nG2 X10 Y0 I=1EX9 J0", "run-arc"),
        ("TRANS X=1EX200\nG0 X0", "run-far"),
        ("$TC_DP3[9,1]=1EX300\nG0 X0", "run-far"),
        ("DEF REAL A[1EX19,2,1EX-19]\nA=SET(1)", "run-array-size"),
    ] {
        assert_eq!(stopped(&go(program)), key, "{program}");
        let parsed = read(Dialect::Sinumerik, program.as_bytes());
        probewright_core::program::calls::calls(&parsed);
    }
}
