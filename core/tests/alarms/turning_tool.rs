//! A turning tool before the tool probe of a turning machine, above it and to its right.

use super::table::{Case, Table, case, program};
use super::{turning, workpiece};
use probewright_core::control::{Plane, Transverse};
use probewright_core::geometry::Mcs;
use probewright_core::machine::Setup;
use probewright_core::workpiece::tool_probe::ToolProbe;
use probewright_core::workpiece::{Shape, Solid, tool};

const OWN_TOOL: &str = "the tool in use is corrected; no parameter names another one";

pub fn cycle972() -> Table {
    let mut cases = cases();
    cases.push(program(61330, "ROT Y10"));
    let mut unreached = unreached();
    unreached.push((61372, "a turning tool is turned by no spindle (A:15916)"));
    Table {
        program: "G18 G90 G54 DIAMON\nT3 D1\n\
            _MVAR=1 _MA=2 _PRNUM=1 _FA=4 _NMSP=1 _VMS=0 _EVNUM=0 _TSA=2 _TDIF=1 _TZL=0.001\n\
            {change}\nCYCLE972\nM30\n",
        usual: "",
        setup,
        cases,
        unreached,
    }
}

pub fn cycle982() -> Table {
    let mut cases = cases();
    cases.extend([
        program(61326, "_MVAR=100001 _MD=5"),
        program(61330, "_MVAR=11 ROT Y10"),
        program(61351, "$TC_DP1[3,1]=120 $TC_DP6[3,1]=0"),
        case(61372, "$TC_DP1[3,1]=120", |setup| {
            setup.control.spindle_positions = false;
        }),
        // what a spindle that stays as it is, turns, or has the tool at the wrong side does not allow
        program(61307, "$TC_DP1[3,1]=120 _MVAR=2 _CHBIT[20]=1"),
        program(61307, "$TC_DP1[3,1]=120 _MVAR=101 _MA=1 S100 M3"),
        program(61314, "$TC_DP1[3,1]=200 _MVAR=1001"),
        program(61314, "$TC_DP1[3,1]=200 $SC_TOOL_LENGTH_TYPE=0"),
        program(61314, "$TC_DP1[3,1]=120 _MVAR=0"),
        program(61315, "$TC_DP2[3,1]=7 _MVAR=0"),
        program(61325, "$TC_DP1[3,1]=120 _MVAR=1001 _MA=1"),
        case(61332, "$TC_DP1[3,1]=120 _MVAR=2", |setup| {
            setup.position[2] = 210.0;
        }),
    ]);
    Table {
        program: "G18 G90 G54 DIAMON\nT3 D1\n\
            _MVAR=1 _MA=2 _MD=1 _STA1=0 _CORA=0 _PRNUM=1 _FA=4 _NMSP=1 _VMS=0 _EVNUM=0 _TSA=2 _TDIF=1 _TZL=0.001\n\
            {change}\nCYCLE982\nM30\n",
        usual: "",
        setup,
        cases,
        unreached: unreached(),
    }
}

/// The tool in the turret, its real lengths as in its data; the probe of B:9044-9047.
fn setup() -> Setup {
    let mut setup = Setup::calibrated(probewright_core::dialect::Dialect::Sinumerik, Plane::G18);
    let control = &mut setup.control;
    control.transverse = Transverse::Diameter;
    control.set("SD42950", 2.0);
    for (index, value) in [220.0, 200.0, 400.0, 380.0].into_iter().enumerate() {
        control.set(format!("_TP[0,{index}]"), value);
    }
    let turning = turning::tool(2.0);
    let real = tool::Tool::nominal(&turning.edges[&1], control);
    setup.real_tools.insert((3, 1), real);
    setup.control.tools.insert(3, turning);
    (setup.control.tool, setup.control.edge) = (3, 1);
    setup.tool_probes = vec![ToolProbe::ideal(Solid::new(Shape::Block { size: [20.0; 3] }, Mcs([390.0, 0.0, 220.0])))];
    setup.position = Mcs([430.0, 0.0, 250.0]);
    setup
}

/// L1 in the data is larger than it is.
fn longer(setup: &mut Setup, by: f64) {
    setup.control.edge_of_mut(3, 1).unwrap().length[0] += by;
}

fn cases() -> Vec<Case> {
    vec![
        case(61016, "", |setup| setup.control.set("MD28082", 1.0)),
        case(61301, "", |setup| setup.tool_probes.clear()),
        program(61302, "_TP[0,2]=385"),
        case(61303, "", |setup| longer(setup, 3.0)),
        program(61307, "_MVAR=7"),
        program(61308, "_FA=0"),
        program(61310, "SCALE X2 Y2"),
        program(61311, "D0"),
        program(61313, "_PRNUM=9"),
        program(61314, "$TC_DP1[3,1]=710"),
        program(61315, "$TC_DP2[3,1]=9"),
        program(61325, "_MA=3"),
        program(61325, "$TC_DP2[3,1]=7"),
        case(61332, "", |setup| setup.position[0] = 390.0),
        case(61332, "", |setup| setup.position[0] = 350.0),
        case(61336, "", |setup| setup.control.set("MD20050[1]", 0.0)),
        program(61338, "_SPEED[1]=0"),
        program(61339, "_SPEED[0]=-1"),
        program(61342, "_SI[1]=\"2\""),
        program(61416, "_CVAL[1]=4"),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", |setup| longer(setup, 3.0)),
        case(62306, "", |setup| longer(setup, 1.5)),
    ]
}

fn unreached() -> Vec<(u32, &'static str)> {
    let mut unreached = workpiece::unreached_without_tool(&[61319], OWN_TOOL);
    unreached.push((61373, "a tool probe is not turned by a spindle (A:15917)"));
    unreached
}
