//! The touch in three steps (C:96-98): fast until the signal, back at a medium rate, then slowly for the value.
//! The manual gives neither feeds nor the way back; those here are chosen so that the slow step adds no lag worth
//! naming: at 30 mm/min a delay of 1 ms makes 0.0005 mm.

use super::{FALSE_TRIGGER, NO_MOVEMENT, PROBE_FAIL};
use crate::catalogue::prelude::*;
use crate::machine::MotionKind;

/// First approach, mm/min.
const FAST: f64 = 600.0;
/// Back off the surface, mm/min.
pub const MEDIUM: f64 = 200.0;
/// Measuring, mm/min.
pub const SLOW: f64 = 30.0;
/// Protected positioning between the touches, mm/min: the default of G101 (C:115).
pub const POSITIONING: f64 = 1500.0;
/// Way back off the surface, mm.
pub const BACK: f64 = 1.0;

/// Calibration of the stylus in one axis of the plane, mm (C:304-307, C:176-177). The data are in the basic system
/// of the machine and are converted for whichever is active (C:92-94).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibration {
    /// Ball centre minus spindle axis (#504, #505).
    pub offset: f64,
    /// Effective ball radius in + direction (#500, #502).
    pub plus: f64,
    /// Effective ball radius in − direction (#501, #503).
    pub minus: f64,
}

impl Calibration {
    /// Of the first (0) or second (1) axis of the plane.
    pub fn of(machine: &mut dyn Machine, index: usize) -> Calibration {
        let control = machine.control();
        let names = [["#504", "#500", "#501"], ["#505", "#502", "#503"]][index.min(1)];
        let [offset, plus, minus] = names.map(|name| control.basic_length(name));
        Calibration { offset, plus, minus }
    }

    /// Effective ball radius when moving in this direction (±1).
    pub fn radius(&self, direction: f64) -> f64 {
        if direction > 0.0 { self.plus } else { self.minus }
    }
}

/// Touches along one axis from where the machine stands; `end` is the coordinate at which the overtravel is used up.
/// The coordinate of the spindle at the slow signal. The machine stays at the surface.
pub fn touch(machine: &mut dyn Machine, axis: usize, end: f64) -> Result<f64, Stop> {
    let start = machine.position();
    let with = |value: f64| {
        let mut position = start;
        position[axis] = value;
        position
    };
    let way = end - start[axis];
    if way == 0.0 {
        return Err(Stop::Alarm(NO_MOVEMENT));
    }
    let fast = signal(machine, with(end).0, FAST)?;
    let back = BACK.min((fast[axis] - start[axis]).abs()).copysign(way);
    machine.travel(with(fast[axis] - back), MotionKind::Retract, MEDIUM, true)?;
    Ok(signal(machine, with(end).0, SLOW)?[axis])
}

/// Probes; where the signal came. No signal is PROBE FAIL; one that is gone when the stylus stands is FALSE TRIGGER.
fn signal(machine: &mut dyn Machine, to: [f64; 3], feed: f64) -> Result<[f64; 3], Stop> {
    match machine.probe(Wcs(to), feed)? {
        None => Err(Stop::Alarm(PROBE_FAIL)),
        Some(_) if !machine.signal_stands() => Err(Stop::Alarm(FALSE_TRIGGER)),
        Some(position) => Ok(position.0),
    }
}
