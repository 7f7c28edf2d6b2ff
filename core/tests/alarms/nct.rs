//! Cases of the NCT macros: a bore of 50 mm about the zero, the ball in it 10 mm deep.

use super::table::{Case, Table, case_of};
use probewright_core::catalogue::nct;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

const PROGRAM: &str = "G17 G90 G54\n{change}\nM30\n";

pub fn g101() -> Table {
    Table {
        program: PROGRAM,
        usual: "G101 X10",
        setup,
        cases: vec![
            case_of(nct::NO_TOOL_LENGTH, "G101 X10", |setup| {
                setup.control.edge = 0;
            }),
            case_of(nct::STYLUS_IN_CONTACT, "G101 X10", pressed),
            case_of(nct::PATH_OBSTRUCTED, "G101 X40", |_| ()),
            case_of(nct::FALSE_TRIGGER, "G101 X10", false_signal),
            case_of(nct::OUT_OF_POSITION, "G101 X10", |setup| {
                setup.control.limits.plus[0] = Some(5.0);
            }),
        ],
        unreached: Vec::new(),
    }
}

pub fn g102() -> Table {
    in_bore("G102 D50", "G102", "G102 D6")
}

pub fn g103() -> Table {
    in_bore("G103 D50", "G103", "G103 D6")
}

pub fn g104() -> Table {
    Table {
        program: PROGRAM,
        usual: "G104 Z0 T98",
        setup: above,
        cases: measuring("G104 Z0 T98", "G104 Z0", "G104 Z90 T98", sunk),
        unreached: Vec::new(),
    }
}

pub fn g105() -> Table {
    let mut table = in_bore("G105 X25", "G105 S1", "G105 X1 Q1");
    table.cases.extend([
        // on the way to the clearance beside the wall the bore ends
        case_of(nct::PATH_OBSTRUCTED, "G105 X-60 Z-20", |_| ()),
        case_of(nct::OUT_OF_TOLERANCE, "G105 X25 H0.2", grown),
        case_of(nct::UPPER_TOLERANCE, "G105 X25 S1 U0.2", grown),
    ]);
    table
}

pub fn g106() -> Table {
    let mut cases = measuring("G106 Z0", "G106 S1", "G106 Z60", sunk);
    cases.extend([
        case_of(nct::OUT_OF_TOLERANCE, "G106 Z0.6 H0.5", |_| ()),
        case_of(nct::UPPER_TOLERANCE, "G106 Z0.6 S1 U0.5", |_| ()),
    ]);
    Table { usual: "G106 Z0", cases, ..g104() }
}

pub fn g107() -> Table {
    in_bore("G107 X25 Y25", "G107 X25", "G107 X0 Y25")
}

pub fn g108() -> Table {
    let cases = measuring("G108 X-20 Y-20", "G108 X-20", "G108 X-40 Y-20", |setup| {
        setup.position = Mcs([-21.0, 0.0, -10.0]);
    });
    let mut table = Table {
        usual: "G108 X-20 Y-20",
        setup: || {
            let mut setup = setup();
            setup.workpiece.solids[0].shape = Shape::Island { length: [40.0, 40.0], height: 30.0 };
            setup.position = Mcs([-40.0, -40.0, -10.0]);
            setup
        },
        cases,
        ..in_bore("", "", "")
    };
    // the stylus starts before the second wall, not before the corner
    table.cases.push(case_of(nct::PATH_OBSTRUCTED, "G108 X-20 Y-20", |setup| {
        setup.position = Mcs([0.0, -40.0, -10.0]);
    }));
    table
}

pub fn g109() -> Table {
    let mut table = in_bore("G109 X50", "G109 S1", "G109 X6");
    table.cases.extend([
        case_of(nct::PATH_OBSTRUCTED, "G109 X50 Z-10", too_large_a_boss),
        case_of(nct::OUT_OF_TOLERANCE, "G109 X50 H0.5", grown),
        case_of(nct::UPPER_TOLERANCE, "G109 X50 S1 U0.5", grown),
        case_of(nct::TOOL_TOO_LARGE, "G109 X50 T1", thick_tool),
    ]);
    table
}

pub fn g110() -> Table {
    let mut table = in_bore("G110 D50", "G110 S1", "G110 D6");
    table.cases.extend([
        case_of(nct::PATH_OBSTRUCTED, "G110 D50 Z-10", too_large_a_boss),
        case_of(nct::OUT_OF_TOLERANCE, "G110 D50 H0.5", grown),
        case_of(nct::UPPER_TOLERANCE, "G110 D50 S1 U0.5", grown),
        case_of(nct::TOOL_TOO_LARGE, "G110 D50 T1", thick_tool),
    ]);
    table
}

/// Over a block whose upper face lies 20 mm deep; the roof is a second one above the ball.
pub fn p9969() -> Table {
    const USUAL: &str = "G65 P9969 X30 Y4 Z-24 J2 R2 Q1";
    let roof = |setup: &mut Setup| {
        let roof = Solid {
            at: Mcs([0.0, -52.0, 0.0]), // beside the stylus, above the ball
            ..setup.workpiece.solids[0].clone()
        };
        setup.workpiece.solids.push(roof);
        setup.position = Mcs([0.0, 0.0, -16.0]);
    };
    Table {
        program: PROGRAM,
        usual: USUAL,
        setup: || {
            let mut setup = setup();
            setup.workpiece.solids[0] = Solid::new(Shape::Block { size: [100.0, 100.0, 8.0] }, Mcs([0.0, 0.0, -20.0]));
            setup
        },
        cases: vec![
            case_of(nct::FORMAT_ERROR, "G65 P9969 X30 Y4 Z-24 J2 Q1", |_| ()),
            case_of(nct::NO_TOOL_LENGTH, USUAL, |setup| setup.control.edge = 0),
            case_of(nct::OUT_OF_POSITION, USUAL, |setup| {
                setup.control.limits.plus[0] = Some(5.0);
            }),
            case_of(nct::STYLUS_IN_CONTACT, USUAL, |setup| {
                setup.position = Mcs([0.0, 0.0, -21.0]);
            }),
            case_of(nct::SCANNING_OBSTRUCTED, "G65 P9969 X30 Y4 Z-24 J2 R2 Q9", roof),
            case_of(nct::SCANNING_FAIL, USUAL, |setup| {
                setup.probe.pre_travel.0 = 30.0; // it comes too late: the ball is pressed into the block
            }),
        ],
        unreached: Vec::new(),
    }
}

/// A macro that begins inside of the bore.
fn in_bore(usual: &'static str, incomplete: &'static str, still: &'static str) -> Table {
    Table { program: PROGRAM, usual, setup, cases: measuring(usual, incomplete, still, pressed), unreached: Vec::new() }
}

/// What every measuring macro stops with: as called, with an address missing, with nothing to move, and with a stylus
/// that touches.
fn measuring(
    usual: &'static str,
    incomplete: &'static str,
    still: &'static str,
    touching: fn(&mut Setup),
) -> Vec<Case> {
    vec![
        case_of(nct::FORMAT_ERROR, incomplete, |_| ()),
        case_of(nct::NO_TOOL_LENGTH, usual, |setup| setup.control.edge = 0),
        case_of(nct::STYLUS_IN_CONTACT, usual, touching),
        case_of(nct::PROBE_FAIL, usual, |setup| {
            setup.workpiece.solids.clear();
        }),
        case_of(nct::NO_MOVEMENT, still, |_| ()),
        case_of(nct::FALSE_TRIGGER, usual, false_signal),
        case_of(nct::OUT_OF_POSITION, usual, |setup| {
            setup.control.set(nct::POSITION_LOST, 1.0);
        }),
    ]
}

fn setup() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    setup.position = Mcs([0.0, 0.0, -10.0]);
    setup.workpiece.solids = vec![Solid::new(Shape::Hole { diameter: 50.0, depth: 30.0 }, Mcs::default())];
    setup
}

/// A block with its face at 0, the stylus 50 mm above.
fn above() -> Setup {
    let mut setup = setup();
    setup.position = Mcs([0.0, 0.0, 50.0]);
    setup.workpiece.solids[0].shape = Shape::Block { size: [100.0, 100.0, 60.0] };
    setup
}

/// The stylus stands 1 mm deep in the face.
fn sunk(setup: &mut Setup) {
    setup.position[2] = -1.0;
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

/// A boss that is so large that the way down beside its nominal wall ends on it.
fn too_large_a_boss(setup: &mut Setup) {
    setup.workpiece.solids[0].shape = Shape::Shaft { diameter: 70.0, height: 40.0 };
    setup.position[2] = 10.0;
}

/// A tool that no longer fits once it is corrected.
fn thick_tool(setup: &mut Setup) {
    grown(setup);
    setup.control.edge_made(0, 1).radius = 24.9;
}
