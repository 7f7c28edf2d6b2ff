//! Jumps and loops, programs without an end, words that nothing is known of.

use super::running::machine;
use super::{go, near, number};
use probewright_core::dialect::Dialect;
use probewright_core::machine::Stop;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;

#[test]
fn flow_goes_its_way() {
    // oracle: hand
    let cases = [
        ("IF R2==0\nR1=1\nELSE\nR1=2\nENDIF", 1.0),
        ("IF R2<>0\nR1=1\nELSE\nR1=2\nENDIF", 2.0),
        ("IF 0\nIF 1\nR1=1\nENDIF\nR1=5\nELSE\nR1=R1+2\nENDIF\nR1=R1*10", 20.0),
        ("GOTOF ENDE\nR1=1\nENDE:\nR1=R1+2", 2.0),
        ("AGAIN: R1=R1+1\nIF R1<5 GOTOB AGAIN\nM2\nR1=99", 5.0),
        ("N10 R1=R1+1\nN20 IF R1<3 GOTOB N10\nN30 GOTOF \"LA\"<<\"ST\"\nR1=50\nLAST: R1=R1+1", 4.0),
        // a main block is named as it is written
        (":10 R1=R1+1\nIF R1<3 GOTOB :10\nGOTOF:0030\nR1=50\nN30 R1=R1+1", 4.0),
        ("N10 CASE R1 OF 0 GOTOF :20 DEFAULT GOTOF :30\n:20 R1=7\nM30\n:30 R1=8", 7.0),
        ("R1=1\n:20 R1=R1*3\nREPEATB :20 P=2", 27.0),
        ("WHILE R1<7\nR1=R1+2\nENDWHILE", 8.0),
        ("DEF INT I\nFOR I=1 TO 4\nR1=R1+I\nENDFOR", 10.0),
        ("DEF INT I\nFOR I=5 TO 4\nR1=R1+I\nENDFOR", 0.0),
        ("REPEAT\nR1=R1+1\nUNTIL R1>=3", 3.0),
        ("LOOP\nR1=R1+1\nIF R1==6 GOTOF OUT\nENDLOOP\nOUT: R2=0", 6.0),
        ("R3=9\nCASE R3 OF 7 GOTOF A1 9 GOTOF B1 DEFAULT GOTOF C1\nA1: R1=1\nM2\nB1: R1=2\nM2\nC1: R1=3", 2.0),
        ("R3=8\nCASE R3 OF 7 GOTOF A1 9 GOTOF B1 DEFAULT GOTOF C1\nA1: R1=1\nM2\nB1: R1=2\nM2\nC1: R1=3", 3.0),
        ("L10\nL10\nM30\n%_N_L10_SPF\nR1=R1+3\nM17", 6.0),
        ("/N10 R1=4", 4.0),
    ];
    for (text, value) in cases {
        assert_eq!(number(text, "R1"), value, "{text}");
    }
    for (text, key) in [("GOTOF AWAY", "run-label"), ("ENDIF", "run-unmatched"), ("WHILE 1", "run-unmatched")] {
        assert!(matches!(&go(text).stop, Some(Stop::Fault(message)) if message.key == key), "{text}");
    }
}

#[test]
fn endless_programs_are_stopped() {
    let cases = [
        ("A: GOTOB A", "run-endless"),
        ("LOOP\nENDLOOP", "run-endless"),
        ("DEF INT Q\nA: Q=Q+1\nGOTOB A", "run-steps"),
        ("%_N_MAIN_MPF\nSUB\n%_N_SUB_SPF\nSUB", "run-depth"),
        ("A: G0 X1\nG0 X2\nGOTOB A", "run-endless"),
        ("A: G0 X=IC(1)\nGOTOB A", "run-steps"),
    ];
    // motions that are not recorded any more go on
    let limits = Limits { steps: Some(5_000), depth: 11, trace: 1_000, ..Limits::default() };
    for (text, key) in cases {
        let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &machine(), limits);
        assert!(
            matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == key),
            "{text}: {:?}",
            outcome.stop
        );
        assert!(outcome.diagnostics.iter().any(|found| found.span.is_some()));
    }
}

#[test]
fn unknown_words_are_told() {
    let outcome = go("G0 X1 FROBNICATE\nG987\nQ5\nM77\nG0 Y2");
    let keys: Vec<_> = outcome.diagnostics.iter().map(|found| found.message.key.as_ref()).collect();
    assert_eq!(keys, ["run-subprogram", "run-unknown-word", "run-axes", "run-machine-function"]);
    near(outcome.end().0, [1.0, 2.0, 500.0]);
}
