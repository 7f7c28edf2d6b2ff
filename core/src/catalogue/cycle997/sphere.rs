//! One sphere: ways, touches and what follows from them (B:8341-8371, B:8419-8475).

use super::params::{ANGLE, DIAMETER, REPEATED};
use super::points;
use super::simulate::failed;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, Ray};
use crate::geometry::fit;

/// A sphere as it should be or as it was found, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre: abscissa, ordinate, applicate of the WCS.
    pub centre: [f64; 3],
    /// Diameter.
    pub diameter: f64,
}

/// What all spheres of a call have in common.
pub struct Plan<'a> {
    /// The measuring block.
    pub block: &'a Block,
    /// The call.
    pub inputs: &'a Inputs,
    /// Safety height: applicate at the begin of the cycle, mm.
    pub safety: f64,
}

impl Plan<'_> {
    /// Measures a sphere, where it is told to a second time about what was found (B:8369). The probe begins and ends at
    /// safety height, at the end above the centre.
    pub fn measure(&self, machine: &mut dyn Machine, set: &Sphere) -> Result<Sphere, Stop> {
        let found = self.once(machine, set)?;
        if REPEATED.holds(self.inputs) { self.once(machine, &found) } else { Ok(found) }
    }

    fn once(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<Sphere, Stop> {
        let [x, y] = match ANGLE.holds(self.inputs) {
            true => self.around(machine, expected)?,
            false => self.crosswise(machine, expected)?,
        };
        self.over(machine, [x, y])?;
        let top = self.block.measure(machine, &self.top(expected))?;
        let mut found = Sphere { centre: [x, y, top - expected.diameter / 2.0], ..*expected };
        if DIAMETER.holds(self.inputs) {
            // one more point from the minus side of the abscissa at the height of the centre (B:8371)
            found.diameter = 2.0 * (x - self.side(machine, &found, 0, -1.0)?);
            found.centre[2] = top - found.diameter / 2.0;
        }
        self.block.travel_along(machine, 2, self.safety)?;
        self.over(machine, [x, y])?;
        Ok(found)
    }

    /// Four points parallel to the axes; the ordinate through the centre found in the abscissa (B:8437-8445). Every way
    /// is along one axis, but the one between two spheres.
    fn crosswise(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<[f64; 2], Stop> {
        let block = self.block;
        let [x, y, _] = expected.centre;
        let mut centre = [x, y];
        self.over(machine, centre)?;
        for axis in [0, 1] {
            let other = 1 - axis;
            block.travel_along(machine, other, centre[other] - block.skew[other])?;
            let mut sum = 0.0;
            for side in [1.0, -1.0] {
                sum += self.side(machine, expected, axis, side)?;
                block.travel_along(machine, 2, self.above(expected))?;
            }
            centre[axis] = sum / 2.0;
        }
        Ok(centre)
    }

    /// From beside or above to the side of a sphere, down to its centre, touched. `side`: +1 or -1 along the axis.
    fn side(&self, machine: &mut dyn Machine, expected: &Sphere, axis: usize, side: f64) -> Result<f64, Stop> {
        let point = self.block.point(axis, -side, expected.centre[axis] + side * expected.diameter / 2.0);
        self.block.travel_along(machine, axis, self.block.start(&point))?;
        self.down(machine, expected)?;
        self.block.measure(machine, &point)
    }

    /// Three or four points at an angle towards the set centre, on circular ways between them; CYCLE116 makes the
    /// circle (B:8361, B:8453-8463). The ball centres lie on a circle about the centre of the sphere, however high it
    /// stands.
    fn around(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<[f64; 2], Stop> {
        let Plan { block, inputs, .. } = self;
        let [x, y, _] = expected.centre;
        let (step, feed) = (inputs.degrees(names::INCA), inputs.number(names::RF));
        let mut balls = Vec::new();
        for (index, angle) in points::directions(inputs).into_iter().enumerate() {
            let ray = Ray::at(angle, [x, y], expected.diameter / 2.0, false, block.path);
            if index == 0 {
                block.travel_in_plane(machine, block.start_along(&ray))?;
                self.down(machine, expected)?;
            } else {
                block.travel_around(machine, [x, y], step, feed)?;
            }
            balls.push(block.ball_along(machine, &ray)?);
        }
        block.travel_along(machine, 2, self.above(expected))?;
        Ok(fit::circle(&balls).ok_or_else(|| failed(machine, 61316))?.0)
    }

    /// The point on top.
    fn top(&self, expected: &Sphere) -> Point {
        self.block.point(2, -1.0, expected.centre[2] + expected.diameter / 2.0)
    }

    /// Height at which the ball crosses a sphere: `_FA` above it (B:8441).
    fn above(&self, expected: &Sphere) -> f64 {
        self.block.start(&self.top(expected))
    }

    /// Moves the centre of the ball to the height of that of a sphere; L1 may refer to another point (B:8204-8208).
    fn down(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<(), Stop> {
        self.block.travel_along(machine, 2, expected.centre[2] - self.block.centre)
    }

    /// Moves the ball over a point of the plane.
    fn over(&self, machine: &mut dyn Machine, [x, y]: [f64; 2]) -> Result<(), Stop> {
        let skew = self.block.skew;
        self.block.travel_in_plane(machine, [x - skew[0], y - skew[1]])
    }
}
