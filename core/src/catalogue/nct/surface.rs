//! One surface: touched along the tool axis or across a wall, and drawn.

use super::correct::{Found, Place, finish};
use super::params::{ALONG_X, ALONG_Y, ALONG_Z, COORDINATE};
use super::touch::{Calibration, touch};
use super::walls::home;
use super::{NO_MOVEMENT, axis_of, figures, part};
use crate::catalogue::prelude::*;

/// Height of a surface across the tool axis: X, in the plane of which it is that axis. Key and place in the manual are
/// those of the macro.
pub const X: Param = Param { name: address::X, needs: &[needed(ALONG_X)], ..COORDINATE };
/// Height of a surface across the tool axis Y.
pub const Y: Param = Param { name: address::Y, needs: &[needed(ALONG_Y)], ..COORDINATE };
/// Height of a surface across the tool axis Z.
pub const Z: Param = Param { name: address::Z, needs: &[needed(ALONG_Z)], ..COORDINATE };

const fn needed(when: When) -> Need {
    required(when, "need-nct-tool-axis")
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
/// `past`: overtravel past the nominal wall, mm. Its coordinate, WCS, mm, and the way of the ball towards it: +1 or −1.
pub fn touch_wall(machine: &mut dyn Machine, index: usize, nominal: f64, past: f64) -> Result<(f64, f64), Stop> {
    let axis = machine.control().plane.axes()[index.min(1)];
    let direction = direction(machine, axis, index, nominal)?;
    let spindle = spindle_at(machine, index, nominal, direction);
    let end = spindle + direction * past;
    if (end - machine.position()[axis]) * direction <= 0.0 {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    let contact = touch(machine, axis, end)?;
    Ok((nominal + contact - spindle, direction))
}

/// Coordinate of the spindle when the ball, moving this way, touches a wall, mm.
pub fn spindle_at(machine: &mut dyn Machine, index: usize, wall: f64, direction: f64) -> f64 {
    let calibration = Calibration::of(machine, index);
    wall - direction * calibration.radius(direction) - calibration.offset
}

/// Touches a surface downwards along the tool axis and goes back; its place. The length of the stylus ends where the
/// ball touches (G104), so that no radius counts.
pub fn touch_axially(machine: &mut dyn Machine, inputs: &Inputs, past: f64) -> Result<Place, Stop> {
    let start = machine.position();
    let [.., axis] = machine.control().plane.axes();
    let nominal = inputs.number(axis_of(inputs, 2));
    let end = nominal - past;
    if end >= start[axis] {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    let position = touch(machine, axis, end)?;
    home(machine, start)?;
    Ok(Place { axis, nominal, deviation: position - nominal })
}

/// Results, corrections and print-out of one surface; the rest as in [`Found`].
pub fn corrected(machine: &mut dyn Machine, inputs: &Inputs, place: Place, metal: f64, register: &'static str) {
    let deviation = place.deviation;
    let found = Found { deviation, size: None, metal, places: &[place], register };
    finish(machine, inputs, &[("POSITION", place.nominal + deviation), ("DEVIATION", deviation)], &found);
}

/// A block with its upper face at the coordinate of the tool axis that is given, the stylus above.
pub fn propose_axially(inputs: &Inputs, control: &Control) -> Proposal {
    let height = inputs.number(axis_of(inputs, 2));
    let shape = Shape::Block { size: [100.0, 100.0, 60.0] };
    part::propose(shape, [0.0, 0.0, height], [0.0, 0.0, height + 50.0], control)
}

/// From the zero point to a drawn surface, mm.
const SET: f64 = 75.0;

/// A surface below the stylus on its side of the zero point, as a section along the first axis of the plane.
pub fn stage_axially(inputs: &Inputs) -> Staging {
    let name = axis_of(inputs, 2);
    figures::stage(inputs, Look::section(0), &[]).with(name, SET.copysign(inputs.number(name)))
}

/// Height of the surface and limits.
pub fn marks_axially(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let height = |seen: &Seen| seen.position(axis_of(inputs, 2), 1, None);
    looks.iter().flat_map(|seen| [figures::limits(inputs, seen), height(seen)].concat()).collect()
}
