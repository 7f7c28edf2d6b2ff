//! A right corner at the zero, the part between plus X and plus Y, the ball opposite at X-14 Y-15.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::geometry::Degrees;
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

pub fn table() -> Table {
    let mut cases = workpiece::common();
    // a mono probe is refused as such, 61313 (B:7846)
    cases.retain(|case| case.code != program(61373, "").code);
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=108 _STA1=0 _INCA=90 _SETV[0]=100 _SETV[1]=80 _ID=25 _KNUM=1 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0\n\
            {change}\n\
            CYCLE961\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: [workpiece::unreached_without_tool(&[61306, 61319], workpiece::ZERO_ONLY), OWN.to_vec()].concat(),
    }
}

/// What the table of alarms gives to this cycle, and no call of it brings about.
const OWN: &[(u32, &str)] = &[
    (61303, "the cycle has no safe area (B:15373)"),
    (61325, "the cycle has no _MA (A:15866, B:15344)"),
    (61373, "a mono probe is refused as such, 61313 (B:7846)"),
    (62303, "the cycle has no safe area (B:15373)"),
];

fn setup() -> Setup {
    let corner = Shape::OuterCorner { angle: Degrees(90.0), length: [200.0; 2], height: 50.0 };
    workpiece::setup(corner, [-14.0, -15.0, -10.0])
}

/// Above the part, for places that are given.
fn above(setup: &mut Setup) {
    setup.position[2] = 30.0;
}

fn own() -> Vec<Case> {
    vec![
        program(61302, "_STA1=25"),
        program(61321, "_KNUM=1051"),
        workpiece::OTHER_PLANE,
        program(61346, "_SETV[0]=0"),
        program(61347, "_INCA=0"),
        case(61367, "_MVAR=118 _SETV[0]=SET(50,-20,50,-20,-15,40,-15,80) _ID=-40", above),
        case(61368, "_MVAR=118 _SETV[0]=SET(50,-20,90,-20,-15,40,25,40) _ID=-40", above),
        case(61369, "_MVAR=118 _SETV[0]=SET(-50,-20,90,-20,-15,40,-15,80) _ID=-40", above),
        case(61372, "_CHBIT[13]=1", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at Y-3
        case(61401, "", |setup| setup.control.limits.plus[1] = Some(-5.0)),
        program(61412, "_KNUM=1000"),
    ]
}
