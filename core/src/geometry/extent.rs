//! Boxes along the axes, so that what is far away need not be looked at.

use super::{Feature, LobedWall, TOLERANCE, V3};

/// From the least to the greatest coordinates of something, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Least coordinates.
    pub low: V3,
    /// Greatest coordinates.
    pub high: V3,
}

/// That of nothing.
impl Default for Extent {
    fn default() -> Extent {
        Extent { low: V3::repeat(f64::INFINITY), high: V3::repeat(f64::NEG_INFINITY) }
    }
}

impl Extent {
    /// Of points.
    pub fn of(points: impl IntoIterator<Item = V3>) -> Extent {
        points.into_iter().fold(Extent::default(), |extent, point| Extent {
            low: extent.low.inf(&point),
            high: extent.high.sup(&point),
        })
    }

    /// Of a piece of a boundary.
    pub fn around(feature: &Feature) -> Extent {
        let upright = |radius: f64, low: f64, high: f64| {
            Extent::of([V3::new(-radius, -radius, low), V3::new(radius, radius, high)])
        };
        match feature {
            Feature::Quad(quad) => Extent::of(quad.corners),
            Feature::Wall(wall) => upright(wall.lobes().widest(wall.depth), -wall.depth, 0.0),
            Feature::Lobed(LobedWall { lobes, depth }) => upright(lobes.widest(*depth), -depth, 0.0),
            Feature::Circle(circle) => upright(circle.radius, circle.z, circle.z),
            Feature::Segment(segment) => Extent::of([segment.a, segment.b]),
            Feature::Ball(centre, radius) => Extent::of([*centre]).wider(*radius),
        }
    }

    /// Both.
    pub fn with(&self, other: &Extent) -> Extent {
        Extent { low: self.low.inf(&other.low), high: self.high.sup(&other.high) }
    }

    /// Wider by so much on each side, mm.
    pub fn wider(&self, by: f64) -> Extent {
        Extent { low: self.low.add_scalar(-by), high: self.high.add_scalar(by) }
    }

    /// Distance of a point, mm; 0 within.
    pub fn distance(&self, p: &V3) -> f64 {
        (p - p.sup(&self.low).inf(&self.high)).norm()
    }

    /// Whether both have something in common, or nearly.
    pub fn meets(&self, other: &Extent) -> bool {
        (0..3).all(|axis| {
            self.low[axis] <= other.high[axis] + TOLERANCE && self.high[axis] >= other.low[axis] - TOLERANCE
        })
    }
}
