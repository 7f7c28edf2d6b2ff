//! Cases that the workpiece cycles of a turning machine share: its probe, the coordinate system, the measuring axis.

use super::table::{Case, program};
use super::{turning, workpiece};
use probewright_core::control::Plane;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

/// Alarms that no state of the simulated machine brings about, beside [`workpiece::UNREACHED`].
pub const SPINDLE: (u32, &str) = (61373, "a mono probe in a turret is not turned by a spindle (A:15917)");

pub const NOT_TURNED: (u32, &str) = (61372, "the cycle turns neither part nor probe (A:15916)");

/// A turned part of 60 mm with its face at Z20, the probe at this position; T20 is to be corrected.
pub fn setup(position: [f64; 3]) -> Setup {
    let mut setup = Setup::turning(Plane::G18);
    setup.control.tools.insert(20, turning::tool(0.0));
    setup.position = Mcs(position);
    setup.workpiece.solids =
        vec![Solid::new(Shape::Turned { diameter: 60.0, length: 80.0, bore: [0.0; 2] }, Mcs([0.0, 0.0, 20.0]))];
    setup
}

/// The cases of every workpiece cycle of turning.
pub fn cases() -> Vec<Case> {
    let mut cases = workpiece::everywhere();
    cases.extend([
        program(61309, "$TC_DP1[9,1]=710"),
        program(61315, "$TC_DP2[9,1]=3"),
        program(61325, "_MA=4"),
        program(61330, "ROT Y10"),
    ]);
    cases
}
