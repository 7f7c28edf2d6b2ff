//! What CYCLE979 does: points at angles about the set centre, the ways between them, what follows (B:6835-6945).

use super::params::{FOUR_POINTS, OUTSIDE, ROUND};
use crate::catalogue::circle;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::centred::{Found, Pair};
use crate::catalogue::sinumerik::measuring_block::{Block, Ray, ball_known};
use crate::catalogue::sinumerik::target::Target;
use crate::geometry::{Degrees, fit};

/// The element as the call describes it; mm and degree.
struct Element {
    round: bool,
    inside: bool,
    size: f64,
    centre: [f64; 2],
    /// Direction from the centre to each point, in order.
    angles: Vec<f64>,
    /// From point to point of a circle.
    step: f64,
    /// Feed on the circle, mm/min.
    feed: f64,
    /// Way up over a web.
    lift: f64,
}

impl Element {
    fn of(inputs: &Inputs) -> Element {
        let round = ROUND.holds(inputs);
        let (start, step) = (inputs.number(names::STA1), inputs.number(names::INCA));
        Element {
            round,
            inside: !OUTSIDE.holds(inputs),
            size: inputs.number(names::SETVAL),
            centre: [inputs.number(names::CPA), inputs.number(names::CPO)],
            angles: match round {
                true => circle::points(start, step, FOUR_POINTS.holds(inputs)),
                false => vec![start, start + 180.0],
            },
            step,
            feed: inputs.number(names::RF),
            lift: inputs.number(names::ID),
        }
    }

    /// The measuring block of a point: inside away from the centre, outside towards it.
    fn ray(&self, angle: f64, path: f64) -> Ray {
        let (sine, cosine) = Degrees(angle).sin_cos();
        let [x, y] = self.centre;
        let half = self.size / 2.0;
        Ray { angle: if self.inside { angle } else { angle + 180.0 }, set: [x + half * cosine, y + half * sine], path }
    }

    /// Size and centre from where the ball stood at the points, all at one height; none: no circle goes through them.
    fn evaluate(&self, balls: &[[f64; 2]], ball: f64, height: f64) -> Option<Found> {
        let (centre, between) = match (self.round, balls) {
            (true, _) => fit::circle(balls).map(|(centre, radius)| (centre, 2.0 * radius))?,
            (false, [one, other]) => {
                let centre = [0, 1].map(|axis| (one[axis] + other[axis]) / 2.0);
                (centre, (one[0] - other[0]).hypot(one[1] - other[1]))
            }
            _ => return None,
        };
        let around = if self.inside { 2.0 } else { -2.0 } * ball;
        Some(Found {
            sizes: vec![Pair { set: self.size, actual: between + around }],
            centre: [0, 1].map(|axis| Pair { set: self.centre[axis], actual: centre[axis] }),
            height,
            axes: &[0, 1],
            inside: self.inside,
        })
    }
}

/// Runs the cycle from the present position: at measuring height, on a free straight line to the start of P1.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 979);
    let block = Block::prepare(machine, inputs)?;
    ball_known(machine, &block)?;
    let element = Element::of(inputs);
    if element.round && element.feed <= 0.0 {
        return Err(alarm(machine, 61365));
    }
    let target = Target::of(machine, inputs, None)?;
    until_done(|repetition| {
        if repetition > 0 {
            back(machine, &block, &element)?;
        }
        let balls = measure(machine, &block, &element)?;
        let height = block.ball_at(machine.position().0)[block.axes[2]];
        let Some(found) = element.evaluate(&balls, block.ball, height) else { return Err(alarm(machine, 61316)) };
        target.finish(machine, inputs, &found, repetition)
    })
}

/// Touches all points in order; where the ball centre stood at each. Ends at the start of the last block (B:6939).
fn measure(machine: &mut dyn Machine, block: &Block, element: &Element) -> Result<Vec<[f64; 2]>, Stop> {
    let mut balls = Vec::new();
    for (index, angle) in element.angles.iter().enumerate() {
        let ray = element.ray(*angle, block.path);
        if index > 0 {
            onward(machine, block, element, &ray, Degrees(element.step))?;
        }
        balls.push(block.ball_along(machine, &ray)?);
    }
    Ok(balls)
}

/// To the next point: on the circle, straight through a groove, over a web (B:6907-6933). The ball, not the spindle
/// axis, keeps to the line.
fn onward(
    machine: &mut dyn Machine,
    block: &Block,
    element: &Element,
    ray: &Ray,
    degrees: Degrees,
) -> Result<(), Stop> {
    match (element.round, element.inside) {
        (true, _) => block.travel_around(machine, element.centre, degrees, element.feed),
        (false, true) => Ok(()),
        (false, false) => across(machine, block, element, ray),
    }
}

/// Up by `_ID`, straight to above the other side, down again (B:6921-6933).
fn across(machine: &mut dyn Machine, block: &Block, element: &Element, ray: &Ray) -> Result<(), Stop> {
    let [abscissa, ordinate, applicate] = block.axes;
    let here = machine.position();
    let mut to = here;
    to[applicate] += element.lift;
    block.travel(machine, to)?;
    [to[abscissa], to[ordinate]] = block.start_along(ray);
    block.travel(machine, to)?;
    to[applicate] = here[applicate];
    block.travel(machine, to)
}

/// Back to the first point the way that led to the last one, to measure again.
fn back(machine: &mut dyn Machine, block: &Block, element: &Element) -> Result<(), Stop> {
    let Some(first) = element.angles.first() else { return Ok(()) };
    let steps = (element.angles.len() - 1) as f64;
    let ray = element.ray(*first, block.path);
    onward(machine, block, element, &ray, Degrees(-steps * element.step))
}
