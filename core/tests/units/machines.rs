//! Machines on which the cycles measure, in both basic systems.

use super::{Physical, turning};
use probewright_core::control::{Edge, Frame, MachineSort, Plane, Tool, Units};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, ProbeUse};
use probewright_core::geometry::Rpy;
use probewright_core::machine::Setup;

/// A machine with something in every place that a measurement reads or corrects; all lengths the same in mm.
pub fn machine(dialect: Dialect, basic: Units) -> Setup {
    let mut setup = Setup::calibrated_in(dialect, Plane::G17, basic);
    let control = &mut setup.control;
    let mill = Edge { kind: 120, length: [80.0, 0.0, 0.0], radius: 10.0, ..Edge::default() };
    match dialect {
        Dialect::Sinumerik => {
            let tool = Tool { name: "MILL".into(), edges: [(1, mill)].into() };
            control.tools.insert(20, tool);
            control.set("_EV[9]", 0.01 / control.basic_factor());
            control.set("_MV[9]", 0.02 / control.basic_factor());
            control.set("_CHBIT[4]", 1.0);
            control.set("_WP[0,7]", 0.25 / control.basic_factor());
        }
        Dialect::Nct => *control.edge_made(0, 1) = mill,
    }
    let offset =
        Frame { coarse: [310.0, -45.0, 20.0], fine: [0.0; 3], rotation: Rpy([0.0, 0.0, 30.0]), ..Frame::default() };
    control.frames.insert(1, offset);
    control.activate(1);
    setup
}

/// A turning machine with a tool to be corrected, a memory in use and the zero point in front of the chuck; all lengths
/// the same in mm.
fn turning_machine(basic: Units) -> Setup {
    let mut setup = Setup::turning_in(Plane::G18, basic);
    let control = &mut setup.control;
    control.tools.insert(20, turning::tool(0.8));
    control.set("_EV[9]", 0.01 / control.basic_factor());
    control.set("_MV[9]", 0.02 / control.basic_factor());
    control.set("_CHBIT[4]", 1.0);
    control.set("_WP[0,3]", 2.9 / control.basic_factor());
    control.frames.insert(1, Frame::translation([0.0, 0.0, 210.0]));
    control.activate(1);
    setup
}

/// A machine with the tool that a variant measures before the tool probe, a memory in use and a zero offset; all
/// lengths the same in mm.
fn tool_probe_machine(cycle: &Cycle, variant: i64, basic: Units) -> Setup {
    let plane = match cycle.purpose.machine {
        MachineSort::Turning => Plane::G18,
        _ => Plane::G17,
    };
    let mut setup = Setup::calibrated_in(cycle.dialect, plane, basic);
    setup.suit(cycle, variant);
    let control = &mut setup.control;
    control.set("_EV[9]", 0.01 / control.basic_factor());
    control.frames.insert(1, Frame::translation([30.0, 0.0, 60.0]));
    control.activate(1);
    setup
}

/// The machine on which a cycle measures.
pub fn machine_for(cycle: &Cycle, values: &Physical, basic: Units) -> Setup {
    match (cycle.purpose.probe, cycle.purpose.machine) {
        (ProbeUse::Tool, _) => {
            let variant = values.iter().find(|(name, _)| *name == "_MVAR");
            tool_probe_machine(cycle, variant.unwrap().1 as i64, basic)
        }
        (_, MachineSort::Turning) => turning_machine(basic),
        _ => machine(cycle.dialect, basic),
    }
}
