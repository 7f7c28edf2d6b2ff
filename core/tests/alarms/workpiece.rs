//! Cases that all workpiece cycles with tool offset share: state of the control, probe, `_KNUM`, tool.

use super::table::{Case, case, program};
use probewright_core::control::Plane;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

/// Alarms that no state of the simulated control brings about.
pub const UNREACHED: &[(u32, &str)] = &[
    (61306, "the manual gives no condition: where _TDIF is exceeded, every text of these cycles has 62306 (B:6129)"),
    (61312, "the cycle itself is permitted; one that is not is no entry of the catalogue (A:15851)"),
    (61319, "internal error of the cycles (A:15860)"),
    (61327, "the manual gives no condition (A:15868)"),
    (61340, "internal error of the cycles (A:15881)"),
    (61344, "the simulated machine has one spindle (A:15887)"),
    (61403, "internal error of the cycles (A:15922)"),
    (61404, "internal error of the cycles (A:15923)"),
];

/// Alarms about a tool to be corrected, which a cycle has not that corrects something else.
const NO_TOOL: [u32; 10] = [61320, 61328, 61343, 61345, 61405, 61406, 61407, 61408, 61409, 61410];

/// What no call of a cycle without a tool to be corrected brings about: what its entry does not have is in `not`, and
/// why there is no tool in `why`.
pub fn unreached_without_tool(not: &[u32], why: &'static str) -> Vec<(u32, &'static str)> {
    let common = UNREACHED.iter().copied();
    let common = common.filter(|(number, _)| !not.contains(number));
    common.chain(NO_TOOL.map(|number| (number, why))).collect()
}

/// Why a cycle that corrects zero offsets only has no tool.
pub const ZERO_ONLY: &str = "the cycle corrects zero offsets, no tool";

/// A hole of 60 mm.
pub const HOLE: Shape = Shape::Hole { diameter: 60.0, depth: 40.0 };

/// The first solid is larger in diameter by so much.
pub fn larger(setup: &mut Setup, size: f64) {
    setup.workpiece.solids[0].errors.size = size;
}

/// The cases of a diameter of 60 mm that is measured with `_TSA=3 _TDIF=2 _TUL=0.5 _TLL=-0.5`.
pub fn diameters() -> Vec<Case> {
    vec![
        case(61303, "", |setup| larger(setup, 3.5)),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| larger(setup, 3.5)),
        case(62304, "", |setup| larger(setup, 0.7)),
        case(62305, "", |setup| larger(setup, -0.7)),
        case(62306, "", |setup| larger(setup, 2.5)),
    ]
}

/// The probe in the spindle at this position, T20 to be corrected, one solid with its upper face at Z0.
pub fn setup(shape: Shape, position: [f64; 3]) -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.tools.insert(20, crate::mill::tool(&[1]));
    setup.position = Mcs(position);
    setup.workpiece.solids = vec![Solid::new(shape, Mcs::default())];
    setup
}

/// Calibrate in another plane (B:13658-13667).
pub const OTHER_PLANE: Case = Case { code: Code::Alarm(61341), change: "_WP[0,9]=18", prepare: |_| () };

/// The cases that the cycles with tool offset share.
pub fn cases() -> Vec<Case> {
    let mut cases = common();
    cases.push(OTHER_PLANE);
    cases.extend(offsets());
    cases
}

/// The cases of a tool that is corrected.
pub fn offsets() -> Vec<Case> {
    let mut cases = vec![program(61318, "_K=0")];
    cases.extend(targets());
    cases
}

/// The cases of every workpiece cycle of milling.
pub fn common() -> Vec<Case> {
    let mut cases = everywhere();
    cases.extend(in_spindle());
    cases
}

/// The cases of every workpiece cycle.
pub fn everywhere() -> Vec<Case> {
    let mut cases = state();
    cases.extend(values());
    cases.push(case(61301, "", |setup| setup.workpiece.solids.clear()));
    cases
}

/// The cases of a control in which no measuring cycle runs.
pub fn state() -> Vec<Case> {
    vec![
        case(61016, "", |setup| setup.control.set("MD28082", 1.0)),
        program(61310, "SCALE X2 Y2"),
        program(61311, "D0"),
        case(61336, "", |setup| setup.control.set("MD20050[1]", 0.0)),
        program(61338, "_SPEED[1]=0"),
        program(61339, "_SPEED[0]=-1"),
        program(61342, "_SI[1]=\"2\""),
        program(61416, "_CVAL[1]=4"),
    ]
}

/// The probe in the spindle of a milling machine.
fn in_spindle() -> Vec<Case> {
    vec![
        program(61309, "$TC_DP1[9,1]=500"),
        case(61373, "_PRNUM=101", |setup| {
            setup.control.spindle_positions = false;
        }),
    ]
}

/// The cases of parameters that every cycle has.
pub fn values() -> Vec<Case> {
    vec![program(61307, "_MVAR=7"), program(61308, "_FA=0"), program(61313, "_PRNUM=4")]
}

fn targets() -> Vec<Case> {
    vec![
        program(61320, "_TNUM=0"),
        program(61322, "_KNUM=3001"),
        program(61323, "_KNUM=20001"),
        program(61324, "_KNUM=500001"),
        program(61328, "_KNUM=2000"),
        program(61343, "_TNUM=0 _TNAME=\"NOBODY\""),
        program(61345, "_KNUM=2012"),
        program(61405, "_KNUM=2002001 _TENV=\"NOWHERE\""),
        program(61406, "_KNUM=1002001 _DLNUM=7"),
        program(61407, "_KNUM=9000001"),
        case(61408, "_KNUM=1002001 _DLNUM=1", |setup| {
            setup.control.set("MD18080", 0.0);
        }),
        case(61409, "_KNUM=1002001 _DLNUM=1 _CHBIT[8]=1", |setup| {
            setup.control.set("MD18112", 0.0);
        }),
        program(61410, "_KNUM=2002"),
    ]
}
