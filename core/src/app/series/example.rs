//! A series to begin with: the mean value of the manual's table 1-2.

pub use crate::catalogue::mean_value::PROGRAM;
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::machine::series::{Mode, Per, Series, Shape, Vary};
use crate::workpiece::{self, Solid};
use std::collections::BTreeMap;

/// Differences of the table, mm (B:1265-1284).
const DIFFERENCES: [f64; 10] = [0.03, 0.05, 0.06, 0.02, 0.04, 0.05, 0.05, 0.03, 0.07, 0.07];

/// The machine on which it runs.
pub fn machine() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(workpiece::Shape::Hole { diameter: 50.0, depth: 30.0 }, Mcs([0.0; 3])));
    for tool in [20, 21] {
        setup.control.edge_made(tool, 1).kind = 120;
    }
    setup
}

/// What varies.
pub fn series() -> Series {
    let size = Vary {
        what: "workpiece[0].errors.size".into(),
        shape: Shape::Normal,
        sigma: 0.0,
        half: 0.0,
        mean: 0.0,
        drift: 0.0,
        per: Per::Part,
        values: DIFFERENCES.into(),
        follows: BTreeMap::new(),
    };
    Series { runs: DIFFERENCES.len() as u32, seed: 1, mode: Mode::Production, vary: vec![size] }
}
