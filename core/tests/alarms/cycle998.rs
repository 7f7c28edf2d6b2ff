//! A straight edge at Y-50, the ball at Y-70 before it.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

pub fn table() -> Table {
    let mut cases = workpiece::common();
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=105 _SETVAL=-50 _MA=102 _ID=40 _STA1=0 _INCA=0 _RA=0 _KNUM=1 _PRNUM=1\n\
            _FA=5 _NMSP=1 _VMS=0 _EVNUM=0 _TSA=3\n\
            {change}\n\
            CYCLE998\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: [workpiece::unreached_without_tool(&[61306], workpiece::ZERO_ONLY), OWN.to_vec()].concat(),
    }
}

/// What the table of alarms gives to this cycle, and no call of it brings about.
const OWN: &[(u32, &str)] =
    &[(61318, "the cycle has no _K (A:15859, B:15875)"), (61322, TOOL_CODE), (61323, TOOL_CODE), (61324, TOOL_CODE)];
const TOOL_CODE: &str = "a digit of the code of a tool; that of a zero offset has none (A:15863-15865)";

fn setup() -> Setup {
    let block = Shape::Block { size: [100.0, 100.0, 50.0] };
    workpiece::setup(block, [-20.0, -70.0, -20.0])
}

/// The part turned by so much.
fn turned(setup: &mut Setup, angle: f64) {
    setup.workpiece.solids[0].errors.tilt[2] = angle;
}

fn own() -> Vec<Case> {
    vec![
        workpiece::OTHER_PLANE,
        program(61302, "_SETVAL=-44"),
        case(61303, "", |setup| turned(setup, 3.5)),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| turned(setup, 3.5)),
        program(61321, "_KNUM=1051"),
        program(61325, "_MA=101"),
        program(61329, "_RA=5"),
        program(61331, "_STA1=46"),
        program(61364, "_ID=0"),
        case(61372, "_MVAR=1105", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at Y-53
        case(61401, "", |setup| setup.control.limits.plus[1] = Some(-54.0)),
        program(61412, "_KNUM=1000"),
    ]
}
