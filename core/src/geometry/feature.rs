//! Any kind of surface, edge or corner.

use super::{Circle, LobedWall, Path, Quad, Segment, V3, Wall, point};

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
    /// Sphere, by its centre and its radius in mm; a corner where that is 0.
    Ball(V3, f64),
}

impl Feature {
    /// Whether it is surely farther from a point than `limit`, mm, where that is told sooner than its nearest place.
    pub fn is_beyond(&self, p: &V3, limit: f64) -> bool {
        matches!(self, Feature::Lobed(wall) if wall.at_least(p) > limit)
    }
}

/// Nearest point of the feature; none where it has no perpendicular towards `p` (its border is a feature of its own).
pub fn foot(feature: &Feature, p: &V3) -> Option<V3> {
    match feature {
        Feature::Quad(quad) => quad.foot(p),
        Feature::Wall(wall) => wall.foot(p),
        Feature::Lobed(wall) => Some(wall.foot(p)),
        Feature::Circle(circle) => Some(circle.foot(p)),
        Feature::Segment(segment) => segment.foot(p),
        Feature::Ball(centre, size) => Some(centre + (p - centre).try_normalize(0.0).unwrap_or_else(V3::z) * *size),
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
        Feature::Ball(centre, size) => point::first(centre, path, size + radius),
    }
}
