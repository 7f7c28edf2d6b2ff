//! A turned part of 60 mm in diameter, the ball at X 100 (radius 50) beside it.

use super::table::{Table, case, program};
use super::{lathe, workpiece};

pub fn table() -> Table {
    let mut cases = lathe::cases();
    cases.extend(workpiece::offsets());
    cases.extend(workpiece::diameters());
    cases.extend([
        program(61302, "_SETVAL=46"),
        program(61321, "_MVAR=100 _KNUM=100"),
        program(61341, "_WP[0,3]=0 _WP[0,4]=0"),
        case(61372, "_MVAR=1000 _STA1=0", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at radius 33, the turret 40.123 further out
        case(61401, "", |setup| {
            setup.control.limits.minus[0] = Some(74.0);
        }),
        program(61412, "_MVAR=100 _KNUM=1000"),
    ]);
    let mut unreached = workpiece::UNREACHED.to_vec();
    unreached.push(lathe::SPINDLE);
    Table {
        program: "G18 G90 G54 DIAMON\n\
            _MVAR=0 _SETVAL=60 _MA=2 _KNUM=1 _TNUM=20 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0 _EVNUM=0 _K=1\n\
            _TSA=3 _TDIF=2 _TUL=0.5 _TLL=-0.5 _TMV=0.3 _TZL=0.01\n\
            {change}\n\
            CYCLE974\n\
            M30\n",
        usual: "",
        setup: || lathe::setup([50.0, 0.0, -30.0]),
        cases,
        unreached,
    }
}
