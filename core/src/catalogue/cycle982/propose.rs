//! A nominal tool probe for CYCLE982 and CYCLE972, where the control believes it to be, and the tool before it.

use super::params::{
    ABSCISSA, AUTOMATIC, BOTH, CALIBRATE, DRILL_ALONG_APPLICATE, IN_WORKPIECE, INCREMENTAL, OPPOSITE, RADIAL, RADIUS,
    TURNING, UPPER,
};
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::ProbeData;
use crate::control::tools::side;
use crate::workpiece::{Cut, Tool};

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
    let field = Field {
        inputs,
        probe: ProbeData::of(inputs, &own),
        radius: own.active_radius(),
        nose: own.active_edge().map_or([-1.0; 2], |edge| side(edge.tip, inputs.recodes())),
    };
    let [abscissa, ordinate] = match along_applicate {
        true => field.over(control.plane),
        false if TURNING.holds(inputs) || CALIBRATE.holds(inputs) => field.nose(),
        false => field.cutter(),
    };
    let start = place::in_plane(&own, [abscissa, ordinate, 0.0]);
    Proposal {
        tool_probes: field.probe.cap(&own, false, HEIGHT / 2.0, HEIGHT).into_iter().collect(),
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
        cutter.axis = if DRILL_ALONG_APPLICATE.holds(inputs) { 2 } else { usize::from(RADIAL.holds(inputs)) };
        cutter.disc = if UPPER.holds(inputs) { DISC } else { 0.0 };
    }
    Some(tool)
}

/// Probe and tool in the plane: abscissa and ordinate from which the call is safe.
struct Field<'a> {
    inputs: &'a Inputs,
    probe: ProbeData,
    radius: f64,
    /// From the centre of the nose of a turning tool to its tip, in nose radii.
    nose: [f64; 2],
}

impl Field<'_> {
    /// The measuring path and so much more before a side that is touched in this direction.
    fn before(&self, axis: usize, direction: f64, more: f64) -> f64 {
        self.probe.trigger(axis, direction) - direction * (self.inputs.number(names::FA) + more)
    }

    /// Before the probe in the axis along which a drill is as long as on a milling machine, over its middle in the
    /// other.
    fn over(&self, plane: Plane) -> [f64; 2] {
        let lies = usize::from(plane == Plane::G19);
        let direction = self.told(-1.0);
        let mut start = self.probe.centre();
        start[lies] = self.before(lies, direction, if INCREMENTAL.holds(self.inputs) { 0.0 } else { AWAY });
        start
    }

    /// The direction that an incremental variant is told, else this one.
    fn told(&self, otherwise: f64) -> f64 {
        if !INCREMENTAL.holds(self.inputs) {
            return otherwise;
        }
        self.inputs.given(names::MD).map_or(otherwise, |md| if md == 0.0 { 1.0 } else { -1.0 })
    }

    /// A milling tool or drill beside the probe.
    fn cutter(&self) -> [f64; 2] {
        let along = usize::from(RADIAL.holds(self.inputs));
        let across = 1 - along;
        if INCREMENTAL.holds(self.inputs) && !AUTOMATIC.holds(self.inputs) && !BOTH.holds(self.inputs) {
            let axis = if RADIUS.holds(self.inputs) { across } else { self.measured() };
            let mut start = self.probe.centre();
            start[across] += self.radius;
            start[axis] = self.before(axis, self.told(-1.0), if axis == across { self.radius } else { 0.0 });
            return start;
        }
        let towards = if UPPER.holds(self.inputs) && !OPPOSITE.holds(self.inputs) { 1.0 } else { -1.0 };
        let mut start = [self.before(along, towards, AWAY); 2];
        start[across] = self.before(across, -1.0, AWAY) + self.radius;
        start
    }

    /// The measuring axis.
    fn measured(&self) -> usize {
        usize::from(!ABSCISSA.holds(self.inputs))
    }

    /// The tip before the sides that it touches; the calibration tool before the plus sides.
    fn nose(&self) -> [f64; 2] {
        if !INCREMENTAL.holds(self.inputs) {
            return [0, 1].map(|axis| match self.nose[axis] {
                0.0 => self.probe.middle(axis),
                direction => self.before(axis, direction, AWAY),
            });
        }
        let axis = if RADIUS.holds(self.inputs) { 0 } else { self.measured() };
        let direction = self.told(self.nose[axis]);
        let mut start = [0, 1].map(|axis| self.probe.middle(axis) + self.nose[axis] * self.radius);
        let behind = (direction - self.nose[axis]) * self.radius;
        start[axis] = self.before(axis, direction, 0.0) - behind;
        start
    }
}
