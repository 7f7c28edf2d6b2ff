//! How a tool touches the disk: quickly, back, slowly. Places are those of the spindle nose in machine coordinates, as
//! the macro works in G49 from the reference point (C:1193-1200, C:1258).

use super::{INCORRECT, TOO_SMALL};
use crate::catalogue::nct::touch::{BACK, MEDIUM, POSITIONING, SLOW};
use crate::entry::{Inputs, address};
use crate::geometry::{Mcs, Wcs};
use crate::machine::trace::MotionKind;
use crate::machine::{Machine, Stop};

/// Ways of a turning tool a revolution at the first and at the measuring touch, mm: so large is their error (C:1256).
const PER_TURN: [f64; 2] = [0.1, 0.001];

/// Feeds of the first and of the measuring touch, mm/min.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feeds {
    /// First.
    pub fast: f64,
    /// Measuring.
    pub slow: f64,
}

/// Feed F or #512 and speed S or #511: mm/min, 1/min (C:1202).
pub fn feed_and_speed(machine: &mut dyn Machine, inputs: &Inputs) -> (f64, f64) {
    let control = machine.control();
    let feed = inputs.given(address::F);
    let speed = inputs.given(address::S);
    (feed.unwrap_or_else(|| control.basic_length("#512")), speed.unwrap_or_else(|| control.number("#511")))
}

impl Feeds {
    /// Of a tool that turns at this speed, or stands.
    pub fn of(feed: f64, speed: Option<f64>) -> Feeds {
        match speed {
            None => Feeds { fast: feed, slow: SLOW.min(feed) },
            Some(speed) => Feeds { fast: feed.min(PER_TURN[0] * speed), slow: SLOW.min(feed).min(PER_TURN[1] * speed) },
        }
    }
}

/// Where the spindle nose stands, machine coordinates, mm.
pub fn nose(machine: &mut dyn Machine) -> [f64; 3] {
    let here = machine.position();
    let control = machine.control();
    let (point, length) = (control.to_machine(here), control.active_length());
    std::array::from_fn(|i| point[i] + length[i])
}

/// The position in the WCS at which the spindle nose stands there.
fn position(machine: &mut dyn Machine, nose: [f64; 3]) -> [f64; 3] {
    let control = machine.control();
    let length = control.active_length();
    (control.to_workpiece(Mcs(std::array::from_fn(|i| nose[i] - length[i])))).0
}

/// Positions beside the disk or above it, where nothing is in the way.
pub fn travel(machine: &mut dyn Machine, nose: [f64; 3]) -> Result<(), Stop> {
    let to = position(machine, nose);
    machine.travel(Wcs(to), MotionKind::Positioning, POSITIONING, false)
}

/// Up to this height, then straight to this place.
pub fn leave(machine: &mut dyn Machine, to: [f64; 3]) -> Result<(), Stop> {
    let mut up = nose(machine);
    up[2] = to[2];
    let up = position(machine, up);
    machine.travel(Wcs(up), MotionKind::Retract, POSITIONING, false)?;
    travel(machine, to)
}

/// Sinks beside the disk. A contact ends it at the start with D TOO SMALL (C:1224, C:1245).
pub fn sink(machine: &mut dyn Machine, height: f64, start: [f64; 3]) -> Result<(), Stop> {
    let mut down = nose(machine);
    down[2] = height;
    let down = position(machine, down);
    match machine.travel(Wcs(down), MotionKind::Positioning, POSITIONING, true) {
        Err(Stop::Alarm(_)) => {
            leave(machine, start)?;
            Err(Stop::Alarm(TOO_SMALL))
        }
        other => other,
    }
}

/// Touches along one axis; where the spindle nose stood. Back by some way then, so that nothing drags along the disk.
/// No contact ends at the start with INCORRECT PROBING.
pub fn touch(machine: &mut dyn Machine, axis: usize, end: f64, feeds: Feeds, start: [f64; 3]) -> Result<f64, Stop> {
    let from = nose(machine);
    let mut to = from;
    to[axis] = end;
    let target = position(machine, to);
    let Some(_) = machine.probe(Wcs(target), feeds.fast)? else {
        return missed(machine, start);
    };
    retract(machine, axis, from)?;
    let Some(_) = machine.probe(Wcs(target), feeds.slow)? else {
        return missed(machine, start);
    };
    let contact = nose(machine)[axis];
    retract(machine, axis, from)?;
    Ok(contact)
}

fn missed(machine: &mut dyn Machine, start: [f64; 3]) -> Result<f64, Stop> {
    leave(machine, start)?;
    Err(Stop::Alarm(INCORRECT))
}

/// Back off the disk, never behind where the touch began.
fn retract(machine: &mut dyn Machine, axis: usize, from: [f64; 3]) -> Result<(), Stop> {
    let mut to = nose(machine);
    let back = from[axis] - to[axis];
    to[axis] += BACK.min(back.abs()).copysign(back);
    let to = position(machine, to);
    machine.travel(Wcs(to), MotionKind::Retract, MEDIUM, false)
}
