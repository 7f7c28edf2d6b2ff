//! Ball against a corner point; with its radius added, against another ball.

use super::{Path, V3};

/// Length after which a ball of this radius begins to touch the corner.
pub fn first(corner: &V3, path: &Path, radius: f64) -> Option<f64> {
    entering(&(path.from - corner), &path.direction, radius, path.length)
}

/// When a point at `from` that moves by `way` a mm comes within `radius` of the origin, if within `limit` mm.
pub fn entering(from: &V3, way: &V3, radius: f64, limit: f64) -> Option<f64> {
    let ahead = -from.dot(way);
    let speed = way.norm_squared();
    if ahead <= 0.0 || speed < 1e-24 {
        return None;
    }
    let closest = ahead / speed;
    let gap = (from + way * closest).norm_squared();
    let half = (radius * radius - gap) / speed;
    if half < 0.0 {
        return None;
    }
    let entering = closest - half.sqrt();
    (entering > 0.0 && entering <= limit).then_some(entering)
}
