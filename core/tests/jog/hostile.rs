//! Whatever is written into a script or a datum: no panic, an end, and a refused line changes nothing.

use super::block;
use probewright_core::app::{JogWrong, jog};
use probewright_core::jog::{Session, masks};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

const NUMBERS: [&str; 10] = ["0", "-1", "0.001", "7", "-20", "50", "1e6", "-1e6", "1e-300", "nan"];
const DATA: [&str; 16] = [
    "_JM_I[0]", "_JM_I[1]", "_JM_I[2]", "_JM_I[3]", "_JM_I[4]", "_JM_I[5]", "_JM_B[1]", "_JM_B[3]", "E_MESS_D_M",
    "E_MESS_FM", "E_MESS_MT_DL[0]", "E_MESS_MT_DR[0]", "E_MESS_MT_DIR[0]", "E_MESS_MT_AX[0]", "E_MESS_MIN_D",
    "_WP[0,0]",
];

fn number() -> impl Strategy<Value = &'static str> {
    prop::sample::select(NUMBERS.to_vec())
}

/// A line that may be anything that can be written.
fn line() -> impl Strategy<Value = String> {
    let names: Vec<&str> = masks::all().map(|mask| mask.name).collect();
    let fields: Vec<&str> = masks::all().flat_map(|mask| mask.fields).map(|field| field.name).collect();
    let words = ["G54", "none", "X", "Y", "Z", "+", "-", "yes", "no", "rotation", "C", "inside", "3", "$P_SETFR"];
    let alone = ["start", "start", "start", "calculate", "activate", "<<", "reset", "mode", "start reset", "plc P1 on"];
    let moves = ["move", "jog", "move machine"];
    prop_oneof![
        3 => prop::sample::select(names).prop_map(|name| format!("mask {name}")),
        3 => (prop::sample::select(fields.clone()), number()).prop_map(|(name, value)| format!("{name} = {value}")),
        3 => (prop::sample::select(fields), prop::sample::select(words.to_vec()))
            .prop_map(|(name, value)| format!("{name} = {value}")),
        4 => (prop::sample::select(moves.to_vec()), prop::sample::select(vec!["X", "Y", "Z"]), number())
            .prop_map(|(word, axis, value)| format!("{word} {axis}{value}")),
        8 => prop::sample::select(alone.to_vec()).prop_map(str::to_owned),
        1 => (0..6_usize).prop_map(|number| format!("reject P{number}")),
        1 => (0..6_usize).prop_map(|number| format!("store P{number}")),
        2 => (prop::sample::select(DATA.to_vec()), number()).prop_map(|(name, value)| format!("set {name} = {value}")),
        1 => (0..12_i64, 0..3_i64).prop_map(|(tool, edge)| format!("tool T{tool} D{edge}")),
    ]
}

proptest! {
    #![proptest_config(Config { rng_seed: RngSeed::Fixed(4), failure_persistence: None, ..Config::with_cases(60) })]

    // oracle: self
    #[test]
    fn no_script_breaks_anything(lines in prop::collection::vec(line(), 1..40), seed in any::<Option<u64>>()) {
        // line by line, so that a refused one does not end it
        let mut done = Vec::new();
        for line in lines {
            done.push(line);
            match jog(&done.join("\n"), &block(), seed) {
                Err(JogWrong::Line(wrong)) => {
                    prop_assert_eq!(wrong.line as usize, done.len());
                    done.pop();
                }
                Err(other) => prop_assert!(false, "{:?}", other),
                Ok(view) => {
                    prop_assert_eq!(view.lines.len(), done.len());
                    if view.lines.last().is_some_and(|line| line.refused.is_some()) {
                        done.pop();
                    }
                }
            }
        }
    }

    // oracle: self
    #[test]
    fn no_text_breaks_the_reader(text in ".*") {
        let read = jog(&text, &block(), None);
        prop_assert!(matches!(read, Ok(_) | Err(JogWrong::Line(_))));
    }
}

// oracle: hand: a control that has no measuring in JOG says so
#[test]
fn another_control_has_no_jog() {
    let setup = probewright_core::machine::Setup::calibrated(
        probewright_core::dialect::Dialect::Nct,
        probewright_core::control::Plane::G17,
    );
    assert!(matches!(jog("start", &setup, None), Err(JogWrong::Machine(_))));
    assert!(Session::new(&setup).mask().is_none());
}
