//! The first reference groove, the ball over its middle.

use super::table::{Table, case, program};
use super::{lathe, workpiece};
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::{Shape, Solid};

pub fn table() -> Table {
    let mut cases = lathe::cases();
    cases.extend([
        program(61302, "_KB[0,2]=5"),
        program(61303, "_WP[0,3]=7"),
        program(62303, "_WP[0,3]=7 _CBIT[0]=1 _CBIT[1]=1"),
        program(61326, "_MA=1"),
        program(61333, "_CALNUM=4"),
        // the wall at 60.123 is touched at 57.123, the turret 40.123 further out
        case(61401, "", |setup| {
            setup.control.limits.plus[0] = Some(97.0);
        }),
    ]);
    let mut unreached = workpiece::unreached_without_tool(&[61306, 61319, 61327], workpiece::ZERO_ONLY);
    unreached.extend([lathe::SPINDLE, lathe::NOT_TURNED]);
    Table {
        program: "G18 G90 G54 DIAMOF\n\
            _MVAR=2013 _MA=2 _CALNUM=1 _PRNUM=1 _FA=3 _NMSP=1 _VMS=0 _TSA=1 _TZL=0\n\
            {change}\n\
            CYCLE973\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached,
    }
}

fn setup() -> Setup {
    let mut setup = lathe::setup([55.0, 0.0, 60.0]);
    setup.workpiece.solids = vec![Solid::new(
        Shape::Groove { width: 60.123 - 50.054, depth: 12.0, length: 40.0 },
        Mcs([(60.123 + 50.054) / 2.0, 0.0, 15.021 + 12.0]),
    )];
    setup
}
