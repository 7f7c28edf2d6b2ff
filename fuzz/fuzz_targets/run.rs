//! Any bytes, run as a program of either control against a block of material: no panic, and an end within the limits.
#![no_main]

use libfuzzer_sys::fuzz_target;
use probewright_core::catalogue::Dialect;
use probewright_core::control::Plane;
use probewright_core::program::read;
use probewright_core::run::{Limits, Setup, run};
use probewright_core::workpiece::{PartErrors, Shape, Solid};

fuzz_target!(|bytes: &[u8]| {
    let limits = Limits {
        steps: 500,
        depth: 4,
        trace: 500,
    };
    let shape = Shape::Block {
        size: [100.0, 100.0, 50.0],
    };
    let solid = Solid {
        shape,
        at: [0.0; 3],
        rotation: [0.0; 3],
        errors: PartErrors::default(),
    };
    for dialect in [Dialect::Sinumerik, Dialect::Nct] {
        let mut setup = Setup::calibrated(dialect, Plane::G17);
        setup.workpiece.solids.push(solid.clone());
        let outcome = run(&read(dialect, bytes), &setup, limits);
        assert!(outcome.trace.entries.len() <= limits.trace);
    }
});
