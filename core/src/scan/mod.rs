//! Digitizing: what a cycle that scans a surface hands over, and what is made of it. Lengths in mm, positions X Y Z of
//! the active WCS.

pub mod cloud;
mod spread;
#[cfg(test)]
mod tests;
pub mod text;

pub use cloud::Cloud;
pub use spread::turns;

use crate::control::{Control, Plane};

/// Most points of a scan: they and what is calculated for each must fit into the memory of a browser.
pub const POINTS: usize = 2_000_000;
/// Points up to which a form follows a scan at every keystroke.
pub const FORM_POINTS: usize = 1500;
/// Points that a form follows with a body of the probe: to look at each way for it too takes three times as long.
pub const FORM_POINTS_WITH_BODY: usize = 500;
/// Points of which a trace holds every motion, and a log the block; of the others only the result counts.
pub const TOLD: usize = 500;

/// A point as the control sends it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scanned {
    /// Number of its line, from 0.
    pub line: usize,
    /// Ball centre in the plane; along the tool axis the end of the ball, to which the length of the stylus refers.
    pub at: [f64; 3],
}

/// A scan as it was sent, as far as it came.
#[derive(Clone, Debug, PartialEq)]
pub struct Sent {
    /// Points of the scan.
    pub cloud: Cloud,
    /// How they were scanned.
    pub layout: Layout,
}

/// How a surface is scanned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Axis of the lines, axis from line to line, axis of the tool.
    pub axes: [usize; 3],
    /// Ball radius that the control calculates with.
    pub radius: f64,
    /// Where the tool axis stood at the call.
    pub height: f64,
    /// Feed while searching, mm/min.
    pub rate: f64,
    /// How far a point may be from where it was touched, mm.
    pub accuracy: f64,
    /// Number of the program that is sent.
    pub number: Option<i64>,
    /// Working plane.
    pub plane: Plane,
    /// Millimetres in one unit of what is sent.
    pub per: f64,
}

impl Layout {
    /// That of a control which scans along one axis of its plane and steps along another one.
    pub fn of(control: &Control, along: usize, across: usize) -> Layout {
        let [.., axial] = control.plane.axes();
        let axes = [along, across, axial];
        Layout { axes, plane: control.plane, per: control.active_factor(), ..Layout::default() }
    }
}
