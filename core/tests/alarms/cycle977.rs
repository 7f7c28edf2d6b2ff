//! A hole of 60 mm about the zero, the ball in it 10 mm deep.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

pub fn table() -> Table {
    let mut cases = workpiece::cases();
    cases.extend(workpiece::diameters());
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=1 _SETVAL=60 _KNUM=2001 _TNUM=20 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0 _EVNUM=0 _K=1\n\
            _TSA=3 _TDIF=2 _TUL=0.5 _TLL=-0.5 _TMV=0.3 _TZL=0.01\n\
            {change}\n\
            CYCLE977\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: workpiece::UNREACHED.to_vec(),
    }
}

fn setup() -> Setup {
    workpiece::setup(workpiece::HOLE, [0.0, 0.0, -10.0])
}

fn own() -> Vec<Case> {
    vec![
        program(61302, "_SETVAL=80"),
        program(61321, "_MVAR=101 _KNUM=100"),
        program(61325, "_MVAR=3 _MA=3"),
        program(61341, "_WP[0,1]=0 _WP[0,2]=0"),
        program(61334, "_MVAR=1001 _SZA=50 _ID=-10"),
        case(61372, "_CHBIT[13]=1", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at X27
        case(61401, "", |setup| setup.control.limits.plus[0] = Some(25.0)),
        // the way beside the shaft leads to X38 and ends above it
        case(61402, "_MVAR=2 _ID=-20", |setup| {
            setup.workpiece.solids[0].shape = Shape::Shaft { diameter: 60.0, height: 40.0 };
            setup.position[2] = 10.0;
            setup.control.limits.plus[0] = Some(31.0);
        }),
        program(61412, "_MVAR=101 _KNUM=1000"),
    ]
}
