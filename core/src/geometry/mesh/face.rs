//! A ball against one triangle: its face, its edges, its corners.

use crate::geometry::{Path, V3};

/// Unit normal, on the side from which the corners run counter-clockwise; none where they lie on one line.
pub(super) fn normal([a, b, c]: &[V3; 3]) -> Option<V3> {
    (b - a).cross(&(c - a)).try_normalize(1e-18)
}

/// Nearest point of the triangle.
pub(super) fn foot(corners: &[V3; 3], p: &V3) -> V3 {
    if let Some(normal) = normal(corners) {
        let below = p - normal * (p - corners[0]).dot(&normal);
        if covers(corners, &below, &normal) {
            return below;
        }
    }
    let mut nearest = (corners[0], f64::INFINITY);
    for (a, b) in edges(corners) {
        let foot = on_edge(&a, &b, p);
        let distance = (p - foot).norm_squared();
        if distance < nearest.1 {
            nearest = (foot, distance);
        }
    }
    nearest.0
}

/// Height of the triangle straight above or below a point.
pub(super) fn height_at(corners: &[V3; 3], p: &V3) -> Option<f64> {
    let normal = normal(corners).filter(|normal| normal.z.abs() > 1e-12)?;
    let height = corners[0].z - (p - corners[0]).xy().dot(&normal.xy()) / normal.z;
    covers(corners, &V3::new(p.x, p.y, height), &normal).then_some(height)
}

/// Length after which a ball of this radius that was free begins to touch the triangle. Its face counts before its
/// edges: where the ball meets the face it cannot have met the border before.
pub(super) fn first(corners: &[V3; 3], path: &Path, radius: f64) -> Option<f64> {
    let outside = normal(corners)?;
    let above = (path.from - corners[0]).dot(&outside);
    let (normal, above) = if above < 0.0 {
        (-outside, -above)
    } else {
        (outside, above)
    };
    let closing = -path.direction.dot(&normal);
    let gap = above - radius;
    if gap > 0.0 {
        if closing <= 1e-14 || gap > closing * path.length {
            return None;
        }
        let reached = gap / closing;
        if covers(corners, &(path.at(reached) - normal * radius), &normal) {
            return Some(reached);
        }
    }
    edges(corners)
        .into_iter()
        .filter_map(|(a, b)| at_edge(&a, &b, path, radius))
        .min_by(f64::total_cmp)
}

fn edges([a, b, c]: &[V3; 3]) -> [(V3, V3); 3] {
    [(*a, *b), (*b, *c), (*c, *a)]
}

/// Whether a point of the plane lies in the triangle; the normal may be that of either side.
fn covers([a, b, c]: &[V3; 3], p: &V3, normal: &V3) -> bool {
    let side = |a: &V3, b: &V3| (b - a).cross(&(p - a)).dot(normal);
    let sides = [side(a, b), side(b, c), side(c, a)];
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}

fn on_edge(a: &V3, b: &V3, p: &V3) -> V3 {
    let edge = b - a;
    let part = (p - a).dot(&edge) / edge.norm_squared();
    a + edge * part.clamp(0.0, 1.0)
}

/// First contact with an edge and its two ends.
fn at_edge(a: &V3, b: &V3, path: &Path, radius: f64) -> Option<f64> {
    let edge = b - a;
    let size = edge.norm_squared();
    let along = path.direction.dot(&edge) / size;
    let away = path.from - a;
    let start = away.dot(&edge) / size;
    let way = path.direction - edge * along;
    let from = away - edge * start;
    if let Some(length) = entering(&from, &way, radius, path.length) {
        let part = start + along * length;
        if (0.0..=1.0).contains(&part) {
            return Some(length);
        }
    }
    let ends = [a, b].map(|end| entering(&(path.from - end), &path.direction, radius, path.length));
    ends.into_iter().flatten().min_by(f64::total_cmp)
}

/// When a point at `from` that moves by `way` a mm comes within `radius` of the origin.
fn entering(from: &V3, way: &V3, radius: f64, length: f64) -> Option<f64> {
    let speed = way.norm_squared();
    if speed < 1e-24 {
        return None;
    }
    let closest = -from.dot(way) / speed;
    let gap = (from + way * closest).norm_squared();
    let half = (radius * radius - gap) / speed;
    if half < 0.0 {
        return None;
    }
    let entering = closest - half.sqrt();
    (entering > 0.0 && entering <= length).then_some(entering)
}
