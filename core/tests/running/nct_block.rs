//! The part under an NCT probe in tests of its language.

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Wcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

/// A block of 60 x 60 x 20 under NCT, its upper face at 0, the ball 20 mm above its middle.
pub fn over_a_block() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    let size = [60.0, 60.0, 20.0];
    setup.workpiece.solids.push(Solid::new(Shape::Block { size }, setup.control.to_machine(Wcs([0.0; 3]))));
    setup.position = setup.control.to_machine(Wcs([0.0, 0.0, 20.0]));
    setup
}
