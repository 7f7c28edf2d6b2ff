//! Calibration in a hole (B:5120-5340): what is touched, and what follows from it.
//!
//! Places are counted in the axes of calibration from the position at the call, mm. The ball rarely runs through the
//! middle of the hole: its skew, and an unknown centre, let it meet the wall on a chord. How far beside the middle
//! that was is measured with it, so that every touch is calculated as if it had led through the middle.

use super::directions::{Direction, angle, directions, in_plane, turned};
use super::params::{BALL, SKEW, UNKNOWN};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::calibration;
use crate::catalogue::sinumerik::calibration::{Calibration, Trigger};
use crate::catalogue::sinumerik::measuring_block::Ray;

/// A hole to be touched.
struct Hole<'a> {
    /// The probe as if it had never been calibrated.
    block: Block,
    /// Ball centre minus spindle axis as stored, in the axes of calibration; 0 for a mono probe.
    skew: [f64; 2],
    start: Wcs,
    directions: Vec<Direction>,
    inputs: &'a Inputs,
}

/// A touch of the wall: where the spindle stood along its axis and across it.
struct Touch {
    direction: Direction,
    along: f64,
    across: f64,
}

/// Touches the hole about the position `start` and ends in its middle at the height of the start.
pub fn measure(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, start: Wcs) -> Result<Calibration, Stop> {
    let hole = Hole {
        block: block.uncalibrated(),
        skew: turned(block.skew, angle(inputs)),
        start,
        directions: directions(inputs),
        inputs,
    };
    let (touches, centre) =
        if UNKNOWN.holds(inputs) { hole.reversed(machine)? } else { (hole.run(machine, [0.0; 2])?, [0.0; 2]) };
    hole.block.travel(machine, hole.position(centre))?;
    Ok(hole.evaluate(machine, &touches, centre))
}

impl Hole<'_> {
    /// A place as position X Y Z of the WCS.
    fn position(&self, place: [f64; 2]) -> Wcs {
        let [abscissa, ordinate] = in_plane(place, angle(self.inputs));
        let mut position = self.start;
        position[self.block.axes[0]] += abscissa;
        position[self.block.axes[1]] += ordinate;
        position
    }

    /// A position in the plane, abscissa and ordinate, as a place.
    fn place(&self, [abscissa, ordinate]: [f64; 2]) -> [f64; 2] {
        turned(
            [abscissa - self.start[self.block.axes[0]], ordinate - self.start[self.block.axes[1]]],
            angle(self.inputs),
        )
    }

    /// Both runs, the first with the spindle turned by 180°: the touches of the second, and the centre of the hole,
    /// which lies between those of the runs (B:5326-5332). A mono probe follows the directions in both, and the second,
    /// which begins nearer to the centre, counts.
    fn reversed(&self, machine: &mut dyn Machine) -> Result<(Vec<Touch>, [f64; 2]), Stop> {
        let usual = machine.control().spindle;
        let reversed = self.block.reverse(machine, usual + Degrees(180.0));
        let turned = self.run(machine, [0.0; 2])?;
        let first = self.middle(&turned);
        self.block.reverse(machine, usual);
        let touches = self.run(machine, first)?;
        let second = self.middle(&touches);
        let between = std::array::from_fn(|axis| (first[axis] + second[axis]) / 2.0);
        Ok((touches, if reversed { between } else { second }))
    }

    /// All directions. Where the centre is not known, the second axis is touched through the middle of the first.
    fn run(&self, machine: &mut dyn Machine, from: [f64; 2]) -> Result<Vec<Touch>, Stop> {
        let mut centre = from;
        let mut touches = Vec::new();
        for (index, direction) in self.directions.iter().enumerate() {
            let turn = index > 0 && self.directions[index - 1].axis != direction.axis;
            if turn && UNKNOWN.holds(self.inputs) {
                centre = self.middle_of(&touches, centre);
            }
            if index == 0 || turn {
                self.block.travel(machine, self.position(centre))?;
            }
            touches.push(self.touch(machine, *direction, centre)?);
        }
        Ok(touches)
    }

    /// One direction on the line through a place.
    fn touch(&self, machine: &mut dyn Machine, direction: Direction, centre: [f64; 2]) -> Result<Touch, Stop> {
        let mut wall = centre;
        wall[direction.axis] += direction.sign * self.inputs.number(names::SETVAL) / 2.0;
        let wall = self.position(wall);
        let ray = Ray {
            angle: angle(self.inputs) + direction.degrees(),
            set: [wall[self.block.axes[0]], wall[self.block.axes[1]]],
            path: self.block.path,
        };
        let place = self.place(self.block.latch_along(machine, &ray)?);
        Ok(Touch { direction, along: place[direction.axis], across: place[1 - direction.axis] })
    }

    /// Where the spindle stands when the ball is in the middle of a hole about the start; by the stored skew in an axis
    /// of which not both directions were touched.
    fn middle(&self, touches: &[Touch]) -> [f64; 2] {
        self.middle_of(touches, self.skew.map(|skew| -skew))
    }

    /// The middle between opposite touches; in other axes the given one.
    fn middle_of(&self, touches: &[Touch], otherwise: [f64; 2]) -> [f64; 2] {
        let mut middle = otherwise;
        for (axis, middle) in middle.iter_mut().enumerate() {
            let of_axis = touches.iter().filter(|touch| touch.direction.axis == axis);
            if let [plus, minus] = of_axis.collect::<Vec<_>>()[..] {
                *middle = (plus.along + minus.along) / 2.0;
            }
        }
        middle
    }

    fn evaluate(&self, machine: &mut dyn Machine, touches: &[Touch], centre: [f64; 2]) -> Calibration {
        let middle = self.middle(touches);
        let triggers: Vec<Trigger> = touches.iter().map(|touch| self.trigger(touch, middle, centre)).collect();
        let [x, y, _] = self.block.axes;
        let position = self.position(centre);
        let stored = calibration::skew(machine.control(), self.inputs);
        let skew = self.skew(stored, [0, 1].map(|axis| centre[axis] - middle[axis]));
        Calibration {
            ball: BALL.holds(self.inputs).then(|| diameter(&triggers)),
            skew: if SKEW.holds(self.inputs) { skew.map(Some) } else { [None; 2] },
            centre: UNKNOWN.holds(self.inputs).then(|| [position[x], position[y]]),
            triggers,
            length: None,
        }
    }

    /// Position at switching minus wall on a line through the middle.
    fn trigger(&self, touch: &Touch, middle: [f64; 2], centre: [f64; 2]) -> Trigger {
        let Direction { axis, sign } = touch.direction;
        let aside = touch.across - middle[1 - axis];
        let reach = (touch.along - middle[axis]).hypot(aside);
        Trigger {
            axis,
            sign,
            value: middle[axis] - centre[axis] + sign * (reach - self.inputs.number(names::SETVAL) / 2.0),
        }
    }

    /// Skew in abscissa and ordinate: as found in the axes that were touched from both sides, else as stored.
    fn skew(&self, stored: [f64; 2], found: [f64; 2]) -> [f64; 2] {
        let mut skew = turned(stored, angle(self.inputs));
        for direction in &self.directions {
            skew[direction.axis] = found[direction.axis];
        }
        in_plane(skew, angle(self.inputs))
    }
}

/// Mean of the diameters that the touched axes give.
fn diameter(triggers: &[Trigger]) -> f64 {
    let sum: f64 = triggers.iter().map(|trigger| -trigger.sign * trigger.value).sum();
    2.0 * sum / triggers.len().max(1) as f64
}
