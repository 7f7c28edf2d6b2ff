//! A turning machine with a tool probe, tools and calls, for the tests of CYCLE982 and CYCLE972.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::sinumerik::testing::call;
use crate::control::{AS_TURNING_TOOL, Edge, Frame, Plane, Transverse, Units, tools::side};
use crate::dialect::Dialect;
use crate::entry::Inputs;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::workpiece::{Cut, Cutter, Nose, Shape, Solid, Tool, ToolProbe};

/// Trigger points of the manual's probe by axis, touched in minus and in plus direction, mm (B:9044-9047).
pub const PROBE: [[f64; 2]; 2] = [[220.0, 200.0], [400.0, 380.0]];
/// Shift of the workpiece system, X Y Z, mm.
pub const SHIFT: [f64; 3] = [30.0, 0.0, 60.0];
/// T number of the tool in use.
pub const TOOL: i64 = 3;

/// A digit of `_MVAR`, counted from 1.
pub fn digit(variant: i64, place: u32) -> i64 {
    variant / 10_i64.pow(place - 1) % 10
}

/// The machine in G18 with the probe where the control believes it, in `_TP` and shifted in `_TPW`; G54 in effect.
pub fn machine(units: Units) -> Setup {
    let mut setup = Setup::calibrated_in(Dialect::Sinumerik, Plane::G18, units);
    let control = &mut setup.control;
    control.transverse = Transverse::Diameter;
    control.set("SD42950", AS_TURNING_TOOL);
    let shift = [SHIFT[2], SHIFT[0]];
    for (axis, triggers) in PROBE.into_iter().enumerate() {
        for (side, value) in triggers.into_iter().enumerate() {
            let per = control.basic_factor();
            let index = 2 * axis + side;
            control.set(format!("_TP[0,{index}]"), value / per);
            control.set(format!("_TPW[0,{index}]"), (value - shift[axis]) / per);
        }
    }
    control.frames.insert(1, Frame::translation(SHIFT));
    control.settable = 1;
    control.activate(1);
    setup.tool_probes = vec![ToolProbe::ideal(Solid::new(Shape::Block { size: [20.0; 3] }, Mcs([390.0, 0.0, 220.0])))];
    setup
}

/// Puts a tool into use: its data, and the tool as it really is.
pub fn mount(setup: &mut Setup, edge: Edge, real: Tool) {
    let tool = setup.control.tools.entry(TOOL).or_default();
    tool.edges.insert(1, edge);
    (setup.control.tool, setup.control.edge) = (TOOL, 1);
    setup.real_tools.insert((TOOL, 1), real);
}

/// A tool as it really is: L1, L2, radius, mm.
#[derive(Clone, Copy, Debug)]
pub struct Real {
    pub length: [f64; 2],
    pub radius: f64,
}

impl Real {
    /// A turning tool with this cutting edge position.
    pub fn nose(self, position: i64) -> Tool {
        let nose = Nose { radius: self.radius, side: side(position, false) };
        self.tool(Cut::Nose(nose))
    }

    /// A cutter along an axis of the plane; a groove mill with its upper edge where there is a width.
    pub fn cutter(self, axis: usize, disc: f64) -> Tool {
        self.tool(Cut::Cutter(Cutter { axis, disc, ..Cutter::smooth(self.radius) }))
    }

    fn tool(self, cut: Cut) -> Tool {
        let [first, second] = self.length;
        Tool { length: [first, second, 0.0], cut }
    }

    /// What the tool data say of it: off by these L1, L2 and radius, part of it as wear, mm.
    pub fn believed(self, kind: i64, tip: i64, wrong: [f64; 3]) -> Edge {
        let [first, second] = self.length;
        Edge {
            kind,
            tip,
            length: [first + wrong[0] - 0.02, second + wrong[1] + 0.03, 0.0],
            length_wear: [0.02, -0.03, 0.0],
            radius: self.radius + wrong[2] + 0.01,
            radius_wear: -0.01,
            ..Edge::default()
        }
    }
}

/// The call with wide limits.
pub fn inputs(setup: &Setup, variant: i64, values: &[(&'static str, f64)]) -> Inputs {
    let mut all = vec![("_PRNUM", 1.0), ("_FA", 6.0), ("_TSA", 20.0), ("_TDIF", 10.0), ("_TZL", 0.0)];
    all.extend(values);
    let mut inputs = call("CYCLE982", variant, &all);
    inputs.plane = setup.control.plane;
    inputs.tool_type = setup.control.active_edge().map_or(0, |edge| edge.kind);
    for name in inputs.cycle.settings {
        inputs.settings.insert(name, setup.control.number(name));
    }
    inputs
}

/// Machine position for the point of the tool from abscissa and ordinate, mm.
pub fn place(setup: &mut Setup, [abscissa, ordinate]: [f64; 2]) {
    setup.position = Mcs([ordinate, 0.0, abscissa]);
}
