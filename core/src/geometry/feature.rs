//! Any kind of surface, edge or corner.

use super::circle::Circle;
use super::lobed::LobedWall;
use super::quad::Quad;
use super::segment::Segment;
use super::wall::Wall;
use super::{Path, V3, point};

/// A piece of the boundary of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feature {
    /// Flat face.
    Quad(Quad),
    /// Cylinder or cone.
    Wall(Wall),
    /// Wall that is out of round, with its rims.
    Lobed(LobedWall),
    /// Circular edge.
    Circle(Circle),
    /// Straight edge.
    Segment(Segment),
    /// Corner.
    Point(V3),
    /// Sphere about the origin, by its radius in mm.
    Sphere(f64),
}

impl Feature {
    /// Whether it is surely farther from a point than `limit`, mm, where that is told sooner than the place of it that
    /// is nearest.
    pub fn is_beyond(&self, p: &V3, limit: f64) -> bool {
        matches!(self, Feature::Lobed(wall) if wall.at_least(p) > limit)
    }
}

/// A ball of space that holds a whole feature, so that what is far away need not be looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    centre: [f64; 3],
    radius: f64,
}

impl Bound {
    /// The one around a feature.
    pub fn around(feature: &Feature) -> Bound {
        let upright =
            |z: f64, height: f64, radius: f64| Bound { centre: [0.0, 0.0, z], radius: radius.hypot(height / 2.0) };
        let widest = |radius: f64, slope: f64, depth: f64| radius + (slope * depth).max(0.0);
        match feature {
            Feature::Quad(quad) => Bound::of(&quad.corners),
            Feature::Wall(wall) => {
                let widest = widest(wall.radius, wall.slope, wall.depth);
                upright(-wall.depth / 2.0, wall.depth, widest)
            }
            Feature::Lobed(LobedWall { lobes, depth }) => {
                let widest = widest(lobes.radius, lobes.slope, *depth) + lobes.amplitude.abs();
                upright(-depth / 2.0, *depth, widest)
            }
            Feature::Circle(circle) => upright(circle.z, 0.0, circle.radius),
            Feature::Segment(segment) => Bound::of(&[segment.a, segment.b]),
            Feature::Point(corner) => Bound::of(&[*corner]),
            Feature::Sphere(size) => upright(0.0, 0.0, *size),
        }
    }

    fn of(points: &[V3]) -> Bound {
        let centre = points.iter().sum::<V3>() / points.len() as f64;
        let away = points.iter().map(|point| (point - centre).norm());
        Bound { centre: centre.into(), radius: away.fold(0.0, f64::max) }
    }

    /// Least distance that a point can have from the feature, mm; negative within the bound.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|i| p[i] - self.centre[i]);
        (x * x + y * y + z * z).sqrt() - self.radius
    }

    /// The same of the nearest point of a way.
    pub fn distance_of_way(&self, path: &Path) -> f64 {
        let (from, way): ([f64; 3], [f64; 3]) = (path.from.into(), path.direction.into());
        let gone: f64 = (0..3).map(|i| (self.centre[i] - from[i]) * way[i]).sum();
        let gone = gone.clamp(0.0, path.length);
        self.distance([0, 1, 2].map(|i| from[i] + gone * way[i]))
    }
}

/// The point of a feature nearest to a given point.
pub type Foot = V3;

/// Nearest point of the feature; none where it has no perpendicular towards `p` (its border is a feature of its own).
pub fn foot(feature: &Feature, p: &V3) -> Option<Foot> {
    match feature {
        Feature::Quad(quad) => quad.foot(p),
        Feature::Wall(wall) => wall.foot(p),
        Feature::Lobed(wall) => Some(wall.foot(p)),
        Feature::Circle(circle) => Some(circle.foot(p)),
        Feature::Segment(segment) => segment.foot(p),
        Feature::Point(corner) => Some(*corner),
        Feature::Sphere(size) => Some(p.try_normalize(0.0).unwrap_or_else(V3::z) * *size),
    }
}

/// Length, mm, after which a ball that was free begins to touch the feature; none: not on this path.
pub fn first(feature: &Feature, path: &Path, radius: f64) -> Option<f64> {
    match feature {
        Feature::Quad(quad) => quad.first(path, radius),
        Feature::Wall(wall) => wall.first(path, radius),
        Feature::Lobed(wall) => wall.first(path, radius),
        Feature::Circle(circle) => circle.first(path, radius),
        Feature::Segment(segment) => segment.first(path, radius),
        Feature::Point(corner) => point::first(corner, path, radius),
        Feature::Sphere(size) => point::first(&V3::zeros(), path, size + radius),
    }
}
