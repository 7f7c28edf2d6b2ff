//! The program language: what each word does, a file a subject. Facts about the language are those of the programming
//! guide of these controls ("Job planning", 03/2006), where a comment names it; everything else is calculated by hand.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod contour;
mod contour_properties;
mod flow;
mod frames;
mod motion;
mod of_machine;
mod of_shops;
mod polar;
mod programs;
mod properties;
#[path = "../running/mod.rs"]
mod running;
mod subprograms;
#[path = "../running/turning.rs"]
mod turning;
mod values;
mod words;

use probewright_core::geometry::Mcs;
use probewright_core::machine::trace::Step;
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::Outcome;
use running::{clean_on, go_on, machine};

/// The machine of these tests at its zero.
fn setup() -> Setup {
    let mut setup = machine();
    setup.position = Mcs([0.0; 3]);
    setup
}

fn go(text: &str) -> Outcome {
    go_on(&setup(), text)
}

/// A run without any finding.
fn clean(text: &str) -> Outcome {
    clean_on(&setup(), text)
}

/// Key of the fault that stops a program.
fn fault(text: &str) -> String {
    match go(text).stop {
        Some(Stop::Fault(message)) => message.key.to_string(),
        other => panic!("{text}: {other:?}"),
    }
}

/// Keys of all findings.
fn findings(text: &str) -> Vec<String> {
    let outcome = go(text);
    let keys = outcome.diagnostics.iter();
    keys.map(|found| found.message.key.to_string()).collect()
}

/// Value of an R parameter at the end of a clean run.
fn number(text: &str, name: &str) -> f64 {
    clean(text).control.number(name)
}

/// Texts of `MSG`, in order.
fn messages(text: &str) -> Vec<String> {
    let outcome = clean(text);
    let steps = outcome.trace.entries.iter().map(|entry| entry.step);
    steps
        .filter_map(|step| match step {
            Step::Message { text, .. } => Some(text),
            _ => None,
        })
        .collect()
}

/// Where the machine stands at the end of a clean run, machine coordinates.
fn end(text: &str) -> [f64; 3] {
    clean(text).position.0
}

/// Feed of the last motion of a clean run, mm/min.
fn feed(text: &str) -> f64 {
    let outcome = clean(text);
    let entries = outcome.trace.entries.iter().rev();
    let mut feeds = entries.filter_map(|entry| match entry.step {
        Step::Motion { feed, .. } => Some(feed),
        _ => None,
    });
    feeds.next().expect("a motion")
}

fn at(text: &str, expected: [f64; 3]) {
    let found = end(text);
    for i in 0..3 {
        near(found[i], expected[i], text);
    }
}

fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{what}: {found} is not {expected}");
}
