//! A turning machine and calls for it, for the tests of its cycles.

#![allow(clippy::unwrap_used)]

use crate::catalogue::{Cycle, Dialect};
use crate::check::{Typed, check};
use crate::control::{Control, Edge, Plane, Tool, delivery};
use crate::diagnostic::{Code, Severity};

/// The control in G18 with mean value memory and the probe of the manual's examples in use (B:10695-10709): T9, type 580,
/// position 7.
pub fn lathe() -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.plane = Plane::G18;
    control.set("_CHBIT[4]", 1.0);
    let edge = Edge {
        kind: 580,
        tip: 7,
        length: [40.123, 100.456, 0.0],
        radius: 3.0,
        ..Edge::default()
    };
    let probe = Tool {
        name: "PROBE".into(),
        edges: [(1, edge)].into(),
    };
    control.tools.insert(9, probe);
    (control.tool, control.edge) = (9, 1);
    control
}

/// The worked example with some values changed.
pub fn call(cycle: &Cycle, changes: &[(&str, &str)]) -> Typed {
    let all = cycle.example.iter().chain(changes);
    all.map(|(name, value)| ((*name).to_owned(), (*value).to_owned()))
        .collect()
}

/// Everything that is found in a call on a changed turning machine; the last is the parameter, empty where there is none.
pub fn found(
    cycle: &'static Cycle,
    changes: &[(&str, &str)],
    prepare: impl Fn(&mut Control),
) -> Vec<(Severity, Code, &'static str)> {
    let mut control = lathe();
    prepare(&mut control);
    let found = check(cycle, &call(cycle, changes), &control).diagnostics;
    let short = found.into_iter();
    short
        .map(|one| (one.severity, one.code, one.param.unwrap_or_default()))
        .collect()
}
