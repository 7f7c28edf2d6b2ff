//! What CYCLE979 does: points at angles about the set centre, the ways between them, what follows (B:6835-6945).

use super::params::{FOUR_POINTS, OUTSIDE, ROUND};
use crate::catalogue::circle;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::centred::{Found, Pair};
use crate::catalogue::sinumerik::measuring_block::{Block, Ray, ball_known};
use crate::catalogue::sinumerik::target::Target;
use crate::geometry::fit;

/// Runs the cycle from the present position: at measuring height, on a free straight line to the start of P1.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 979);
    let block = Block::prepare(machine, inputs)?;
    ball_known(machine, &block)?;
    if ROUND.holds(inputs) && inputs.number(names::RF) <= 0.0 {
        return Err(alarm(machine, 61365));
    }
    let target = Target::of(machine, inputs, None)?;
    let probing = Probing::of(inputs, &block);
    until_done(|repetition| {
        if repetition > 0 {
            let steps = (probing.rays.len() - 1) as f64;
            probing.onward(machine, &probing.rays[0], -steps)?; // the way that led to the last point
        }
        let balls = probing.balls(machine)?;
        let height = block.ball_at(machine.position().0)[block.axes[2]];
        let Some(found) = probing.evaluate(&balls, height) else { return Err(alarm(machine, 61316)) };
        target.finish(machine, inputs, &found, repetition)
    })
}

/// The element as the call describes it, and the measuring blocks of its points in order.
struct Probing<'a> {
    inputs: &'a Inputs,
    block: &'a Block,
    round: bool,
    inside: bool,
    /// Diameter or width, mm.
    size: f64,
    /// Set centre, mm.
    centre: [f64; 2],
    rays: Vec<Ray>,
}

impl<'a> Probing<'a> {
    fn of(inputs: &'a Inputs, block: &'a Block) -> Self {
        let (round, inside) = (ROUND.holds(inputs), !OUTSIDE.holds(inputs));
        let [size, abscissa, ordinate] = [names::SETVAL, names::CPA, names::CPO].map(|name| inputs.number(name));
        let [start, step] = [names::STA1, names::INCA].map(|name| inputs.degrees(name));
        let centre = [abscissa, ordinate];
        let angles = match round {
            true => circle::points(start, step, FOUR_POINTS.holds(inputs)),
            false => vec![start, start + Degrees(180.0)],
        };
        let ray = |angle| Ray::at(angle, centre, size / 2.0, inside, block.path);
        Probing { inputs, block, round, inside, size, centre, rays: angles.into_iter().map(ray).collect() }
    }

    /// Touches all points; where the ball centre stood at each. Ends at the start of the last block (B:6939).
    fn balls(&self, machine: &mut dyn Machine) -> Result<Vec<[f64; 2]>, Stop> {
        let mut balls = Vec::new();
        for (index, ray) in self.rays.iter().enumerate() {
            if index > 0 {
                self.onward(machine, ray, 1.0)?;
            }
            balls.push(self.block.ball_along(machine, ray)?);
        }
        Ok(balls)
    }

    /// To another point: so many steps on the circle, straight through a groove, over a web by `_ID` (B:6907-6933). The
    /// ball, not the spindle axis, keeps to the line.
    fn onward(&self, machine: &mut dyn Machine, ray: &Ray, steps: f64) -> Result<(), Stop> {
        let Probing { inputs, block, .. } = self;
        if self.round {
            let (step, feed) = (inputs.degrees(names::INCA), inputs.number(names::RF));
            return block.travel_around(machine, self.centre, step * steps, feed);
        }
        if self.inside {
            return Ok(());
        }
        let height = machine.position()[block.axes[2]];
        block.travel_along(machine, 2, height + inputs.number(names::ID))?;
        block.travel_in_plane(machine, block.start_along(ray))?;
        block.travel_along(machine, 2, height)
    }

    /// Size and centre from where the ball stood at the points, all at one height; none: no circle goes through them.
    fn evaluate(&self, balls: &[[f64; 2]], height: f64) -> Option<Found> {
        let (centre, between) = match (self.round, balls) {
            (false, [one, other]) => {
                let centre = [0, 1].map(|axis| (one[axis] + other[axis]) / 2.0);
                (centre, (one[0] - other[0]).hypot(one[1] - other[1]))
            }
            _ => fit::circle(balls).map(|(centre, radius)| (centre, 2.0 * radius))?,
        };
        let around = if self.inside { 2.0 } else { -2.0 } * self.block.ball;
        Some(Found {
            sizes: vec![Pair { set: self.size, actual: between + around }],
            centre: [0, 1].map(|axis| Pair { set: self.centre[axis], actual: centre[axis] }),
            height,
            axes: &[0, 1],
            inside: self.inside,
        })
    }
}
