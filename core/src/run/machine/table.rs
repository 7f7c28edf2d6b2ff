//! A rotary axis turns the part, and what it meets on its way: the ball of the probe and its stylus.

use super::Sim;
use crate::geometry::arc::Around;
use crate::message::Message;
use crate::run::Stop;
use crate::run::route::{Obstacle, Route, add};
use crate::run::trace::Step;
use crate::workpiece::Workpiece;

/// Radius of the stylus in radii of its ball, as it is drawn.
const STYLUS: f64 = 0.45;

impl Sim {
    /// Turns a rotary axis (index A B C) to a position of the machine, degree; the part turns with it. Where it meets the
    /// probe it stands still and the run ends: no signal is watched on this way.
    pub fn turn_table(&mut self, axis: usize, to: f64) -> Result<(), Stop> {
        let Some(from) = self.control.rotary.get(axis).copied() else {
            return Ok(());
        };
        let turn = Around {
            centre: self.control.rotary_centre,
            axis: self.control.rotary_direction(axis),
            degrees: to - from,
        };
        let met = self.met_by(&turn);
        let stop = met.map_or(to, |met| from + met.part * (to - from));
        self.control.rotary[axis] = stop;
        let Workpiece { solids } = self.stands();
        self.note(Step::Table {
            axis,
            from,
            to: stop,
            solids,
        });
        let Some(met) = met else {
            return Ok(());
        };
        let back = Around {
            degrees: -met.part * turn.degrees,
            ..turn
        };
        let point = back.end(met.point, 0.0);
        self.note(Step::Crash { point });
        Err(Stop::Fault(Message::new("run-crash")))
    }

    /// What of the probe a part meets first that turns against `turn`: seen from the part the probe goes round it.
    fn met_by(&self, turn: &Around) -> Option<Obstacle> {
        if !self.has_probe() || turn.degrees == 0.0 {
            return None;
        }
        let ball = add(self.position, self.ball(), 1.0);
        let pieces = std::iter::once((ball, self.probe.radius)).chain(self.stylus(ball));
        let met = pieces.filter_map(|(place, radius)| {
            let way = Route {
                from: place,
                to: turn.end(place, 0.0),
                around: Some(*turn),
            };
            way.obstacle(&self.part, radius, [0.0; 3])
        });
        met.min_by(|a, b| a.part.total_cmp(&b.part))
    }

    /// Balls so close together that they make the stylus above the ball, as far as the spindle; in a turret the stylus
    /// has no length that is known.
    fn stylus(&self, ball: [f64; 3]) -> impl Iterator<Item = ([f64; 3], f64)> {
        let (axis, radius) = (self.tool_axis(), STYLUS * self.probe.radius);
        let length = if self.in_turret() {
            0.0
        } else {
            self.probe.length
        };
        let count = (length / radius) as usize;
        (1..=count).map(move |step| {
            let mut place = ball;
            place[axis] += step as f64 * radius;
            (place, radius)
        })
    }
}
