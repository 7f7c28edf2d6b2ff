//! A ring of 60 mm about X0 Y0, the ball in its middle.

use super::table::{Case, Table, case, program};
use super::workpiece;
use probewright_core::machine::Setup;

pub fn table() -> Table {
    let mut cases = workpiece::common();
    cases.extend(own());
    Table {
        program: "G17 G90 G54\n\
            _MVAR=10101 _SETVAL=60 _PRNUM=1 _FA=5 _NMSP=1 _VMS=0 _TSA=1 _TZL=0\n\
            {change}\n\
            CYCLE976\n\
            M30\n",
        usual: "",
        setup,
        cases,
        unreached: workpiece::unreached_without_tool(&[61306, 61319, 61327], NO_TOOL),
    }
}

const NO_TOOL: &str = "the cycle has no _KNUM; what it corrects is the probe in use (B:5154-5166)";

fn setup() -> Setup {
    workpiece::setup(workpiece::HOLE, [0.0, 0.0, -20.0])
}

/// A ball that is smaller than the stored one by more than `_TSA`.
fn small(setup: &mut Setup) {
    setup.probe.radius = 1.5;
}

fn own() -> Vec<Case> {
    vec![
        program(61302, "_SETVAL=80"),
        case(61303, "", small),
        case(62303, "_CBIT[0]=1 _CBIT[1]=1", small),
        program(61325, "_MVAR=2001 _MA=3"),
        program(61326, "_MVAR=1001 _MA=1 _MD=2"),
        case(61372, "_MVAR=8", |setup| {
            setup.control.spindle_positions = false;
        }),
        // the ball would touch at X27
        case(61401, "", |setup| setup.control.limits.plus[0] = Some(26.0)),
    ]
}
