//! One surface: touched along the tool axis or across a wall, and drawn.

use super::axis_name;
use super::touch::{Calibration, touch};
use super::{FORMAT_ERROR, NO_MOVEMENT, part};
use crate::catalogue::common::{PARAM, required};
use crate::control::{Control, Plane};
use crate::entry::Inputs;
use crate::entry::{Need, Param, Proposal, Unit, When};
use crate::machine::{Machine, Stop};
use crate::picture::figures::{circle, corners, dimension, line, polygon, rectangle};
use crate::picture::{Picture, PictureShape, ShapeKind, View};
use crate::workpiece::{Shape, Workpiece};

/// Height of a surface across the tool axis: X, in the plane of which it is that axis. Key and place in the manual are
/// those of the macro.
pub const X: Param = Param { name: "X", needs: &[along_tool(Plane::G19)], ..HEIGHT };
/// The same for Y.
pub const Y: Param = Param { name: "Y", needs: &[along_tool(Plane::G18)], ..HEIGHT };
/// The same for Z.
pub const Z: Param = Param { name: "Z", needs: &[along_tool(Plane::G17)], ..HEIGHT };

const HEIGHT: Param = Param { unit: Unit::ActiveLength, alarm: Some(FORMAT_ERROR), ..PARAM };

const fn along_tool(tool_axis_in: Plane) -> Need {
    required(When::Plane(tool_axis_in), "need-nct-tool-axis")
}

/// A wall as found.
pub struct Wall {
    /// Its coordinate, WCS, mm.
    pub position: f64,
    /// Way of the ball towards it: +1 or −1.
    pub direction: f64,
}

/// Way of the ball from its place to the nominal wall, +1 or −1; none where it stands there.
pub fn direction(machine: &mut dyn Machine, axis: usize, index: usize, nominal: f64) -> Result<f64, Stop> {
    let ball = machine.position()[axis] + Calibration::of(machine, index).offset;
    if nominal == ball {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    Ok((nominal - ball).signum())
}

/// Touches a wall across the first (0) or second (1) axis of the plane from where the machine stands; ends at the wall.
/// `past`: overtravel past the nominal wall, mm.
pub fn touch_wall(machine: &mut dyn Machine, index: usize, nominal: f64, past: f64) -> Result<Wall, Stop> {
    let axis = machine.control().plane.axes()[index.min(1)];
    let direction = direction(machine, axis, index, nominal)?;
    let spindle = spindle_at(machine, index, nominal, direction);
    let end = spindle + direction * past;
    if (end - machine.position()[axis]) * direction <= 0.0 {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    let contact = touch(machine, axis, end)?;
    Ok(Wall { position: nominal + contact - spindle, direction })
}

/// Coordinate of the spindle when the ball, moving this way, touches a wall, mm.
pub fn spindle_at(machine: &mut dyn Machine, index: usize, wall: f64, direction: f64) -> f64 {
    let calibration = Calibration::of(machine, index);
    wall - direction * calibration.radius(direction) - calibration.offset
}

/// Touches a surface downwards along the tool axis; its coordinate. The length of the stylus ends where the ball
/// touches (G104), so that no radius counts.
pub fn touch_axially(machine: &mut dyn Machine, applicate: usize, nominal: f64, past: f64) -> Result<f64, Stop> {
    let end = nominal - past;
    if end >= machine.position()[applicate] {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    touch(machine, applicate, end)
}

/// A block with its upper face at the coordinate of the tool axis that is given, the stylus above.
pub fn propose_axially(inputs: &Inputs, control: &Control) -> Proposal {
    let [.., applicate] = control.plane.axes();
    let (mut top, mut start) = ([0.0; 3], [0.0; 3]);
    top[applicate] = inputs.number(axis_name(applicate));
    start[applicate] = top[applicate] + 50.0;
    let size = [100.0, 100.0, 60.0];
    Proposal {
        workpiece: Workpiece { solids: vec![part::in_plane(Shape::Block { size }, top, control)] },
        start,
        ..Proposal::default()
    }
}

/// Ball radius of the drawings, mm.
pub const BALL: f64 = 3.0;
/// Half the length of a drawn face, and thickness behind it, mm.
pub const FACE: f64 = 30.0;
/// Where the zero of the axis is drawn, mm in front of the face.
const ZERO: f64 = 44.0;

/// A distance as drawn: short ones longer than they are.
pub fn drawn(length: f64) -> f64 {
    length.abs().clamp(6.0, 20.0)
}

/// A surface below the stylus, as a section along the first axis of the plane.
pub fn axial_picture(inputs: &Inputs) -> Picture {
    let [.., applicate] = inputs.plane.axes();
    let name = axis_name(applicate);
    let above = ZERO * 0.6;
    let mut shapes = vec![
        rectangle(ShapeKind::Cut, [0.0, -FACE / 2.0], [2.0 * FACE, FACE]),
        line(ShapeKind::Edge, vec![[-FACE, 0.0], [FACE, 0.0]]).of(name),
        line(ShapeKind::Axis, vec![[-FACE, -ZERO], [FACE, -ZERO]]).text("0"),
        line(ShapeKind::Path, vec![[0.0, above], [0.0, BALL]]),
        circle(ShapeKind::Probe, [0.0, above], BALL),
        circle(ShapeKind::Touch, [0.0; 2], BALL * 0.3),
        dimension(name, [-FACE * 0.7, -ZERO], [-FACE * 0.7, 0.0]),
    ];
    if let Some(past) = inputs.given("Q").map(drawn) {
        shapes.push(rectangle(ShapeKind::Zone, [0.0, -past / 2.0], [2.0 * FACE, past]).of("Q"));
        shapes.push(dimension("Q", [FACE * 0.7, 0.0], [FACE * 0.7, -past]));
    }
    let band = |half: f64| corners([0.0; 2], [2.0 * FACE, 2.0 * half]);
    shapes.extend(limits(inputs, band));
    Picture { view: View::Section, shapes }
}

/// Bands of H and U, where they are given; wider than they are.
pub fn limits(inputs: &Inputs, band: impl Fn(f64) -> Vec<[f64; 2]>) -> Vec<PictureShape> {
    [("U", 3.2), ("H", 1.6)]
        .into_iter()
        .filter(|(name, _)| inputs.given(name).is_some())
        .map(|(name, half)| polygon(ShapeKind::Tolerance, band(half)).of(name))
        .collect()
}
