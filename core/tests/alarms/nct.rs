//! Cases of the NCT macros: a bore of 50 mm about the zero, the ball in it 10 mm deep.

use super::table::{Case, Table};
use probewright_core::catalogue::{Dialect, nct};
use probewright_core::control::Plane;
use probewright_core::diagnostic::Code;
use probewright_core::run::Setup;
use probewright_core::workpiece::{PartErrors, Shape, Solid};

const PROGRAM: &str = "G17 G90 G54\n{change}\nM30\n";

pub fn g101() -> Table {
    Table {
        program: PROGRAM,
        usual: "G101 X10",
        setup,
        cases: vec![
            case(nct::NO_TOOL_LENGTH, "G101 X10", |setup| {
                setup.control.edge = 0;
            }),
            case(nct::STYLUS_IN_CONTACT, "G101 X10", pressed),
            case(nct::PATH_OBSTRUCTED, "G101 X40", |_| ()),
            case(nct::FALSE_TRIGGER, "G101 X10", false_signal),
            case(nct::OUT_OF_POSITION, "G101 X10", |setup| {
                setup.control.limits.plus[0] = Some(5.0);
            }),
        ],
        unreached: Vec::new(),
    }
}

pub fn g110() -> Table {
    Table {
        program: PROGRAM,
        usual: "G110 D50",
        setup,
        cases: vec![
            case(nct::FORMAT_ERROR, "G110 S1", |_| ()),
            case(nct::NO_TOOL_LENGTH, "G110 D50", |setup| {
                setup.control.edge = 0;
            }),
            case(nct::STYLUS_IN_CONTACT, "G110 D50", pressed),
            case(nct::PROBE_FAIL, "G110 D50", |setup| {
                setup.workpiece.solids.clear();
            }),
            case(nct::NO_MOVEMENT, "G110 D6", |_| ()),
            case(nct::FALSE_TRIGGER, "G110 D50", false_signal),
            case(nct::OUT_OF_POSITION, "G110 D50", |setup| {
                setup.control.set(nct::POSITION_LOST, 1.0);
            }),
            // a boss that is so large that the way down beside its nominal wall ends on it
            case(nct::PATH_OBSTRUCTED, "G110 D50 Z-10", |setup| {
                setup.workpiece.solids[0].shape = Shape::Shaft {
                    diameter: 70.0,
                    height: 40.0,
                };
                setup.position[2] = 10.0;
            }),
            case(nct::OUT_OF_TOLERANCE, "G110 D50 H0.5", grown),
            case(nct::UPPER_TOLERANCE, "G110 D50 S1 U0.5", grown),
            case(nct::TOOL_TOO_LARGE, "G110 D50 T1", |setup| {
                grown(setup);
                setup.control.register_mut(1).radius = 24.9;
            }),
        ],
        unreached: Vec::new(),
    }
}

fn case(code: Code, change: &'static str, prepare: fn(&mut Setup)) -> Case {
    Case {
        code,
        change,
        prepare,
    }
}

fn setup() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    setup.position = [0.0, 0.0, -10.0];
    setup.workpiece.solids = vec![Solid {
        shape: Shape::Hole {
            diameter: 50.0,
            depth: 30.0,
        },
        at: [0.0; 3],
        rotation: [0.0; 3],
        errors: PartErrors::default(),
    }];
    setup
}

/// The stylus stands 1 mm deep in the wall.
fn pressed(setup: &mut Setup) {
    setup.position[0] = 23.0;
}

/// A signal without contact after 5 mm of watched way.
fn false_signal(setup: &mut Setup) {
    setup.probe.false_signal = Some(5.0);
}

/// The bore is larger by 0.6 mm.
fn grown(setup: &mut Setup) {
    setup.workpiece.solids[0].errors.size = 0.6;
}
