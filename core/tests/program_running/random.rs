//! No text makes a run panic or hang.

use super::block_setup;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;
use proptest::prelude::*;

/// Pieces of programs, put together at random: far more of them run deep than of random bytes.
fn piece() -> impl Strategy<Value = String> {
    let words = [
        "G0 X10", "G1 Z-5 F100", "G2 X1 Y1 I3", "G54", "G500", "G18", "T9 D1", "M6", "T20 M6", "D0", "R1=R1+1",
        "R2=R1/R3", "IF R1>2", "ELSE", "ENDIF", "WHILE R1<3", "ENDWHILE", "FOR R1=1 TO 5", "ENDFOR", "REPEAT",
        "UNTIL R1>4", "LOOP", "ENDLOOP", "GOTOB A", "GOTOF A", "A:", "CYCLE977", "CYCLE978", "_MVAR=1", "_MVAR=101",
        "_SETVAL=20", "_KNUM=2001", "_KNUM=1", "_TNUM=20", "_MA=1", "_FA=1EX9", "_ID=-5", "TRANS X5", "AROT Z45",
        "DEF REAL B[3]", "B=SET(1,2,3)", "R4=B[R1]", "MSG(\"A\"<<R1)", "X=IC(R1)", "$P_UIFR[1]=CTRANS(X,R1)",
        "MEAS=1 G1 Z-20", "G91", "G70", "L1", "%_N_L1_SPF", "M17", "G101 X1", "G110 D50 S6", "#1=#2/#3", "G43 H98",
        "H1", "M2", "_NMSP=1EX12", "_PRNUM=101", "R1=-1EX308*10", "_EVNUM=9999", "_VMS=-1",
    ];
    prop::sample::select(words.to_vec()).prop_map(str::to_owned)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_program_ends_without_panic(lines in prop::collection::vec(prop::collection::vec(piece(), 1..4), 0..25),
    nct: bool) {
        let text: Vec<String> = lines.into_iter().map(|words| words.join(" ")).collect();
        let dialect = if nct { Dialect::Nct } else { Dialect::Sinumerik };
        let mut start = block_setup();
        if nct {
            start.control = Setup::calibrated(dialect, Plane::G17).control;
        }
        let limits = Limits { steps: Some(300), depth: 4, trace: 250, own: 250, ..Limits::default() };
        let outcome = run(&read(dialect, text.join("\n").as_bytes()), &start, limits);
        prop_assert!(outcome.trace.entries.len() <= limits.trace + limits.own);
        prop_assert!(outcome.position.iter().all(|value| value.is_finite()));
    }

    #[test]
    fn any_bytes_end_without_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), nct: bool) {
        let dialect = if nct { Dialect::Nct } else { Dialect::Sinumerik };
        let limits = Limits { steps: Some(300), depth: 4, trace: 250, own: 250, ..Limits::default() };
        let outcome = run(&read(dialect, &bytes), &Setup::calibrated(dialect, Plane::G17), limits);
        prop_assert!(outcome.trace.entries.len() <= limits.trace + limits.own);
    }
}
