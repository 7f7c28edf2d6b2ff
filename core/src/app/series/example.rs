//! A series to begin with: the mean value of the manual's table 1-2.

use crate::control::Plane;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::machine::series::{Mode, Per, Series, Shape, Vary};
use crate::workpiece::{self, Solid};
use std::collections::BTreeMap;

/// Differences of the table, mm (B:1265-1284).
const DIFFERENCES: [f64; 10] = [0.03, 0.05, 0.06, 0.02, 0.04, 0.05, 0.05, 0.03, 0.07, 0.07];

/// A hole of 50 mm with the differences of the table, measured with weight 3 for one tool and with 1 for another:
/// `_TZL` is that of the table (B:1265), the wider limits let all its differences go into the mean value.
pub const PROGRAM: &str = "\
G17 G54 G90 T9 D1 M6
G0 X0 Y0
Z-10
_CHBIT[4]=1 _PRNUM=1 _FA=2 _TSA=1 _VMS=0 _NMSP=1
_TUL=0.1 _TLL=-0.1 _TDIF=0.3 _TMV=0.08 _TZL=0.04
_MVAR=1 _SETVAL=50 _KNUM=2001
_K=3 _EVNUM=1 _TNUM=20
CYCLE977
_K=1 _EVNUM=2 _TNUM=21
CYCLE977
M30
";

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
