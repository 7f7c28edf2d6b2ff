//! A hole of 60 mm about the zero, the ball in it 10 mm deep; three points from 10° in steps of 80°.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::machine::Setup;

/// Alarms of the entry that no call of it brings about.
const UNREACHED: &[(u32, &str)] =
    &[(61317, "what CYCLE116 says of a number other than 3 or 4; the fourth digit of _PRNUM has no other (A:15858)")];

pub fn table() -> Table {
    Table {
        program: "G17 G90 G54\n\
            _MVAR=1 _SETVAL=60 _CPA=0 _CPO=0 _STA1=10 _INCA=80 _RF=900 _KNUM=2001 _TNUM=20 _PRNUM=1\n\
            _FA=5 _NMSP=1 _VMS=0 _EVNUM=0 _K=1\n\
            _TSA=3 _TDIF=2 _TUL=0.5 _TLL=-0.5 _TMV=0.3 _TZL=0.01\n\
            {change}\n\
            CYCLE979\n\
            M30\n",
        usual: "",
        setup,
        cases: cases(),
        unreached: workpiece::UNREACHED.iter().chain(UNREACHED).copied().collect(),
    }
}

fn setup() -> Setup {
    workpiece::setup(workpiece::HOLE, [0.0, 0.0, -10.0])
}

fn cases() -> Vec<Case> {
    let mut cases = workpiece::cases();
    cases.extend(workpiece::diameters());
    cases.extend([
        program(61302, "_SETVAL=80"),
        program(61316, "_INCA=180"),
        program(61321, "_MVAR=101 _KNUM=100"),
        // at an angle the ball counts, not the trigger points (B:6873)
        program(61341, "_WP[0,0]=0"),
        program(61365, "_RF=0"),
        case(61372, "_CHBIT[13]=1", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball touches P1 at X 27 cos 10 = 26.6
        case(61401, "", |setup| setup.control.limits.plus[0] = Some(25.0)),
        program(61412, "_MVAR=101 _KNUM=1000"),
    ]);
    cases
}
