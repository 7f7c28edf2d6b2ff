//! A face at X50, the ball at X70 beside it.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::machine::Setup;
use probewright_core::workpiece::Shape;

pub fn table() -> Table {
    let mut cases = workpiece::cases();
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=0 _SETVAL=50 _MA=1 _KNUM=2001 _TNUM=20 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0 _EVNUM=0 _K=1\n\
            _TSA=3 _TDIF=2 _TUL=0.5 _TLL=-0.5 _TMV=0.3 _TZL=0.01\n\
            {change}\n\
            CYCLE978\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: workpiece::UNREACHED.to_vec(),
    }
}

fn setup() -> Setup {
    let block = Shape::Block { size: [100.0, 100.0, 50.0] };
    workpiece::setup(block, [70.0, 0.0, -20.0])
}

/// A face that stands further out by so much.
fn shifted(setup: &mut Setup, way: f64) {
    setup.workpiece.solids[0].errors.shift[0] = way;
}

fn own() -> Vec<Case> {
    vec![
        program(61302, "_SETVAL=44"),
        case(61303, "", |setup| shifted(setup, 3.5)),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| shifted(setup, 3.5)),
        case(62304, "", |setup| shifted(setup, 0.7)),
        case(62305, "", |setup| shifted(setup, -0.7)),
        case(62306, "", |setup| shifted(setup, 2.5)),
        // G55 is not active
        case(61310, "_MVAR=100 _KNUM=2", |setup| {
            setup.control.frames.entry(2).or_default().scale = [2.0, 1.0, 1.0];
        }),
        program(61321, "_MVAR=100 _KNUM=100"),
        program(61341, "_WP[0,1]=0 _WP[0,2]=0"),
        program(61325, "_MA=4"),
        case(61372, "_MVAR=1000", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at X53
        case(61401, "", |setup| setup.control.limits.minus[0] = Some(54.0)),
        program(61412, "_MVAR=100 _KNUM=1000"),
    ]
}
