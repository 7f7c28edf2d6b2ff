//! Ball against a corner point; with its radius added, against another ball.

use super::{Path, V3, roots};

/// Length after which a ball of this radius begins to touch the corner.
pub fn first(corner: &V3, path: &Path, radius: f64) -> Option<f64> {
    let away = path.from - corner;
    let closest = -away.dot(&path.direction);
    let gap = path.at(closest) - corner;
    let entering = *roots::quadratic(1.0, 0.0, gap.norm_squared() - radius * radius).first()? + closest;
    (entering > 0.0 && entering <= path.length).then_some(entering)
}
