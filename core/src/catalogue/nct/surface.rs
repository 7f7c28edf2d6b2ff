//! One surface: touched along the tool axis or across a wall, and drawn.

use super::touch::{Calibration, touch};
use super::{FORMAT_ERROR, NO_MOVEMENT, axis_name, figures, part};
use crate::catalogue::common::{PARAM, required};
use crate::control::{Control, Plane};
use crate::entry::stage::{Look, Seen, Staging};
use crate::entry::{Inputs, Need, Param, Proposal, Unit, When, address};
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};
use crate::picture::PictureShape;
use crate::workpiece::{Shape, Workpiece};

/// Height of a surface across the tool axis: X, in the plane of which it is that axis. Key and place in the manual are
/// those of the macro.
pub const X: Param = Param { name: address::X, needs: &[along_tool(Plane::G19)], ..HEIGHT };
/// The same for Y.
pub const Y: Param = Param { name: address::Y, needs: &[along_tool(Plane::G18)], ..HEIGHT };
/// The same for Z.
pub const Z: Param = Param { name: address::Z, needs: &[along_tool(Plane::G17)], ..HEIGHT };

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
        start: Wcs(start),
        ..Proposal::default()
    }
}

/// From the zero point to a drawn surface, mm.
const SET: f64 = 75.0;

/// A surface below the stylus on its side of the zero point, as a section along the first axis of the plane.
pub fn stage_axially(inputs: &Inputs) -> Staging {
    let name = figures::address(inputs, 2);
    let stage = figures::stage(inputs, Look::section(0), &[]);
    stage.with(name, SET.copysign(inputs.number(name)))
}

/// Its height and limits.
pub fn marks_axially(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [seen] = looks else {
        return Vec::new();
    };
    let mut shapes = figures::limits(inputs, seen);
    shapes.extend(seen.position(figures::address(inputs, 2), 1, None));
    shapes
}
