//! How a tool touches the disk: quickly, back, slowly. Places are those of the spindle nose in machine coordinates, as
//! the macro works in G49 from the reference point (C:1193-1200, C:1258).

use super::{INCORRECT, TOO_SMALL};
use crate::catalogue::nct::touch::{BACK, MEDIUM, POSITIONING, SLOW};
use crate::entry::{Inputs, address};
use crate::geometry::{Mcs, Wcs};
use crate::machine::{Machine, MotionKind, Stop};

/// Ways of a turning tool a revolution at the first and at the measuring touch, mm: so large is their error (C:1256).
const PER_TURN: [f64; 2] = [0.1, 0.001];

/// Feed F or #512 and speed S or #511: mm/min, 1/min (C:1202).
pub fn feed_and_speed(machine: &mut dyn Machine, inputs: &Inputs) -> (f64, f64) {
    let control = machine.control();
    let feed = inputs.given(address::F);
    let speed = inputs.given(address::S);
    (feed.unwrap_or_else(|| control.basic_length("#512")), speed.unwrap_or_else(|| control.number("#511")))
}

/// Feeds of the first and of the measuring touch, mm/min, of a tool that turns at this speed, or stands.
pub fn feeds(feed: f64, speed: Option<f64>) -> [f64; 2] {
    let [first, measuring] = PER_TURN.map(|way| speed.map_or(f64::INFINITY, |speed| way * speed));
    [feed.min(first), SLOW.min(feed).min(measuring)]
}

/// Where the spindle nose stands, machine coordinates, mm.
pub fn nose(machine: &mut dyn Machine) -> [f64; 3] {
    let here = machine.position();
    let control = machine.control();
    let (point, length) = (control.to_machine(here), control.active_length());
    std::array::from_fn(|i| point[i] + length[i])
}

/// The position in the WCS at which the spindle nose stands there.
fn position(machine: &mut dyn Machine, nose: [f64; 3]) -> Wcs {
    let control = machine.control();
    let length = control.active_length();
    control.to_workpiece(Mcs(std::array::from_fn(|i| nose[i] - length[i])))
}

/// Positions beside the disk or above it, where nothing is in the way.
pub fn travel(machine: &mut dyn Machine, nose: [f64; 3]) -> Result<(), Stop> {
    let to = position(machine, nose);
    machine.travel(to, MotionKind::Positioning, POSITIONING, false)
}

/// The present place of the spindle nose, at another coordinate of one axis.
fn at(machine: &mut dyn Machine, axis: usize, coordinate: f64) -> Wcs {
    let mut to = nose(machine);
    to[axis] = coordinate;
    position(machine, to)
}

/// Up to this height, then straight to this place.
pub fn leave(machine: &mut dyn Machine, to: [f64; 3]) -> Result<(), Stop> {
    let up = at(machine, 2, to[2]);
    machine.travel(up, MotionKind::Retract, POSITIONING, false)?;
    travel(machine, to)
}

/// Sinks beside the disk. A contact ends it at the start with D TOO SMALL (C:1224, C:1245).
pub fn sink(machine: &mut dyn Machine, height: f64, start: [f64; 3]) -> Result<(), Stop> {
    let down = at(machine, 2, height);
    match machine.travel(down, MotionKind::Positioning, POSITIONING, true) {
        Err(Stop::Alarm(_)) => {
            leave(machine, start)?;
            Err(Stop::Alarm(TOO_SMALL))
        }
        other => other,
    }
}

/// Touches along one axis, quickly and slowly; where the spindle nose stood at last. Back by some way each time, so
/// that nothing drags along the disk, and never behind where the touch began. No contact ends at the start with
/// INCORRECT PROBING.
pub fn touch(machine: &mut dyn Machine, axis: usize, end: f64, feeds: [f64; 2], start: [f64; 3]) -> Result<f64, Stop> {
    let from = nose(machine)[axis];
    let target = at(machine, axis, end);
    let mut contact = from;
    for feed in feeds {
        if machine.probe(target, feed)?.is_none() {
            leave(machine, start)?;
            return Err(Stop::Alarm(INCORRECT));
        }
        contact = nose(machine)[axis];
        let way = from - contact;
        let back = at(machine, axis, contact + BACK.min(way.abs()).copysign(way));
        machine.travel(back, MotionKind::Retract, MEDIUM, false)?;
    }
    Ok(contact)
}
