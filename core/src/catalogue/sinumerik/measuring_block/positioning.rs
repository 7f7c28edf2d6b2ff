//! Ways of the probe between its measuring blocks, watched or in rapid traverse.

use crate::catalogue::prelude::*;
use crate::geometry::{Around, TOLERANCE};
use crate::machine::route::Route;
use crate::machine::trace::MotionKind;

/// Whether two coordinates are more than the last bits of a sum apart: what is shorter is no motion.
fn apart(one: f64, other: f64) -> bool {
    (one - other).abs() > TOLERANCE
}

impl Block {
    /// Intermediate positioning to a place. A target beyond a software limit switch is alarm 61401: what
    /// the setpoint asks for cannot be reached (A:15920).
    pub fn travel(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let from = machine.position();
        if machine.control().limited(from, to).is_some() {
            return Err(alarm(machine, 61401));
        }
        self.go(machine, to)
    }

    /// Intermediate positioning along one axis to this coordinate, mm.
    pub fn travel_along(&self, machine: &mut dyn Machine, axis: usize, to: f64) -> Result<(), Stop> {
        let mut place = machine.position();
        place[self.axes[axis]] = to;
        self.travel(machine, place)
    }

    /// Intermediate positioning in the plane to abscissa and ordinate, mm.
    pub fn travel_in_plane(&self, machine: &mut dyn Machine, to: [f64; 2]) -> Result<(), Stop> {
        let place = self.placed(machine.position().0, to);
        self.travel(machine, Wcs(place))
    }

    /// Intermediate positioning that ends at a software limit switch; whether it did (A:15921).
    pub fn travel_as_far(&self, machine: &mut dyn Machine, to: Wcs) -> Result<bool, Stop> {
        let from = machine.position();
        let limited = machine.control().limited(from, to);
        self.go(machine, limited.unwrap_or(to))?;
        Ok(limited.is_some())
    }

    /// Intermediate positioning of the ball on an arc about a point of the plane (abscissa, ordinate, mm), degree
    /// positive from abscissa to ordinate, at its own feed in mm/min (B:6911-6913). Limits as in [`Block::travel`].
    pub fn travel_around(
        &self,
        machine: &mut dyn Machine,
        centre: [f64; 2],
        degrees: Degrees,
        feed: f64,
    ) -> Result<(), Stop> {
        let [abscissa, ordinate, applicate] = self.axes;
        let from = machine.position();
        let mut around = Around { centre: from, axis: Dir::default(), degrees };
        around.centre[abscissa] = centre[0] - self.skew[0];
        around.centre[ordinate] = centre[1] - self.skew[1];
        around.axis[applicate] = 1.0;
        let to = around.end(from, 0.0);
        let control = machine.control();
        let on_machine = Route {
            from: control.to_machine(from),
            to: control.to_machine(to),
            around: around.mapped(|point| control.to_machine(point)),
        };
        if !on_machine.within_limits(control) {
            return Err(alarm(machine, 61401)); // A:15920
        }
        told(machine, |machine| machine.travel_around(to, &around, MotionKind::Positioning, feed, self.monitored))
    }

    /// Monitored: `_SPEED[1]` in the plane, `_SPEED[2]` in the applicate; else rapid traverse (B:13743-13763).
    fn go(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let from = machine.position();
        if (0..3).all(|axis| !apart(from[axis], to[axis])) {
            return Ok(());
        }
        if !self.monitored {
            return machine.travel(to, MotionKind::Rapid, 0.0, false);
        }
        let feed = self.positioning_feed(from, to);
        told(machine, |machine| machine.travel(to, MotionKind::Positioning, feed, true))
    }

    /// Feed between two places, mm/min.
    pub(super) fn positioning_feed(&self, from: Wcs, to: Wcs) -> f64 {
        let [abscissa, ordinate, _] = self.axes;
        let moves = |axis: usize| apart(from[axis], to[axis]);
        if moves(abscissa) || moves(ordinate) { self.feed_plane } else { self.feed_depth }
    }
}

/// A motion whose alarm is a result of the cycle too.
fn told(machine: &mut dyn Machine, travel: impl FnOnce(&mut dyn Machine) -> Result<(), Stop>) -> Result<(), Stop> {
    match travel(machine) {
        Err(Stop::Alarm(Code::Alarm(number))) => Err(alarm(machine, number)),
        outcome => outcome,
    }
}
