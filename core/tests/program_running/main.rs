//! Running part programs: end positions, frames, tools, flow, measuring calls; and no text makes the run panic or hang.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod corners;
mod flow;
mod frames;
mod large;
mod lean;
mod measuring;
mod motion;
mod nct;
mod passed_over;
mod random;
#[path = "../running/mod.rs"]
mod running;
mod standard;
mod values;

use probewright_core::machine::Setup;
use probewright_core::run::Outcome;
use running::{block, clean_on, go_on, machine};

fn go(text: &str) -> Outcome {
    go_on(&machine(), text)
}

fn clean(text: &str) -> Outcome {
    clean_on(&machine(), text)
}

fn near(a: [f64; 3], b: [f64; 3]) {
    for i in 0..3 {
        assert!((a[i] - b[i]).abs() < 1e-9, "{a:?} is not {b:?}");
    }
}

/// The run reached its end, and all that is told is this list of words.
fn only_note(outcome: &Outcome, key: &str, listed: &str) {
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    let [note] = &outcome.diagnostics[..] else {
        panic!("{:?}", outcome.diagnostics);
    };
    assert_eq!((&*note.message.key, note.message.word("word")), (key, Some(listed)));
}

fn number(text: &str, name: &str) -> f64 {
    clean(text).control.number(name)
}

fn block_setup() -> Setup {
    let mut setup = machine();
    setup.workpiece.solids.push(block());
    setup
}
