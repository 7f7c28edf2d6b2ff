//! What must hold for any bytes whatever. A function panics when it does not.

use probewright_core::catalogue::Dialect;
use probewright_core::control::Plane;
use probewright_core::program::{calls::calls, change, read as parse};
use probewright_core::run::{Limits, Setup, run as simulate};
use probewright_core::workpiece::{PartErrors, Shape, Solid};

const DIALECTS: [Dialect; 2] = [Dialect::Sinumerik, Dialect::Nct];

/// Reading any bytes as a program, finding the calls and changing each of their values does not panic,
/// and the source stays as it is.
pub fn read(bytes: &[u8]) {
    for dialect in DIALECTS {
        let program = parse(dialect, bytes);
        assert_eq!(program.source, bytes);
        for site in calls(&program) {
            for param in site.cycle.params {
                let edits = change::change(&program, &site, param.name, "1");
                change::apply(bytes, &edits);
            }
        }
    }
}

/// Running any bytes as a program of either control against a block of material does not panic and ends within
/// the limits.
pub fn run(bytes: &[u8]) {
    let limits = Limits {
        steps: 500,
        depth: 4,
        trace: 500,
        ..Limits::default()
    };
    for dialect in DIALECTS {
        let mut setup = Setup::calibrated(dialect, Plane::G17);
        setup.workpiece.solids.push(block());
        let outcome = simulate(&parse(dialect, bytes), &setup, limits);
        assert!(outcome.trace.entries.len() <= limits.trace);
    }
}

fn block() -> Solid {
    Solid {
        shape: Shape::Block {
            size: [100.0, 100.0, 50.0],
        },
        at: [0.0; 3],
        rotation: [0.0; 3],
        errors: PartErrors::default(),
    }
}
