//! What a call of CYCLE977 measures, read from variant and sizes.

use super::params::{OUTSIDE, RECTANGLE, ROUND, WIDTH, ZONE};
use crate::catalogue::sinumerik::measuring_block::Block;
use crate::entry::{Inputs, names};

/// The element. Axes count 0 abscissa, 1 ordinate; lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Hole or shaft.
    pub round: bool,
    /// Hole, groove, inside rectangle.
    pub inside: bool,
    /// Axes to be probed, in order; one of groove and web.
    pub axes: &'static [usize],
    /// Diameter, width or length by axis.
    pub size: [f64; 2],
    /// Protection zone by axis.
    pub zone: Option<[f64; 2]>,
    /// From the height of the start to the measuring height along the applicate; 0 where measuring begins inside.
    pub infeed: f64,
}

impl Element {
    /// The element of a variant, in the sizes of a call (B:5641-5667).
    pub fn of(inputs: &Inputs) -> Element {
        let (size, zone) = match RECTANGLE.holds(inputs) {
            true => ([names::SETV0, names::SETV1], [names::SZA, names::SZO]),
            false => ([names::SETVAL; 2], [names::SZA; 2]),
        };
        let (inside, zoned) = (!OUTSIDE.holds(inputs), ZONE.holds(inputs));
        Element {
            round: ROUND.holds(inputs),
            inside,
            axes: match (WIDTH.holds(inputs), inputs.integer(names::MA)) {
                (false, _) => &[0, 1],
                (true, 2) => &[1],
                (true, _) => &[0],
            },
            size: size.map(|name| inputs.number(name)),
            zone: zoned.then(|| zone.map(|name| inputs.number(name))),
            infeed: if inside && !zoned { 0.0 } else { inputs.number(names::ID) },
        }
    }

    /// The axis of a groove or web, which is measured in one alone.
    pub fn single(&self) -> Option<usize> {
        let [axis] = self.axes else { return None };
        Some(*axis)
    }

    /// Axes whose size is a result: the ordinate for a diameter (B:5773), else those that are probed.
    pub fn sizes(&self) -> &'static [usize] {
        if self.round { &[1] } else { self.axes }
    }

    /// Measuring path by axis: `_FA`, reduced so that the ball stays out of the protection zone inside, and within it
    /// outside (B:5943-5951). Error 61334: no room is left (A:15877).
    pub fn paths(&self, block: &Block) -> Result<[f64; 2], u32> {
        let mut paths = [block.path; 2];
        let Some(zone) = self.zone else { return Ok(paths) };
        for axis in self.axes.iter().copied() {
            let between = (self.size[axis] - zone[axis]) / 2.0;
            let room = if self.inside { between } else { -between } - 2.0 * block.radius;
            if room <= 0.0 {
                return Err(61334);
            }
            paths[axis] = paths[axis].min(room);
        }
        Ok(paths)
    }
}
