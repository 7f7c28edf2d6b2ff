//! A ball against one triangle: its face, its edges, its corners.

use crate::geometry::point::entering;
use crate::geometry::{Path, TOLERANCE, V3, point};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    pub corners: [V3; 3],
    /// Unit normal, on the side from which the corners run counter-clockwise.
    pub normal: V3,
    /// Unit directions in the plane out of the triangle, across the edge behind each corner.
    across: [V3; 3],
}

/// Unit normal of a triangle; none where its corners lie on one line.
pub(super) fn normal([a, b, c]: &[V3; 3]) -> Option<V3> {
    (b - a).cross(&(c - a)).try_normalize(1e-18)
}

impl Face {
    /// None where the corners lie on one line.
    pub fn new(corners: [V3; 3]) -> Option<Face> {
        let normal = normal(&corners)?;
        let [a, b, c] = &corners;
        let across = [b - a, c - b, a - c].map(|edge| edge.cross(&normal).normalize());
        Some(Face { corners, normal, across })
    }

    /// Nearest point of the triangle, if within `limit` mm.
    pub fn foot(&self, p: &V3, limit: f64) -> Option<V3> {
        let above = (p - self.corners[0]).dot(&self.normal);
        let below = p - self.normal * above;
        let outside = self.outside(&below);
        if outside <= BORDER {
            return (above.abs() <= limit).then_some(below);
        }
        let limit = limit * limit;
        if above * above + outside * outside > limit + SLACK {
            return None;
        }
        let feet = self.edges().map(|(a, b)| on_edge(&a, &b, p));
        let away = |foot: &V3| (p - foot).norm_squared();
        let nearest = feet.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(&nearest) <= limit).then_some(nearest)
    }

    /// Height of the triangle straight above or below a point.
    pub fn height_at(&self, p: &V3) -> Option<f64> {
        if self.normal.z.abs() <= 1e-12 {
            return None;
        }
        let corner = self.corners[0];
        let height = corner.z - (p - corner).xy().dot(&self.normal.xy()) / self.normal.z;
        (self.outside(&V3::new(p.x, p.y, height)) <= BORDER).then_some(height)
    }

    /// Length, at most `limit`, after which a ball of this radius that was free begins to touch the triangle. Its face
    /// counts before its edges: where the ball meets the face it cannot have met the border before. Nothing of the
    /// triangle is met before its plane, and nothing that does not lie ahead of the ball's centre.
    pub fn first(&self, path: &Path, radius: f64, limit: f64) -> Option<f64> {
        let [a, b, c] = self.corners.map(|corner| (corner - path.from).dot(&path.direction));
        if a.max(b).max(c) <= 0.0 || a.min(b).min(c) - radius > limit {
            return None;
        }
        let above = (path.from - self.corners[0]).dot(&self.normal);
        let side = if above < 0.0 { -1.0 } else { 1.0 };
        let closing = -side * path.direction.dot(&self.normal);
        let gap = above.abs() - radius;
        let reached = if gap > 0.0 { gap / closing } else { 0.0 };
        if gap > 0.0 && (closing <= 1e-14 || reached > limit) {
            return None;
        }
        let distance = above.abs() - closing * reached;
        let below = path.at(reached) - self.normal * (side * distance);
        let outside = self.outside(&below);
        if gap > 0.0 && outside <= BORDER {
            return Some(reached);
        }
        if outside > widest(distance, closing, limit - reached, radius) {
            return None;
        }
        let edges = self.edges().map(|edge| at_edge(edge, path, radius, limit));
        let ahead = Path { length: limit, ..*path };
        let corners = self.corners.map(|corner| point::first(&corner, &ahead, radius));
        edges.into_iter().chain(corners).flatten().min_by(f64::total_cmp)
    }

    fn edges(&self) -> [(V3, V3); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
    }

    /// How far a point of the plane lies outside of its farthest edge, mm: at most its distance, inside less than 0.
    fn outside(&self, p: &V3) -> f64 {
        let past = |place: usize| (p - self.corners[place]).dot(&self.across[place]);
        past(0).max(past(1)).max(past(2))
    }
}

/// Points that lie outside of an edge by less lie on it, mm: rounding leaves no gap between neighbours.
const BORDER: f64 = 1e-12;
/// What rounding may add to the square of a distance, mm².
const SLACK: f64 = 1e-12;

/// Distance from its foot on a plane within which a ball touches the plane on the next `way` mm. It stands at this
/// distance from the plane and comes nearer by `closing` a mm; as the foot moves along, so does what it touches.
fn widest(distance: f64, closing: f64, way: f64, radius: f64) -> f64 {
    let nearest = (distance - closing.max(0.0) * way).max(0.0);
    let circle = (radius * radius - nearest * nearest).max(0.0).sqrt();
    let drift = way * (1.0 - closing * closing).max(0.0).sqrt();
    circle + drift + TOLERANCE
}

fn on_edge(a: &V3, b: &V3, p: &V3) -> V3 {
    let edge = b - a;
    let part = (p - a).dot(&edge) / edge.norm_squared();
    a + edge * part.clamp(0.0, 1.0)
}

/// First contact with an edge without its ends.
fn at_edge((a, b): (V3, V3), path: &Path, radius: f64, limit: f64) -> Option<f64> {
    let edge = b - a;
    let size = edge.norm_squared();
    let along = path.direction.dot(&edge) / size;
    let away = path.from - a;
    let start = away.dot(&edge) / size;
    let way = path.direction - edge * along;
    let length = entering(&(away - edge * start), &way, radius, limit)?;
    (0.0..=1.0).contains(&(start + along * length)).then_some(length)
}
