//! Cases of G65 P9920: a disk of 40 mm, the reference tool of 20 by 100 mm 4 mm above its centre.

use super::table::{Table, case_of};
use probewright_core::catalogue::p9920::{DEPRESSED, INCORRECT, MEASURING_DEVICE, P9920, TOO_SMALL};
use probewright_core::control::{Edge, Plane};
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::tool_probe::ToolProbe;
use probewright_core::workpiece::{Shape, Solid};

const CALIBRATE: &str = "G65 P9920 Z-8 D20 H100 T0";

pub fn table() -> Table {
    Table {
        program: "G17 G90 G54\n{change}\nM30\n",
        usual: CALIBRATE,
        setup,
        cases: vec![
            case_of(MEASURING_DEVICE, CALIBRATE, |setup| {
                setup.control.set("#1003", 0.0);
            }),
            case_of(DEPRESSED, CALIBRATE, |setup| {
                setup.control.set("#1002", 1.0);
            }),
            case_of(TOO_SMALL, "G65 P9920 Z-8 D10 H100 T0", |_| ()),
            case_of(INCORRECT, "G65 P9920 Z-3 D20 H100 T0", |_| ()),
        ],
        unreached: Vec::new(),
    }
}

fn setup() -> Setup {
    let mut setup = Setup::for_cycle(&P9920, Plane::G17);
    let register = setup.control.edge;
    *setup.control.edge_made(0, register) = Edge { length: [100.0, 0.0, 0.0], radius: 10.0, ..Edge::default() };
    let disk = Solid::new(Shape::Turned { diameter: 40.0, length: 15.0, bore: [0.0; 2] }, Mcs::default());
    setup.tool_probes.push(ToolProbe::ideal(disk));
    setup.position = Mcs([0.0, 0.0, 4.0]);
    setup
}
