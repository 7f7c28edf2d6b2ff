//! Three spheres of 50 mm at the height 0, the ball 60 mm above the first one.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::diagnostic::Code;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

pub fn table() -> Table {
    let mut cases = workpiece::common();
    cases.retain(|case| case.code != Code::Alarm(61373));
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=10109 _SETVAL=50 _SETV[0]=SET(0,0,0,200,0,0,0,300,0)\n\
            _KNUM=1 _TNVL=0.5 _STA1=0 _INCA=90 _RF=900 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0 _TSA=2\n\
            {change}\n\
            CYCLE997\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: [workpiece::unreached_without_tool(&[], NO_TOOL), UNREACHED.to_vec()].concat(),
    }
}

/// Alarms of the entry that no call of it brings about.
const UNREACHED: &[(u32, &str)] =
    &[(61325, "the cycle has no _MA"), (61373, "a mono probe is refused as such, 61313 (B:8199)")];
const NO_TOOL: &str = "_KNUM names a frame, no tool is corrected (B:8326)";

fn setup() -> Setup {
    let sphere = Shape::Sphere { diameter: 50.0 };
    let mut setup = workpiece::setup(sphere, [0.0, 0.0, 60.0]);
    for place in [[200.0, 0.0, 0.0], [0.0, 300.0, 0.0]] {
        let mut other = setup.workpiece.solids[0].clone();
        other.at = Mcs(place);
        setup.workpiece.solids.push(other);
    }
    setup
}

/// The second sphere stands further away from the first one.
fn apart(setup: &mut Setup, way: f64) {
    setup.workpiece.solids[1].errors.shift[0] = way;
}

fn own() -> Vec<Case> {
    vec![
        workpiece::OTHER_PLANE,
        program(61302, "_SETVAL=36"),
        case(61303, "", |setup| apart(setup, 2.5)),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| apart(setup, 2.5)),
        program(61316, "_MVAR=1109 _INCA=180"),
        program(61321, "_KNUM=1051"),
        case(61372, "_CHBIT[13]=1", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at X28
        case(61401, "", |setup| setup.control.limits.plus[0] = Some(27.0)),
        program(61411, "_SETV[6]=400 _SETV[7]=0"),
        program(61412, "_KNUM=1000"),
        program(61413, "_SETVAL=0"),
        case(61414, "", |setup| apart(setup, 1.5)),
    ]
}
