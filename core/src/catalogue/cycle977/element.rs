//! What a call of CYCLE977 measures, read from variant and sizes.

use crate::catalogue::sinumerik::measuring_block::Block;
use crate::entry::{Inputs, names};

/// The element. Axes count 0 abscissa, 1 ordinate; lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Element {
    /// Hole or shaft.
    pub round: bool,
    /// Rectangle, inside or outside.
    pub rectangle: bool,
    /// Hole, groove, inside rectangle.
    pub inside: bool,
    /// Diameter, width or length by axis.
    pub size: [f64; 2],
    /// Protection zone by axis.
    pub zone: Option<[f64; 2]>,
    /// From the height of the start to the measuring height along the applicate; 0 where measuring begins inside.
    pub infeed: f64,
    /// Measuring axis of groove and web.
    axis: usize,
}

impl Element {
    /// Digits of `_MVAR`: units element, thousands protection zone (B:5641-5667).
    pub fn of(inputs: &Inputs) -> Element {
        let digit = |place: i64| inputs.variant / place % 10;
        let kind = digit(1);
        let rectangle = kind >= 5;
        let inside = kind % 2 == 1;
        let pair = |one: f64, two: f64| if rectangle { [one, two] } else { [one; 2] };
        let size = match rectangle {
            true => [inputs.number(names::SETV0), inputs.number(names::SETV1)],
            false => [inputs.number(names::SETVAL); 2],
        };
        let zoned = digit(1000) == 1;
        Element {
            round: kind <= 2,
            rectangle,
            inside,
            size,
            zone: zoned.then(|| pair(inputs.number(names::SZA), inputs.number(names::SZO))),
            infeed: if inside && !zoned { 0.0 } else { inputs.number(names::ID) },
            axis: if inputs.number(names::MA) as i64 == 2 { 1 } else { 0 },
        }
    }

    /// Axes to be probed, in order.
    pub fn axes(&self) -> &'static [usize] {
        match (self.round || self.rectangle, self.axis) {
            (true, _) => &[0, 1],
            (false, 0) => &[0],
            (false, _) => &[1],
        }
    }

    /// Axes whose size is a result: both of a rectangle, the ordinate for a diameter (B:5773), else the measuring axis.
    pub fn sizes(&self) -> &'static [usize] {
        match (self.rectangle, self.round) {
            (true, _) => &[0, 1],
            (_, true) => &[1],
            _ => self.axes(),
        }
    }

    /// Measuring path by axis: `_FA`, reduced so that the ball stays out of the protection zone inside, and within it
    /// outside (B:5943-5951). Error 61334: no room is left (A:15877).
    pub fn paths(&self, block: &Block) -> Result<[f64; 2], u32> {
        let mut paths = [block.path; 2];
        if let Some(zone) = self.zone {
            for axis in self.axes().iter().copied() {
                let between = (self.size[axis] - zone[axis]) / 2.0;
                let room = if self.inside { between } else { -between } - 2.0 * block.radius;
                if room <= 0.0 {
                    return Err(61334);
                }
                paths[axis] = paths[axis].min(room);
            }
        }
        Ok(paths)
    }
}
