//! The program language: what each word does, a file a subject. Facts about the language are those of the programming guide
//! of these controls ("Job planning", 03/2006), where a comment names it; everything else is reckoned by hand.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod corpus;
mod flow;
mod frames;
mod motion;
mod properties;
mod subprograms;
mod values;
mod words;

use probewright_core::catalogue::Dialect;
use probewright_core::control::{Edge, Plane, Tool};
use probewright_core::program::read;
use probewright_core::run::trace::Step;
use probewright_core::run::{Limits, Outcome, Setup, Stop, run};

/// T9 is the probe, T20 an end mill with radius 10 and length 80; the machine stands at its zero.
fn setup() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let mill = Edge {
        kind: 120,
        length: [80.0, 0.0, 0.0],
        radius: 10.0,
        ..Edge::default()
    };
    let tool = Tool {
        name: "MILL".into(),
        edges: [(1, mill.clone()), (2, mill)].into(),
    };
    setup.control.tools.insert(20, tool);
    setup.position = [0.0; 3];
    setup
}

fn go(text: &str) -> Outcome {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    run(&program, &setup(), Limits::default())
}

/// A run without any finding.
fn clean(text: &str) -> Outcome {
    let outcome = go(text);
    assert_eq!(outcome.diagnostics, [], "{text}");
    assert_eq!(outcome.stop, None, "{text}");
    outcome
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
    let steps = outcome.trace.entries.into_iter().map(|entry| entry.step);
    steps
        .filter_map(|step| match step {
            Step::Message(text) => Some(text),
            _ => None,
        })
        .collect()
}

/// Where the machine stands at the end of a clean run, machine coordinates.
fn end(text: &str) -> [f64; 3] {
    clean(text).position
}

fn at(text: &str, expected: [f64; 3]) {
    let found = end(text);
    for i in 0..3 {
        near(found[i], expected[i], text);
    }
}

fn near(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() <= 1e-9 * expected.abs().max(1.0),
        "{what}: {found} is not {expected}"
    );
}
