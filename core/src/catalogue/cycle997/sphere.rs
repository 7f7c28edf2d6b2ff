//! One sphere: ways, touches and what follows from them (B:8341-8371, B:8419-8475).

use super::params::{ANGLE, DIAMETER, REPEATED};
use super::points;
use super::simulate::failed;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, Ray};
use crate::geometry::{Degrees, fit};

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
    /// From the point to which L1 refers to the ball centre along the applicate, mm (`_CBIT[14]`, B:8204-8208).
    pub tip: f64,
}

impl Plan<'_> {
    /// Measures a sphere, where it is told to a second time about what was found (B:8369). The probe begins and ends at
    /// safety height, at the end above the centre.
    pub fn measure(&self, machine: &mut dyn Machine, set: &Sphere) -> Result<Sphere, Stop> {
        let found = self.once(machine, set)?;
        if REPEATED.holds(self.inputs) {
            return self.once(machine, &found);
        }
        Ok(found)
    }

    fn once(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<Sphere, Stop> {
        let [x, y] =
            if ANGLE.holds(self.inputs) { self.around(machine, expected)? } else { self.crosswise(machine, expected)? };
        self.over(machine, [x, y])?;
        let top = self.block.measure(machine, &self.top(expected))?;
        let mut found = Sphere { centre: [x, y, top - expected.diameter / 2.0], ..*expected };
        if DIAMETER.holds(self.inputs) {
            found.diameter = self.diameter(machine, &found)?;
            found.centre[2] = top - found.diameter / 2.0;
        }
        self.height(machine, self.safety)?;
        self.over(machine, [x, y])?;
        Ok(found)
    }

    /// Four points parallel to the axes; the ordinate through the centre found in the abscissa (B:8437-8445). Every way
    /// is along one axis, but the one between two spheres.
    fn crosswise(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<[f64; 2], Stop> {
        let [x, y, _] = expected.centre;
        let mut centre = [x, y];
        self.over(machine, centre)?;
        for axis in [0, 1] {
            let other = 1 - axis;
            let mut onto = machine.position();
            onto[self.block.axes[other]] = centre[other] - self.block.skew[other];
            self.block.travel(machine, onto)?;
            let mut sides = [0.0; 2];
            for (side, coordinate) in [1.0, -1.0].into_iter().zip(&mut sides) {
                *coordinate = self.side(machine, expected, axis, side)?;
                self.height(machine, self.above(expected))?;
            }
            centre[axis] = (sides[0] + sides[1]) / 2.0;
        }
        Ok(centre)
    }

    /// From beside or above to the side of a sphere, down to its centre, touched. `side`: +1 or -1 along the axis.
    fn side(&self, machine: &mut dyn Machine, expected: &Sphere, axis: usize, side: f64) -> Result<f64, Stop> {
        let point = self.block.point(axis, -side, expected.centre[axis] + side * expected.diameter / 2.0);
        let mut to = machine.position();
        to[self.block.axes[axis]] = self.block.start(&point);
        self.block.travel(machine, to)?;
        self.height(machine, expected.centre[2] - self.tip)?;
        self.block.measure(machine, &point)
    }

    /// Three or four points at an angle towards the set centre, on circular ways between them; CYCLE116 makes the
    /// circle (B:8361, B:8453-8463). The ball centres lie on a circle about the centre of the sphere, however high it
    /// stands.
    fn around(&self, machine: &mut dyn Machine, expected: &Sphere) -> Result<[f64; 2], Stop> {
        let [x, y, applicate] = expected.centre;
        let directions = points::directions(self.inputs);
        let mut balls = Vec::new();
        for (index, angle) in directions.iter().copied().enumerate() {
            let (sine, cosine) = Degrees(angle).sin_cos();
            let set = [x + cosine * expected.diameter / 2.0, y + sine * expected.diameter / 2.0];
            let ray = Ray { angle: angle + 180.0, set, path: self.block.path };
            if index == 0 {
                self.plane(machine, self.block.start_along(&ray))?;
                self.height(machine, applicate - self.tip)?;
            } else {
                let [step, feed] = [names::INCA, names::RF].map(|name| self.inputs.number(name));
                self.block.travel_around(machine, [x, y], Degrees(step), feed)?;
            }
            balls.push(self.block.ball_along(machine, &ray)?);
        }
        self.height(machine, self.above(expected))?;
        Ok(fit::circle(&balls).ok_or_else(|| failed(machine, 61316))?.0)
    }

    /// One more point from the minus side of the abscissa at the height of the centre (B:8371).
    fn diameter(&self, machine: &mut dyn Machine, found: &Sphere) -> Result<f64, Stop> {
        Ok(2.0 * (found.centre[0] - self.side(machine, found, 0, -1.0)?))
    }

    /// The point on top.
    fn top(&self, expected: &Sphere) -> Point {
        self.block.point(2, -1.0, expected.centre[2] + expected.diameter / 2.0)
    }

    /// Height at which the ball crosses a sphere: `_FA` above it (B:8441).
    fn above(&self, expected: &Sphere) -> f64 {
        self.block.start(&self.top(expected))
    }

    /// Moves the ball over a point of the plane.
    fn over(&self, machine: &mut dyn Machine, [x, y]: [f64; 2]) -> Result<(), Stop> {
        let skew = self.block.skew;
        self.plane(machine, [x - skew[0], y - skew[1]])
    }

    /// Moves the spindle axis in the plane.
    fn plane(&self, machine: &mut dyn Machine, [x, y]: [f64; 2]) -> Result<(), Stop> {
        let to = self.block.placed(machine.position().0, [x, y]);
        self.block.travel(machine, Wcs(to))
    }

    /// Moves along the applicate.
    fn height(&self, machine: &mut dyn Machine, applicate: f64) -> Result<(), Stop> {
        let mut to = machine.position();
        to[self.block.axes[2]] = applicate;
        self.block.travel(machine, to)
    }
}
