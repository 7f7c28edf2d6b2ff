//! A machine for part programs, and runs on it, for the tests of the program language.

mod mill;

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::{Shape, Solid};

/// T9 is the probe, T20 an end mill with radius 10 and length 80.
pub fn machine() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.tools.insert(20, mill::tool(&[1, 2]));
    setup
}

/// A block of 100 by 100 by 50 mm, the middle of its upper face at the zero of the machine.
pub fn block() -> Solid {
    Solid::new(Shape::Block { size: [100.0, 100.0, 50.0] }, Mcs::default())
}

/// What a program does on a machine.
pub fn go_on(setup: &Setup, text: &str) -> Outcome {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    run(&program, setup, Limits::default())
}

/// A run without any finding.
pub fn clean_on(setup: &Setup, text: &str) -> Outcome {
    let outcome = go_on(setup, text);
    assert_eq!(outcome.diagnostics, [], "{text}");
    assert_eq!(outcome.stop, None, "{text}");
    outcome
}
