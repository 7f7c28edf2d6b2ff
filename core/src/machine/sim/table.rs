//! A rotary axis turns the part, and what it meets on its way: the ball of the probe, its stylus and its body.

use super::Sim;
use crate::geometry::{Around, Degrees, Dir, Mcs, Rod, V3};
use crate::machine::{Route, Step, Stop};
use crate::message::Message;
use crate::workpiece::{Feeler, Obstacle, Touching, Workpiece};

impl Sim {
    /// Turns a rotary axis (index A B C) to a position of the machine; the part turns with it. Where it meets
    /// the probe it stands still and the run ends: no signal is watched on this way.
    pub(crate) fn turn_table(&mut self, axis: usize, to: Degrees) -> Result<(), Stop> {
        let Some(from) = self.control.rotary.get(axis).copied() else { return Ok(()) };
        if !to.0.is_finite() {
            return Err(Stop::Fault(Message::new("run-not-finite")));
        }
        // after a whole circle everything has passed by
        let turn = Around {
            centre: self.control.rotary_centre,
            axis: self.control.rotary_direction(axis),
            degrees: Degrees((to - from).0.clamp(-360.0, 360.0)),
        };
        let met = self.met_by(&turn);
        let stop = met.map_or(to, |met| from + turn.degrees * met.part);
        self.control.rotary[axis] = stop;
        let Workpiece { solids } = self.stands();
        self.note(Step::Table { axis, from, to: stop, solids });
        let Some(met) = met else { return Ok(()) };
        let back = Around { degrees: turn.degrees * -met.part, ..turn };
        let [point, tip] = [met.point, met.point + met.normal].map(|place| back.end(place, 0.0));
        Err(self.crash(&Obstacle { point, normal: tip - point, ..met }))
    }

    /// What of the probe a part meets first that turns against `turn`: seen from the part the probe goes round it.
    fn met_by(&mut self, turn: &Around<Mcs>) -> Option<Obstacle> {
        if self.still || turn.degrees == Degrees(0.0) {
            return None;
        }
        let probe = self.has_probe();
        let (feeler, shift) = if probe { (self.feeler(), self.ball()) } else { self.cutting()? };
        let ball = self.position + shift;
        let stylus = feeler.rods().flat_map(|(by, rod)| balls(rod, by, ball));
        let pieces = std::iter::once((ball, feeler.radius, Touching::Ball)).chain(stylus);
        let mut first: Option<Obstacle> = None;
        for (place, radius, by) in pieces {
            let part = first.map_or(1.0, |met| met.part);
            let way = Route {
                from: place,
                to: turn.at(place, turn.end(place, 0.0), part),
                around: Some(Around { degrees: turn.degrees * part, ..*turn }),
            };
            let ball = Feeler::ball(radius);
            if let Some(met) = way.obstacle(&self.part, &ball, Dir::default(), &mut self.effort) {
                let (part, by) = (met.part * part, if probe { by } else { Touching::Cutter });
                first = Some(Obstacle { by, part, ..met });
            }
        }
        first
    }
}

/// Most balls that stand for a stylus or a body.
const BALLS: f64 = 1000.0;

/// Balls so close together that they make stylus or body, as far as the spindle.
fn balls(rod: Rod, by: Touching, ball: Mcs) -> impl Iterator<Item = (Mcs, f64, Touching)> {
    let apart = rod.radius.max(rod.length / BALLS);
    let count = (rod.length / apart) as usize;
    (1..=count).map(move |step| {
        let place = V3::from(ball.0) + rod.foot + rod.up * (step as f64 * apart);
        (place.into(), rod.radius, by)
    })
}
