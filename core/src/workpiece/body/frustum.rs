//! A block whose walls lean, over a rectangle or a parallelogram.

use crate::geometry::V3;
use crate::geometry::quad::{Quad, Trim};
use crate::geometry::rigid::sin_cos;
use crate::workpiece::PartErrors;

/// Two pairs of walls facing each other, a lid and a base. Lengths are counted along the edges: the first along X, the
/// second along the direction that is turned from X by the angle between the edges.
#[derive(Clone, Copy, Debug)]
pub(in crate::workpiece) struct Frustum {
    /// Half lengths at the top, mm.
    pub above: [f64; 2],
    /// Half lengths at the bottom, mm.
    pub below: [f64; 2],
    /// Height of the upper face, mm.
    pub top: f64,
    /// Height of the lower face, mm.
    pub bottom: f64,
    /// Centre along both edges, mm.
    centre: [f64; 2],
    /// Sine and cosine of the angle between the edges.
    opening: (f64, f64),
}

impl Frustum {
    /// With upright walls.
    pub fn upright(half: [f64; 2], top: f64, bottom: f64) -> Frustum {
        Frustum { above: half, below: half, top, bottom, centre: [0.0; 2], opening: (1.0, 0.0) }
    }

    /// From Z = 0 downwards, lengths growing by `taper` mm per mm of depth.
    pub fn tapered(length: [f64; 2], depth: f64, taper: f64) -> Frustum {
        let above = length.map(|l| l / 2.0);
        Frustum { below: above.map(|l| l + taper * depth / 2.0), ..Frustum::upright(above, 0.0, -depth) }
    }

    /// From Z = 0 downwards with a corner at the origin, from which the edges run along X and, turned by `angle`
    /// degree, along a second direction. Each wall stands out by half of the error of size and of what the taper adds.
    pub fn corner(angle: f64, length: [f64; 2], depth: f64, errors: &PartErrors) -> Frustum {
        let opening = sin_cos(angle);
        let along = |across: f64| across / opening.0;
        let whole = length.map(|l| l + along(errors.size));
        Frustum { centre: length.map(|l| l / 2.0), opening, ..Frustum::tapered(whole, depth, along(errors.taper)) }
    }

    /// An upright body around this one, its walls `margin` mm away, `floor` mm deeper.
    pub fn around(&self, margin: f64, floor: f64) -> Frustum {
        let reach = margin / self.opening.0;
        let half = [0, 1].map(|i| self.above[i].max(self.below[i]) + reach);
        Frustum { above: half, below: half, bottom: self.bottom - floor, ..*self }
    }

    pub fn contains(&self, p: &V3) -> bool {
        let (sine, cosine) = self.opening;
        let second = p.y / sine;
        let place = [p.x - second * cosine, second];
        let part = (self.top - p.z) / (self.top - self.bottom);
        let within = |i: usize| {
            let half = self.above[i] + (self.below[i] - self.above[i]) * part;
            (place[i] - self.centre[i]).abs() <= half
        };
        (0.0..=1.0).contains(&part) && within(0) && within(1)
    }

    /// Corners of the upper or lower face, counter-clockwise from (−, −).
    pub fn ring(&self, upper: bool) -> [V3; 4] {
        let ([x, y], z) = if upper { (self.above, self.top) } else { (self.below, self.bottom) };
        let (sine, cosine) = self.opening;
        let [first, second] = self.centre;
        [[-x, -y], [x, -y], [x, y], [-x, y]].map(|[u, v]| {
            let (u, v) = (first + u, second + v);
            V3::new(u + v * cosine, v * sine, z)
        })
    }

    pub fn lid(&self) -> Quad {
        quad(self.ring(true))
    }

    pub fn base(&self) -> Quad {
        reversed(quad(self.ring(false)))
    }

    /// Walls −Y, +X, +Y, −X, facing outwards.
    pub fn walls(&self) -> [Quad; 4] {
        let (up, low) = (self.ring(true), self.ring(false));
        [0, 1, 2, 3].map(|i| {
            let next = (i + 1) % 4;
            quad([low[i], low[next], up[next], up[i]])
        })
    }
}

/// A whole face.
pub(super) fn quad(corners: [V3; 4]) -> Quad {
    Quad { corners, trim: Trim::Whole }
}

/// The same face seen from the other side.
pub(super) fn reversed(face: Quad) -> Quad {
    let [a, b, c, d] = face.corners;
    Quad { corners: [d, c, b, a], ..face }
}
