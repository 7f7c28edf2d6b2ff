//! A nominal tool probe for CYCLE982 and CYCLE972, where the control believes it to be, and the tool before it.

use super::params::{
    ABSCISSA, AUTOMATIC, BOTH, CALIBRATE, DRILL_ALONG_APPLICATE, IN_WORKPIECE, INCREMENTAL, OPPOSITE, RADIAL, RADIUS,
    TURNING, UPPER, WORKPIECE,
};
use crate::catalogue::place;
use crate::catalogue::tool_probe::ProbeData;
use crate::control::tools::side;
use crate::control::{Control, Edge, Plane};
use crate::entry::{Inputs, Proposal, ProposedTool, names};
use crate::geometry::Wcs;
use crate::workpiece::Shape;
use crate::workpiece::tool::{Cut, Tool};
use crate::workpiece::tool_probe::ToolProbe;

/// How far before the probe the tool starts beside the measuring path, mm.
const AWAY: f64 = 20.0;
/// Height of the probe across the plane, mm.
const HEIGHT: f64 = 20.0;
/// Width of a groove mill, mm.
const DISC: f64 = 4.0;

/// The tool that a variant needs: the calibration tool of B:8868, a mill where digits for milling tools are set
/// (B:9224), as in B:9526-9545, else the turning tool of B:9049.
pub fn tool(variant: i64) -> ProposedTool {
    let cutter_digits = variant / 100 % 1000;
    let (tool, name, kind, length, radius) = match (variant % 10, cutter_digits) {
        (0, _) => (7, "CALIBRATION", 500, [10.0, 40.0, 0.0], 5.0),
        (_, 0) => (3, "TURNING", 500, [100.654, 60.321, 0.0], 2.0),
        (_, 100..) => (3, "MILL", 120, [60.0, 10.0, 0.0], 14.0),
        _ => (3, "MILL", 120, [10.0, 60.0, 0.0], 14.0),
    };
    let data = Edge { kind, tip: if kind == 500 { 3 } else { 0 }, length, radius, ..Edge::default() };
    ProposedTool { tool, name: name.to_owned(), edge: 1, data }
}

/// Probe and start.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let mut own = control.clone();
    if !IN_WORKPIECE.holds(inputs) {
        own.take_frames();
    }
    let along_applicate = DRILL_ALONG_APPLICATE.holds(inputs);
    if along_applicate {
        own.plane = Plane::G18; // in which the probe was calibrated (B:10126)
    }
    let field = Field::of(inputs, &own);
    let [abscissa, ordinate] = match along_applicate {
        true => field.over(control.plane),
        false => field.start(),
    };
    let start = place::in_plane(&own, [abscissa, ordinate, 0.0]);
    Proposal {
        tool_probes: field.cap().into_iter().collect(),
        real_tool: lying(inputs, control),
        start: control.to_workpiece(own.to_machine(Wcs(start))),
        ..Proposal::default()
    }
}

/// A cutter as the variant says that it lies.
fn lying(inputs: &Inputs, control: &Control) -> Option<Tool> {
    let edge = control.active_edge().filter(|edge| !edge.is_turning())?;
    let mut tool = Tool::nominal(edge, control);
    if let Cut::Cutter(cutter) = &mut tool.cut {
        cutter.axis = match DRILL_ALONG_APPLICATE.holds(inputs) {
            true => 2,
            false => usize::from(RADIAL.holds(inputs)),
        };
        cutter.disc = if UPPER.holds(inputs) { DISC } else { 0.0 };
    }
    Some(tool)
}

/// Probe and tool in the plane.
struct Field<'a> {
    inputs: &'a Inputs,
    control: &'a Control,
    /// Trigger values by axis, touched in minus and in plus direction, mm.
    triggers: [[f64; 2]; 2],
    path: f64,
    radius: f64,
}

impl<'a> Field<'a> {
    fn of(inputs: &'a Inputs, control: &'a Control) -> Field<'a> {
        let data = ProbeData::of(inputs, control, WORKPIECE.holds(inputs));
        Field {
            inputs,
            triggers: [0, 1].map(|axis| data.triggers(axis)),
            path: inputs.number(names::FA),
            radius: control.active_radius(),
            control,
        }
    }

    fn middle(&self, axis: usize) -> f64 {
        let [minus, plus] = self.triggers[axis];
        (minus + plus) / 2.0
    }

    fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.triggers[axis][usize::from(direction > 0.0)]
    }

    /// Far enough before a side that is touched in this direction.
    fn away(&self, axis: usize, direction: f64) -> f64 {
        self.trigger(axis, direction) - direction * (self.path + AWAY)
    }

    /// The cube between the trigger points; none where they leave no room.
    fn cap(&self) -> Option<ToolProbe> {
        let [x, y] = self.triggers.map(|[minus, plus]| minus - plus);
        if x <= 0.0 || y <= 0.0 {
            return None;
        }
        let size = [x, y, HEIGHT];
        let at = [self.middle(0), self.middle(1), HEIGHT / 2.0];
        let (shape, up) = (Shape::Block { size }, [0.0, 0.0, 1.0]);
        let solid = place::solid(self.control, shape, at, [1.0, 0.0, 0.0], up);
        Some(ToolProbe::ideal(solid))
    }

    /// Before the probe in the axis along which a drill is as long as on a milling machine, over its middle in the
    /// other.
    fn over(&self, plane: Plane) -> [f64; 2] {
        let lies = usize::from(plane == Plane::G19);
        let direction = self.told(-1.0);
        let mut start = [self.middle(0), self.middle(1)];
        start[lies] = match INCREMENTAL.holds(self.inputs) {
            true => self.trigger(lies, direction) - direction * self.path,
            false => self.away(lies, direction),
        };
        start
    }

    /// The direction that an incremental variant is told, else this one.
    fn told(&self, otherwise: f64) -> f64 {
        match self.inputs.given(names::MD) {
            Some(0.0) if INCREMENTAL.holds(self.inputs) => 1.0,
            Some(_) if INCREMENTAL.holds(self.inputs) => -1.0,
            _ => otherwise,
        }
    }

    /// Abscissa and ordinate from which the call is safe.
    fn start(&self) -> [f64; 2] {
        if TURNING.holds(self.inputs) || CALIBRATE.holds(self.inputs) {
            return self.nose();
        }
        let along = usize::from(RADIAL.holds(self.inputs));
        let across = 1 - along;
        let towards = match (UPPER.holds(self.inputs), OPPOSITE.holds(self.inputs)) {
            (true, false) => 1.0,
            _ => -1.0,
        };
        let mut start = [0.0; 2];
        start[along] = self.away(along, towards);
        start[across] = self.away(across, -1.0) + self.radius;
        let incremental = INCREMENTAL.holds(self.inputs) && !AUTOMATIC.holds(self.inputs);
        if incremental && !BOTH.holds(self.inputs) {
            let axis = self.measured(across);
            let direction = self.told(-1.0);
            let reach = if axis == across { self.radius } else { 0.0 };
            start[1 - axis] = self.middle(1 - axis) + if axis == along { self.radius } else { 0.0 };
            start[axis] = self.trigger(axis, direction) - direction * (self.path + reach);
        }
        start
    }

    /// The measuring axis; the radius lies across.
    fn measured(&self, across: usize) -> usize {
        if RADIUS.holds(self.inputs) {
            return across;
        }
        usize::from(!ABSCISSA.holds(self.inputs))
    }

    /// The tip before the sides that it touches; the calibration tool before the plus sides.
    fn nose(&self) -> [f64; 2] {
        let edge = self.control.active_edge();
        let sides = edge.map_or([-1.0; 2], |edge| side(edge.tip, self.inputs.recodes()));
        let axis = self.measured(0);
        if !INCREMENTAL.holds(self.inputs) {
            return [0, 1].map(|axis| match sides[axis] {
                0.0 => self.middle(axis),
                direction => self.away(axis, direction),
            });
        }
        let direction = self.told(sides[axis]);
        let behind = (direction - sides[axis]) * self.radius;
        let mut start = [0, 1].map(|axis| self.middle(axis) + sides[axis] * self.radius);
        start[axis] = self.trigger(axis, direction) - behind - direction * self.path;
        start
    }
}
