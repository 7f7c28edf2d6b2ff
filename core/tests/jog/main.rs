//! Measuring in JOG: masks against the tables of the manual, printed and worked figures, every row of the states, the
//! alarms, and the machine under the hand.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod alarms;
mod as_program;
mod hand;
mod hostile;
mod loops;
mod messages;
mod older;
mod on_the_machine;
mod practice;
mod printed;
mod settings;
mod states;
mod tables;
mod worked;

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::jog::{Input, Session};
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

/// Text of a table of the project.
macro_rules! data {
    ($name:literal) => {
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/", $name))
    };
}
use data;

fn near(found: f64, wanted: f64, what: &str) {
    assert!((found - wanted).abs() < 1e-9, "{what}: {found}, expected {wanted}");
}

/// A calibrated milling machine with this part; G54 to G57 are empty.
fn machine(shape: Shape, at: [f64; 3]) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(shape, Mcs(at)));
    setup
}

/// Opens a mask and enters values.
fn open(session: &mut Session, mask: &str, values: &[(&str, &str)]) {
    session.press(Input::Function(mask)).unwrap();
    for (name, value) in values {
        session.press(Input::Field(name, value)).unwrap_or_else(|why| panic!("{mask} {name}: {why:?}"));
    }
}

/// A block with its upper face at Z 0 and its lower left corner at X 0, Y 0.
fn block() -> Setup {
    machine(Shape::Block { size: [100.0, 80.0, 40.0] }, [50.0, 40.0, 0.0])
}

/// Puts the probe somewhere in the machine.
fn stand(session: &mut Session, at: [f64; 3]) {
    session.sim.position = Mcs(at);
}
