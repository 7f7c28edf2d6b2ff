//! The tool probe of the manual's examples and a mill of 5 mm radius before it (B:4433-4446).

use super::table::{Table, case, program};
use super::workpiece;
use probewright_core::catalogue::find;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::tool::{Cut, Cutter, Tool};
use probewright_core::workpiece::tool_probe::ToolProbe;
use probewright_core::workpiece::{Shape, Solid};

/// Why no alarm about a tool to be named or about the position of the spindle can come.
const IN_USE: &str = "the tool in use is corrected; no parameter names one (B:4157-4175)";
const NOT_POSITIONED: &str = "the cycle does not position the spindle (B:4251)";

pub fn table() -> Table {
    let mut cases = workpiece::state();
    cases.extend(workpiece::values());
    cases.extend([
        case(61301, "", |setup| setup.tool_probes.clear()),
        program(61302, "_MA=1 _TP[0,0]=40"),
        case(61303, "", |setup| longer(setup, 1.5)),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| longer(setup, 1.5)),
        case(62306, "", |setup| longer(setup, 0.7)),
        program(61309, "_TP[0,8]=7"),
        program(61314, "$TC_DP1[3,1]=500"),
        program(61325, "_MA=102"),
        program(61332, "_MA=1 G0 X39 Y90"),
        program(61349, "_MA=1 _TP[0,9]=0"),
        program(61350, "_MVAR=2 _CBIT[12]=1"),
        program(61351, "$TC_DP3[3,1]=0"),
        program(61366, "_MVAR=2 _CM[5]=5"),
        case(61401, "", |setup| {
            setup.control.limits.minus[2] = Some(151.0);
        }),
        program(61415, "_TP[0,8]=201"),
    ]);
    let mut unreached = workpiece::unreached_without_tool(&[61319], IN_USE);
    unreached.extend([61372, 61373].map(|number| (number, NOT_POSITIONED)));
    Table {
        program: "G17 G90 G500\n\
            _MVAR=1 _MA=3 _ID=0 _PRNUM=1 _FA=3 _NMSP=1 _VMS=0 _TZL=0.01 _TDIF=0.5 _TSA=1 _EVNUM=0\n\
            {change}\n\
            CYCLE971\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached,
    }
}

/// The mill is longer than its data say, mm.
fn longer(setup: &mut Setup, by: f64) {
    let tool = Tool { length: [70.0 + by, 0.0, 0.0], cut: Cut::Cutter(Cutter::smooth(5.0)) };
    setup.real_tools.insert((3, 1), tool);
}

fn setup() -> Setup {
    let cycle = find(Dialect::Sinumerik, "CYCLE971").unwrap();
    let mut setup = Setup::for_cycle(cycle, Plane::G17);
    setup.tool_probes =
        vec![ToolProbe::ideal(Solid::new(Shape::Block { size: [22.0, 22.0, 20.0] }, Mcs([39.0, 31.0, 80.0])))];
    setup.position = Mcs([70.0, 90.0, 120.0]);
    setup
}
