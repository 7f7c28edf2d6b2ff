//! What CYCLE977 does: the order of probing, the ways between, what follows (B:5773-5809, B:5892-5957).

use super::element::Element;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::centred::{Found, Pair};
use crate::catalogue::sinumerik::measuring_block::{Block, Point, all_calibrated};
use crate::catalogue::sinumerik::target::Target;

/// Runs the cycle from the present position, which is the set centre.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let element = Element::of(inputs);
    results::begin(machine, inputs, 977);
    results::integer(machine, 3, inputs.variant);
    let block = Block::prepare(machine, inputs)?;
    let paths = element.paths(&block).map_err(|number| alarm(machine, number))?;
    let sides: Vec<_> = element.axes.iter().flat_map(|axis| [(*axis, 1.0), (*axis, -1.0)]).collect();
    all_calibrated(machine, &block, &sides)?;
    let target = Target::of(machine, inputs, element.single())?;
    let probing = Probing { block: &block, element: &element, paths, start: machine.position().0 };
    until_done(|repetition| {
        let found = probing.measure(machine)?;
        target.finish(machine, inputs, &found, repetition)
    })
}

/// An element that is touched about the position at the call, X Y Z of the WCS, mm.
struct Probing<'a> {
    block: &'a Block,
    element: &'a Element,
    paths: [f64; 2],
    start: [f64; 3],
}

impl Probing<'_> {
    /// Touches all sides and ends above the measured centre at the height of the start (B:5957).
    fn measure(&self, machine: &mut dyn Machine) -> Result<Found, Stop> {
        let Probing { block, element, start, .. } = self;
        let set = [start[block.axes[0]], start[block.axes[1]]];
        let (mut size, mut centre) = (element.size, set);
        for axis in element.axes.iter().copied() {
            let plus = self.touch(machine, axis, 1.0, centre)?;
            let minus = self.touch(machine, axis, -1.0, centre)?;
            centre[axis] = (plus + minus) / 2.0;
            size[axis] = plus - minus;
            block.travel(machine, Wcs(block.placed(*start, centre)))?;
        }
        let pair = |axis: usize, set: [f64; 2], actual: [f64; 2]| Pair { set: set[axis], actual: actual[axis] };
        Ok(Found {
            sizes: element.sizes().iter().map(|axis| pair(*axis, element.size, size)).collect(),
            centre: [0, 1].map(|axis| pair(axis, set, centre)),
            height: block.ball_at(*start)[block.axes[2]] + element.infeed,
            axes: element.axes,
            inside: element.inside,
        })
    }

    /// The side of an axis, +1 or -1: to the start of its measuring block, there down by the infeed, measure, up again.
    /// Sideways the ball runs through the centre found so far.
    fn touch(&self, machine: &mut dyn Machine, axis: usize, side: f64, centre: [f64; 2]) -> Result<f64, Stop> {
        let Probing { block, element, paths, start } = self;
        let direction = if element.inside { side } else { -side };
        let set = start[block.axes[axis]] + side * element.size[axis] / 2.0;
        let point = Point { axis, direction, set, path: paths[axis] };
        let other = 1 - axis;
        let mut beside = *start;
        beside[block.axes[other]] = centre[other] - block.skew[other];
        block.travel_along(machine, other, beside[block.axes[other]])?;
        beside[block.axes[axis]] = block.start(&point);
        let shortened = match element.inside {
            true => block.travel(machine, Wcs(beside)).map(|()| false)?,
            false => block.travel_as_far(machine, Wcs(beside))?,
        };
        let beside = machine.position();
        match block.travel_along(machine, 2, beside[block.axes[2]] + element.infeed) {
            // a collision after a way in the plane that a software limit switch shortened (A:15921)
            Err(Stop::Alarm(Code::Alarm(61302))) if shortened => return Err(alarm(machine, 61402)),
            outcome => outcome?,
        }
        let coordinate = block.measure(machine, &point)?;
        block.travel(machine, beside)?;
        Ok(coordinate)
    }
}
